/** Where a boundary wants to be: at evidence near the pointer. */

import { curvesOf, upperBound } from "./signals.js";

/** How near evidence must be to catch a dragged boundary. */
export const REACH_PX = 9;

/**
 * @typedef {{time: number, name: string}} Evidence
 */

/**
 * The nearest evidence within `reach` seconds of `time`: error peaks, force onsets, speed minima,
 * the edges of a segmentation shown for comparison, the automatic place of a moved boundary.
 * @param {import("../lib/store.js").State} state
 * @param {number} time
 * @param {number} reach
 * @param {number} [own] number of the boundary being moved
 * @returns {Evidence|null}
 */
export function nearestEvidence(state, time, reach, own = -1) {
  const { document: doc } = state;
  /** @type {Evidence[]} */
  const found = [];
  for (const peak of doc.peaks) {
    if (peak.rejection === "below threshold") continue;
    found.push(
      { time: peak.time_s, name: "force onset" },
      { time: peak.bin_time_s, name: "error peak" },
    );
  }
  for (const other of state.comparison?.boundaries_s ?? [])
    found.push({ time: other, name: "the other segmentation" });
  const was = doc.boundaries[own]?.was_s;
  if (was !== null && was !== undefined) found.push({ time: was, name: "automatic place" });
  const automatic = doc.boundaries[own]?.why.position_s;
  if (automatic !== null && automatic !== undefined)
    found.push({ time: automatic, name: "position" });
  const slowest = speedMinimum(state, time - reach, time + reach);
  if (slowest !== null) found.push({ time: slowest, name: "speed minimum" });
  found.sort((a, b) => Math.abs(a.time - time) - Math.abs(b.time - time));
  return found.length && Math.abs(found[0].time - time) <= reach ? found[0] : null;
}

/**
 * Where the tool is slowest inside a window; null when it is slowest at the window's edge.
 * @param {import("../lib/store.js").State} state
 */
function speedMinimum(state, from, to) {
  const series = curvesOf(state, "speed")?.series[0];
  if (!series) return null;
  const first = upperBound(series.times, from);
  const last = upperBound(series.times, to);
  let best = -1;
  for (let k = first; k < last; k++)
    if (best < 0 || series.values[k] < series.values[best]) best = k;
  return best > first && best < last - 1 ? series.times[best] : null;
}
