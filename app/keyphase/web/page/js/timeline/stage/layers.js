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
    ruler: svg("g"),
    band: svg("g"),
    breaks: svg("g"),
    boundaries: svg("g"),
    ghosts: svg("g"),
    ...overviewGroups(),
    ...overSegments(),
    ...laneGroups(),
    comparison: svg("g", { class: "comparison" }),
    pointer: svg("path", { class: "pointer-line" }),
    playhead: svg("g", { class: "playhead" }),
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
    groups.skills,
    groups.band,
    groups.naming,
    groups.breaks,
    groups.boundaries,
    groups.runs,
    groups.ghosts,
    groups.playhead,
  );
  const surface = el("div", { class: "surface", tabindex: "-1" });
  scroller.append(content);
  pane.append(below, scroller, above, surface);
  return { groups, scroller, content, surface };
}

/** The whole recording in small. */
const overviewGroups = () => ({
  overview: svg("g"),
  overviewCurve: svg("g"),
  overviewWindow: svg("g"),
  overviewPlayhead: svg("rect", { class: "overview-playhead", width: 1.5 }),
});

/** What stands above the segments and over them. */
const overSegments = () => ({
  naming: svg("g"),
  runs: svg("g"),
  skills: svg("g", { class: "skills" }),
});

/** What stands below the segments. */
const laneGroups = () => ({
  lanes: svg("g", { class: "lanes" }),
  events: svg("g", { class: "events" }),
  cameras: svg("g", { class: "film-strip" }),
});

/** @param {string} name */
function layer(name) {
  return svg("svg", { class: `layer ${name}` });
}
