/** The elements of the timeline: layers below and above the tracks, and what is drawn in each. */

import { el, svg } from "../../lib/dom.js";
import { hatches } from "../breaks.js";

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
    cameras: svg("g", { class: "film-strip" }),
    breaks: svg("g"),
    boundaries: svg("g"),
    ghosts: svg("g"),
    overviewCurve: svg("g"),
    overviewWindow: svg("g"),
    ...laneGroups(),
    comparison: svg("g", { class: "comparison" }),
    pointer: svg("path", { class: "pointer-line" }),
    playhead: svg("g", { class: "playhead" }),
    overviewPlayhead: svg("rect", { class: "overview-playhead", width: 1.5 }),
  };
  below.append(hatches(), groups.intervals);
  above.append(
    groups.overviewCurve,
    groups.overview,
    groups.overviewWindow,
    groups.overviewPlayhead,
    groups.ruler,
    groups.lanes,
    groups.events,
    groups.comparison,
    groups.cameras,
    groups.pointer,
    groups.band,
    groups.breaks,
    groups.boundaries,
    groups.ghosts,
    groups.playhead,
  );
  const surface = el("div", { class: "surface", tabindex: "-1" });
  scroller.append(content);
  pane.append(below, scroller, above, surface);
  return { groups, scroller, content, surface };
}

/** What stands below the segments. */
const laneGroups = () => ({
  lanes: svg("g", { class: "lanes" }),
  events: svg("g", { class: "events" }),
});

/** @param {string} name */
function layer(name) {
  return svg("svg", { class: `layer ${name}` });
}
