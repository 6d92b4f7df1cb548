/** What is drawn over and beside the tracks: each function draws one layer of it anew. */

import { withDrag } from "../../model/drag.js";
import { drawBand, drawNaming, drawRuns } from "../band.js";
import { drawBoundaries, drawGhosts, drawIntervals } from "../boundaries.js";
import { drawOthers } from "../others.js";
import { drawBreaks } from "../breaks.js";
import { drawComparison } from "../lanes/comparison.js";
import { drawLanes } from "../lanes/arms.js";
import { drawEvents } from "../lanes/events.js";
import { drawSkills } from "../lanes/skills.js";
import { drawOverviewCurve, drawOverviewStrip, drawWindow } from "../overview.js";
import { drawRuler } from "../ruler.js";

/**
 * @typedef {import("../../lib/store.js").State} State
 * @typedef {{groups: import("./layers.js").Layers["groups"], gutters: Map<string, any>,
 *   playhead: ReturnType<typeof import("../ruler.js").createPlayhead>,
 *   film: (state: State) => void, scale: () => import("../../lib/scale.js").Scale, bottom: () => number}} Stage
 */

/** @param {Stage} stage @param {State} plain */
export function drawSegments({ groups, gutters, scale, bottom }, plain) {
  const state = { ...plain, document: withDrag(plain.document, plain.drag) };
  const { layout } = state;
  const at = scale();
  groups.intervals.replaceChildren(...drawIntervals(state, at, layout, bottom()));
  const band = layout.rows.get("segments");
  groups.band.replaceChildren(...drawBand(state, at, band), ...drawOthers(state, at, band));
  groups.breaks.replaceChildren(...drawBreaks(state, at, layout, bottom()));
  groups.boundaries.replaceChildren(...drawBoundaries(state, at, layout, bottom()));
  groups.runs.replaceChildren(...drawRuns(state, at, band));
  groups.ghosts.replaceChildren(...drawGhosts(state, at, layout, bottom()));
  const skills = layout.rows.get("skills");
  groups.skills.replaceChildren(...(skills ? drawSkills(state, at, skills) : []));
  if (skills) gutters.get("skills").small.textContent = String(plain.document.plan.length);
  gutters.get("segments").describe(plain.document);
  gutters.get("boundaries").small.textContent = String(state.document.boundaries.length);
}

/** What is being named while it plays. @param {Stage} stage @param {State} state */
export function drawHeldLabel({ groups, scale }, state) {
  groups.naming.replaceChildren(...drawNaming(state, scale(), state.layout.rows.get("segments")));
}

/** @param {Stage} stage @param {State} state */
export function drawView({ groups, scale }, state) {
  const { rows } = state.layout;
  groups.ruler.replaceChildren(...drawRuler(scale(), rows.get("ruler")));
  groups.overviewWindow.replaceChildren(
    ...drawWindow(state, rows.get("overview"), state.plotWidth),
  );
}

/** @param {Stage} stage @param {State} state */
export function drawArms({ groups, gutters, scale }, { lanes, layout }) {
  const row = layout.rows.get("lanes");
  groups.lanes.replaceChildren(...(row ? drawLanes(lanes, scale(), row) : []));
  if (row) gutters.get("lanes").describe(lanes);
}

/** @param {Stage} stage @param {State} state */
export function drawLogged({ groups, gutters, scale }, { document: doc, layout }) {
  const row = layout.rows.get("events");
  groups.events.replaceChildren(...(row ? drawEvents(doc, scale(), row) : []));
  if (row) gutters.get("events").small.textContent = String(doc.events.length);
}

/** @param {Stage} stage @param {State} state */
export function drawWhole({ groups }, state) {
  groups.overviewCurve.replaceChildren(
    ...drawOverviewCurve(state, state.layout.rows.get("overview"), state.plotWidth),
  );
}

/** @param {Stage} stage @param {State} state */
export function drawStrip({ groups }, state) {
  groups.overview.replaceChildren(
    ...drawOverviewStrip(state, state.layout.rows.get("overview"), state.plotWidth),
  );
}

/** @param {Stage} stage @param {State} state */
export function drawOther({ groups, gutters, scale }, state) {
  const row = state.layout.rows.get("comparison");
  const shown = row && state.comparison?.with;
  groups.comparison.replaceChildren(...(shown ? drawComparison(state, scale(), row) : []));
  if (shown) gutters.get("comparison").describe(state.comparison);
}

/** @param {Stage} stage @param {State} state */
export function drawPlayhead({ groups, playhead, scale }, state) {
  const { document: doc, clock } = state;
  playhead.move(scale(), clock, groups.ruler.querySelectorAll("text"));
  const row = state.layout.rows.get("overview");
  const x = ((clock - doc.start_s) / (doc.end_s - doc.start_s)) * state.plotWidth;
  groups.overviewPlayhead.setAttribute("x", (x - 0.75).toFixed(1));
  groups.overviewPlayhead.setAttribute("y", String(row.y));
  groups.overviewPlayhead.setAttribute("height", String(row.height));
}

/** The line under the pointer, over all tracks. @param {Stage} stage @param {State} state */
export function drawPointer({ groups, scale, bottom }, state) {
  const x = state.pointer === null ? -1 : scale().x(state.pointer);
  const ruler = state.layout.rows.get("ruler");
  const inside = x >= 0 && x <= state.plotWidth;
  const from = ruler.y + ruler.height;
  groups.pointer.setAttribute("d", inside ? `M${Math.round(x) + 0.5} ${from}V${bottom()}` : "");
}
