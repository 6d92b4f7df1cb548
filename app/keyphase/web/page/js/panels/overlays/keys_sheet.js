/** The sheet of keys, from the same list that the keys obey. */

import { byId, el } from "../../lib/dom.js";

const GESTURES = [
  ["Zoom", "wheel"],
  ["Move through time", "drag the tracks"],
  ["Scroll the tracks", "Alt wheel"],
  ["Move without snapping", "Alt drag"],
  ["Move a boundary and all later ones", "Shift drag"],
  ["Merge", "drag over segments"],
  ["Choose several", "Shift click"],
  ["Rename", "double click"],
  ["Repeat in the plan", "Ctrl drag a chip"],
  ["Everything else", "right click"],
];

/** @param {() => import("../../actions/keys/commands.js").Command[]} commands */
export function createKeysSheet(commands) {
  const dialog = /** @type {HTMLDialogElement} */ (byId("keys"));
  dialog.addEventListener("click", ({ target }) => target === dialog && dialog.close());
  const line = (name, keys) =>
    el(
      "div",
      { class: "line" },
      el("span", { text: name }),
      ...keys.map((key) => el("kbd", { text: key })),
    );
  return {
    open() {
      if (dialog.open) return;
      const withKeys = commands().filter(({ keys }) => keys.length);
      const groups = [...new Set(withKeys.map(({ group }) => group))];
      const sections = groups.map((group) =>
        el(
          "section",
          {},
          el("h3", { text: group }),
          ...withKeys
            .filter((command) => command.group === group)
            .map(({ name, keys }) => line(name, keys)),
        ),
      );
      const pointer = el(
        "section",
        {},
        el("h3", { text: "Pointer" }),
        ...GESTURES.map(([name, how]) => line(name, [how])),
      );
      dialog.replaceChildren(
        el("h2", { text: "Keys" }),
        el("div", { class: "columns" }, ...sections, pointer),
        el("p", {
          class: "foot",
          text: "W A S D Q E and the arrow keys move the camera of the scene. Esc gives up what is open or being dragged.",
        }),
      );
      dialog.showModal();
    },
  };
}
