/** The elements of the timeline: layers below and above the tracks, and what is drawn in each. */

import { el, svg } from "../../lib/dom.js";

/**
 * @typedef {ReturnType<typeof createLayers>} Layers
 * @param {HTMLElement} pane
 */
export function createLayers(pane) {
  const below = layer("below");
  const scroller = el("div", { class: "tracks" });
  const content = el("div", { class: "tracks-content" });
  const above = layer("above");
  const groups = {
    intervals: svg("g"),
    overview: svg("g"),
    ruler: svg("g"),
    band: svg("g"),
    boundaries: svg("g"),
    ghosts: svg("g"),
    overviewCurve: svg("g"),
    overviewWindow: svg("g"),
    comparison: svg("g", { class: "comparison" }),
    pointer: svg("path", { class: "pointer-line" }),
    playhead: svg("g", { class: "playhead" }),
    overviewPlayhead: svg("rect", { class: "overview-playhead", width: 1.5 }),
  };
  below.append(svg("defs", {}, hatch()), groups.intervals);
  above.append(
    groups.overviewCurve,
    groups.overview,
    groups.overviewWindow,
    groups.overviewPlayhead,
    groups.ruler,
    groups.comparison,
    groups.pointer,
    groups.band,
    groups.boundaries,
    groups.ghosts,
    groups.playhead,
  );
  const surface = el("div", { class: "surface", tabindex: "-1" });
  scroller.append(content);
  pane.append(below, scroller, above, surface);
  return { groups, scroller, content, surface };
}

/** @param {string} name */
function layer(name) {
  return svg("svg", { class: `layer ${name}` });
}

/** The hatch of dropped segments. */
function hatch() {
  return svg(
    "pattern",
    {
      id: "hatch",
      width: 6,
      height: 6,
      patternUnits: "userSpaceOnUse",
      patternTransform: "rotate(45)",
    },
    svg("rect", { width: 6, height: 6, style: { fill: "var(--hatch)" } }),
    svg("rect", { width: 2.2, height: 6, style: { fill: "var(--hatch-line)" } }),
  );
}
