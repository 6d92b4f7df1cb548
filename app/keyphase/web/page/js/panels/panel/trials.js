/** Trials: the plan in many worlds at once, how far they are, and what came of them. */

import { el } from "../../lib/dom.js";
import { showTrialsPicture } from "../overlays/trials_picture.js";
import { button, group, slider } from "./fields.js";

const FEWEST = 10;
const MOST = 200;

/**
 * @param {import("../../lib/store.js").Store} store
 * @param {any} actions
 */
export function createTrials(store, actions) {
  let count = 20;
  const worlds = slider({
    title: "Worlds",
    hint:
      "Each with parts up to 10 mm higher or lower and 5 mm aside, friction 0.2 to 0.6 and twice " +
      "the sensor noise.",
    low: FEWEST,
    high: MOST,
    step: 1,
    share: (value) => (value - FEWEST) / (MOST - FEWEST),
    value: (share) => Math.round((FEWEST + share * (MOST - FEWEST)) / 10) * 10,
    told: (value) => (count = value ?? count),
  });
  worlds.show(count);
  const run = button("Run trials", { run: () => actions.trials(count) });
  const cancel = button("Cancel", { run: actions.cancelTrials });
  const far = el("i");
  const progress = el("div", { class: "meter", role: "progressbar", "aria-label": "Trials" }, far);
  const words = el("p", { class: "hint", role: "status" });
  const picture = /** @type {HTMLImageElement} */ (el("img", { alt: "" }));
  store.later(["trials", "document", "lookingOnly"], ({ trials, document: doc, lookingOnly }) => {
    const running = Boolean(trials && !trials.over);
    run.hidden = running;
    run.disabled = lookingOnly || !doc;
    cancel.hidden = progress.hidden = !running;
    enlarge.hidden = !trials?.svg;
    words.textContent = trials
      ? running
        ? `${trials.done} of ${trials.count} worlds`
        : trials.outcome
      : "";
    if (running) {
      far.style.setProperty("width", `${(100 * trials.done) / trials.count}%`);
      progress.setAttribute("aria-valuenow", String(trials.done));
      progress.setAttribute("aria-valuemax", String(trials.count));
    }
    if (!trials?.svg || picture.alt === `${trials.title}: ${trials.outcome}`) return;
    // As the source of an image a picture can run nothing.
    picture.src = `data:image/svg+xml;charset=utf-8,${encodeURIComponent(trials.svg)}`;
    picture.alt = `${trials.title}: ${trials.outcome}`;
  });
  const enlarge = el(
    "button",
    {
      type: "button",
      class: "trials-picture",
      title: "Larger",
      on: { click: () => showTrialsPicture(picture.src, picture.alt) },
    },
    picture,
  );
  return group("Trials", { open: true }, worlds.node, run, progress, cancel, words, enlarge);
}
