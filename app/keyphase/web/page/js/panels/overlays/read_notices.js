/**
 * What was done to a recording on reading it: a count beside its facts that opens the list. Amber
 * where data was left out, held or mended.
 */

import { byId, el } from "../../lib/dom.js";
import { plural } from "../../lib/format.js";

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
        ...notices.map((notice) =>
          el("li", { class: isWarning(notice) ? "low" : "", text: notice.text }),
        ),
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
    button.classList.toggle("low", doc.notices.some(isWarning));
    button.title = `${plural(count, "note")} on how it was read`;
    button.setAttribute("aria-label", button.title);
  });
}

/** @param {import("../../model/types.js").Doc["notices"][number]} notice */
const isWarning = ({ severity }) => severity === "warning";
