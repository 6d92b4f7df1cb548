/** What holds boundaries back whatever the lines, and lets them go at a press. */

import { el } from "../../lib/dom.js";
import { FILTERS } from "../../model/evidence.js";

/**
 * @param {HTMLElement} plot beside which they stand
 * @param {any} actions
 * @returns {(state: import("../../lib/store.js").State) => void} draws what there is
 */
export function createHeldBack(plot, actions) {
  const node = el("div", { class: "held-back" });
  plot.after(node);
  let told = null;
  return ({ document: doc, readOnly, folded }) => {
    node.hidden = folded.has("evidence");
    const now = doc?.held_back ?? [];
    if (now === told) return;
    told = now;
    node.replaceChildren(
      ...now.map(({ parameter, count, free }) =>
        el("button", {
          type: "button",
          class: "link",
          disabled: readOnly,
          data: { release: parameter },
          title: `${count} more would be found without ${FILTERS[parameter]}.`,
          text: `${count} held by ${FILTERS[parameter]}: release?`,
          on: { click: () => actions.setParameter(parameter, free, false) },
        }),
      ),
    );
  };
}
