/** Asks before a file is replaced that keyphase did not write, or that was changed since. */

import { byId, el } from "../../lib/dom.js";
import { plural } from "../../lib/format.js";

/**
 * @param {import("../../lib/store.js").Store} store
 * @param {any} actions
 */
export function createInTheWay(store, actions) {
  const dialog = /** @type {HTMLDialogElement} */ (byId("in-the-way"));
  const title = el("h2", {});
  const rows = el("div", { class: "spread-rows", tabindex: "0" });
  const answer = (text, ifThere) =>
    el("button", {
      type: "button",
      class: "button",
      text,
      on: {
        click() {
          const { inTheWay } = store.state;
          dialog.close();
          if (inTheWay && ifThere) actions.exportAgain(inTheWay, ifThere);
        },
      },
    });
  const keepBoth = answer("Keep both", "keep both");
  keepBoth.classList.add("primary");
  dialog.append(
    title,
    rows,
    el("div", { class: "buttons" }, keepBoth, answer("Replace", "replace"), answer("Cancel", "")),
  );
  dialog.addEventListener("close", () => store.set({ inTheWay: null }));

  store.on(["inTheWay"], ({ inTheWay }) => {
    if (!inTheWay) return dialog.open && dialog.close();
    const { files } = inTheWay;
    title.textContent =
      files.length === 1
        ? "A file is in the way"
        : `${plural(files.length, "file")} are in the way`;
    rows.replaceChildren(
      ...files.map(({ name, whose }) =>
        el(
          "div",
          { class: "in-the-way-row" },
          el("b", { text: name }),
          el("span", { text: `${whose}.` }),
        ),
      ),
    );
    if (!dialog.open) dialog.showModal();
    return keepBoth.focus();
  });
}
