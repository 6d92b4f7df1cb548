/** What runs beside a replay for long: a button, how far it is, what came of it, its picture. */

import { el } from "../../lib/dom.js";
import { showPicture } from "../overlays/picture.js";
import { button, group } from "./fields.js";

/**
 * @param {import("../../lib/store.js").Store} store
 * @param {{title: string, key: "trials"|"margin", start: string, hint: string, before?: Node[],
 *   begin: () => void, cancel: () => void, far: (run: {done: number, count: number}) => string}} given
 */
export function createBeside(store, { title, key, start, hint, before = [], begin, cancel, far }) {
  const run = button(start, { run: begin, hint });
  const giveUp = button("Cancel", { run: cancel });
  const bar = el("i");
  const progress = el("div", { class: "meter", role: "progressbar", "aria-label": title }, bar);
  const words = el("p", { class: "hint", role: "status" });
  const picture = /** @type {HTMLImageElement} */ (el("img", { alt: "" }));
  const enlarge = el(
    "button",
    {
      type: "button",
      class: "beside-picture",
      title: "Larger",
      on: { click: () => showPicture(title, picture.src, picture.alt) },
    },
    picture,
  );
  store.later([key, "document", "lookingOnly", "greeted"], (state) => {
    const { document: doc, lookingOnly } = state;
    const now = state[key];
    const running = Boolean(now && !now.over);
    run.hidden = running;
    run.disabled = lookingOnly || !doc;
    giveUp.hidden = progress.hidden = !running;
    enlarge.hidden = !now?.svg;
    words.textContent = now ? (running ? far(now) : now.outcome) : "";
    if (running) {
      bar.style.setProperty("width", `${(100 * now.done) / now.count}%`);
      progress.setAttribute("aria-valuenow", String(now.done));
      progress.setAttribute("aria-valuemax", String(now.count));
    }
    if (!now?.svg || picture.alt === `${now.title}: ${now.outcome}`) return;
    // As the source of an image a picture can run nothing.
    picture.src = `data:image/svg+xml;charset=utf-8,${encodeURIComponent(now.svg)}`;
    picture.alt = `${now.title}: ${now.outcome}`;
  });
  return group(title, { open: true }, ...before, run, progress, giveUp, words, enlarge);
}
