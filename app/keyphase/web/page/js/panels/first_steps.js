/** The first minute with the demonstration: four steps that tick themselves. */

import { byId, el, icon } from "../lib/dom.js";

/**
 * What is done, and how one knows that it was.
 * @type {[string, (state: import("../lib/store.js").State) => boolean][]}
 */
const STEPS = [
  [
    "Drag a boundary, or a dashed line",
    ({ document: doc }) =>
      doc.boundaries.some(({ was_s: was, origin }) => was !== null || origin === "user") ||
      ["force_threshold", "motion_threshold"].some((name) => doc.parameters[name] != null),
  ],
  [
    "Click a segment, L names it",
    ({ document: doc }) => doc.segments.some(({ proposed }) => !proposed),
  ],
  ["P replays it on the robot", ({ replay }) => replay !== null],
  ["Ctrl S writes the segment file", ({ saved }) => saved !== null],
];

/** @param {import("../lib/store.js").Store} store */
export function createFirstSteps(store) {
  const node = byId("first-steps");
  const close = el(
    "button",
    {
      type: "button",
      class: "tool",
      title: "Close",
      "aria-label": "Close the first steps",
      on: { click: () => store.set({ firstSteps: false }) },
    },
    icon("close", "small"),
  );
  const lines = STEPS.map(([text]) => el("li", { text }));
  node.append(el("header", {}, el("b", { text: "First steps" }), close), el("ol", {}, ...lines));
  store.later(["firstSteps", "document", "replay", "saved"], (state) => {
    const { firstSteps, document: doc, replay } = state;
    node.hidden = !firstSteps || !doc || replay !== null;
    if (!firstSteps || !doc) return;
    STEPS.forEach(([, isDone], k) => lines[k].classList.contains("done") || tick(k, isDone(state)));
  });

  function tick(k, done) {
    if (!done) return;
    lines[k].classList.add("done");
    lines[k].setAttribute("aria-label", `Done: ${STEPS[k][0]}`);
  }
}
