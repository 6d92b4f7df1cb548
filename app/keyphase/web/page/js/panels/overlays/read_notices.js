/**
 * What was done to a recording on reading it: a count beside its facts that opens the list. Amber
 * where data was left out, held or mended.
 */

import { byId, el } from "../../lib/dom.js";
import { plural } from "../../lib/format.js";

const DOUBTFUL = new RegExp(
  [
    "dropp|left out|held|repeats its|mend|damag|torn|skip|cut|missing|not be written|repair",
    "interpol|resampl|duplicate|without data|gap|jump|turns by|0 0 0|never change|at its limit",
    "wander|helps|read as|no line end",
  ].join("|"),
  "i",
);

/** @param {import("../../lib/store.js").Store} store */
export function createReadNotices(store) {
  const button = byId("read-notices");
  const dialog = /** @type {HTMLDialogElement} */ (byId("read-notices-list"));
  button.addEventListener("click", () => {
    const { notices, name } = store.state.document;
    dialog.replaceChildren(
      el("h2", { text: `On reading ${name}` }),
      el(
        "ul",
        {},
        ...notices.map((text) => el("li", { class: isDoubtful(text) ? "low" : "", text })),
      ),
      el("button", {
        type: "button",
        class: "button",
        text: "Close",
        on: { click: () => dialog.close() },
      }),
    );
    dialog.showModal();
  });
  dialog.addEventListener("click", ({ target }) => target === dialog && dialog.close());
  store.later(["document"], ({ document: doc }) => {
    const count = doc?.notices.length ?? 0;
    button.hidden = !count;
    if (!count) return;
    byId("read-notices-count").textContent = String(count);
    button.classList.toggle("low", doc.notices.some(isDoubtful));
    button.title = `${plural(count, "note")} on how it was read`;
    button.setAttribute("aria-label", button.title);
  });
}

/** Whether a note says that the data is not all there as it was recorded. @param {string} text */
export const isDoubtful = (text) => DOUBTFUL.test(text);
