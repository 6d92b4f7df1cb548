/** What is asked of the series of a track: their length as vectors, their extent, their samples. */

import { upperBound, valueAt } from "../../model/signals.js";

/**
 * The length of a vector of series, on the times of its first: what a folded track shows.
 * @param {import("../../model/types.js").Series[]} series
 * @returns {import("../../model/types.js").Series}
 */
export function normOf(series) {
  if (series.length === 1) return series[0];
  const { times } = series[0];
  const squares = Float64Array.from(times, (time, k) => {
    const others = series.slice(1).reduce((sum, one) => sum + (valueAt(one, time) || 0) ** 2, 0);
    return series[0].values[k] ** 2 + others;
  });
  return { key: "norm", times, values: squares.map(Math.sqrt) };
}

/** Least and greatest value of several series. @param {import("../../model/types.js").Series[]} series */
export function extent(series) {
  let low = Infinity;
  let high = -Infinity;
  for (const { values } of series) {
    for (const value of values) {
      if (value < low) low = value;
      if (value > high) high = value;
    }
  }
  return Number.isFinite(low) ? { low, high } : { low: 0, high: 1 };
}

/** Calls `visit` with every sample between two times and one beyond on either side. */
export function eachSample({ times, values }, from, to, visit) {
  const start = Math.max(0, upperBound(times, from) - 1);
  for (let k = start; k < times.length; k++) {
    visit(times[k], values[k]);
    if (times[k] > to) return;
  }
}
