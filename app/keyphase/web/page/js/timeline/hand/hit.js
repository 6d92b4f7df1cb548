/** What lies under the pointer on the timeline. */

import { segmentAt } from "../../model/segments.js";

const BOUNDARY_PX = 5;
const THRESHOLD_PX = 4;
const HANDLE_PX = 6;

/**
 * @typedef {{kind: "overview"|"overview-from"|"overview-to"|"ruler"|"boundary"|"segment"|
 *   "threshold"|"line"|"track"|"none", boundary?: number, segment?: number, line?: string,
 *   candidate?: number|null}} Hit  `line`: the parameter of a line over the evidence
 */

/**
 * @param {import("../../lib/store.js").State} state
 * @param {any} timeline
 * @param {number} x px from the plot's left edge
 * @param {number} y px from the timeline's top
 * @param {number} [reach] px within which a boundary is hit
 * @returns {Hit}
 */
export function hitTest(state, timeline, x, y, reach = BOUNDARY_PX) {
  const { document: doc } = state;
  const layout = timeline.layout();
  if (!doc || !layout.rows.size) return { kind: "none" };
  const inRow = (key) =>
    y >= layout.rows.get(key).y && y < layout.rows.get(key).y + layout.rows.get(key).height;
  if (inRow("overview")) return overviewHit(state, x);
  const line = timeline.lineAt(y, x > state.plotWidth);
  if (x > state.plotWidth && line) return { kind: "line", line };
  if (x > state.plotWidth)
    return nearThreshold(state, timeline, y, 9) ? { kind: "threshold" } : { kind: "none" };
  if (inRow("ruler")) return { kind: "ruler" };
  const candidate = timeline.candidateAt(x, y);
  // A boundary says itself why it is there; what became none lies over the boundaries.
  if (candidate !== null && !doc.candidates[candidate].given) return { kind: "track", candidate };
  const boundary = boundaryAt(doc, timeline.scale(), x, reach);
  if (boundary >= 0) return { kind: "boundary", boundary };
  if (inRow("segments"))
    return { kind: "segment", segment: segmentAt(doc, timeline.scale().time(x)) };
  if (line) return { kind: "line", line };
  if (nearThreshold(state, timeline, y, THRESHOLD_PX)) return { kind: "threshold" };
  return { kind: "track" };
}

/** @returns {Hit} */
function overviewHit({ document: doc, view, plotWidth }, x) {
  const at = (time) => ((time - doc.start_s) / (doc.end_s - doc.start_s)) * plotWidth;
  if (Math.abs(x - at(view.from)) <= HANDLE_PX) return { kind: "overview-from" };
  if (Math.abs(x - at(view.to)) <= HANDLE_PX) return { kind: "overview-to" };
  return { kind: "overview" };
}

/** @param {import("../../lib/store.js").State} state */
function nearThreshold(state, timeline, y, reach) {
  const at = timeline.thresholdY();
  return at !== null && Math.abs(at - y) <= reach;
}

/**
 * @param {import("../../model/types.js").Doc} doc
 * @param {import("../../lib/scale.js").Scale} scale
 */
function boundaryAt(doc, scale, x, reach) {
  let best = -1;
  let distance = reach;
  doc.boundaries.forEach(({ time_s: time }, index) => {
    const away = Math.abs(scale.x(time) - x);
    if (away <= distance) [best, distance] = [index, away];
  });
  return best;
}
