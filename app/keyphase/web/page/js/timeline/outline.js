/**
 * The timeline for who does not see it: segments and boundaries as two lists, each one stop of the
 * Tab key, walked by the arrows. What is active there is what is selected in the drawing.
 */

import { el } from "../lib/dom.js";
import { chosenStretch } from "../model/segments.js";

/** As many are listed; more would take longer to make than to hear. */
const MOST = 500;
const STEPS = { ArrowRight: 1, ArrowDown: 1, ArrowLeft: -1, ArrowUp: -1 };

/**
 * @param {HTMLElement} pane
 * @param {import("../lib/store.js").Store} store
 * @param {{select: (index: number) => void, selectTo: (index: number) => void,
 *   visit: (index: number) => void}} actions
 * @param {{segment: (doc: import("../model/types.js").Doc, index: number) => string,
 *   boundary: (doc: import("../model/types.js").Doc, index: number) => string}} texts
 */
export function createOutline(pane, store, actions, texts) {
  const segments = list("Segments", "outline-segment", (index, draws) =>
    draws ? actions.selectTo(index) : actions.select(index),
  );
  const boundaries = list("Boundaries", "outline-boundary", (index) => actions.visit(index));
  pane.prepend(boundaries.node, segments.node);
  store.later(["document"], ({ document: doc }) => {
    segments.fill(doc ? doc.segments.slice(0, MOST).map((_, k) => texts.segment(doc, k)) : []);
    boundaries.fill(doc ? doc.boundaries.slice(0, MOST).map((_, k) => texts.boundary(doc, k)) : []);
  });
  segments.node.setAttribute("aria-multiselectable", "true");
  store.later(["selected", "selectedTo", "document"], (state) =>
    segments.choose(state.selectedTo ?? state.selected, chosenStretch(state) ?? undefined),
  );
  store.later(["current", "document"], ({ current }) => boundaries.choose(current));
}

function list(name, prefix, choose) {
  const node = el("div", { class: "outline", role: "listbox", "aria-label": name, tabindex: 0 });
  let at = /** @type {number|null} */ (null);
  let texts = [];
  node.addEventListener("keydown", (event) => {
    const step = STEPS[event.key];
    const last = texts.length - 1;
    const to =
      { Home: 0, End: last }[event.key] ??
      (step ? (at ?? (step > 0 ? -1 : last + 1)) + step : null);
    if (to === null || last < 0) return;
    event.preventDefault();
    event.stopPropagation();
    at = Math.min(Math.max(to, 0), last);
    choose(at, event.shiftKey);
  });
  return {
    node,
    fill(next) {
      if (next.join("\n") === texts.join("\n")) return;
      texts = next;
      node.replaceChildren(
        ...next.map((text, k) =>
          el("div", { role: "option", id: `${prefix}-${k}`, "aria-selected": "false", text }),
        ),
      );
    },
    /** One is active; those from first to last are selected. */
    choose(index, [first, last] = [index, index]) {
      for (const one of node.querySelectorAll("[aria-selected=true]"))
        one.setAttribute("aria-selected", "false");
      at = index !== null && node.children[index] ? index : null;
      if (at === null) return node.removeAttribute("aria-activedescendant");
      for (const one of [...node.children].slice(first, last + 1))
        one.setAttribute("aria-selected", "true");
      return node.setAttribute("aria-activedescendant", `${prefix}-${at}`);
    },
  };
}
