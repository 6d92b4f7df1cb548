/**
 * A curve in columns of pixels: how far up and down the line through its samples goes in each. Of a
 * thousand samples in one column, and of the stretch between two samples over a thousand columns,
 * that is all that can be seen.
 */

import { upperBound } from "../../model/signals.js";

/**
 * @typedef {{top: Float64Array, bottom: Float64Array}} Columns  heights downwards, the least and
 *   the greatest of each column; where there is no curve the least is infinite
 */

/** How many samples of a series are in view. */
export function samplesIn({ times }, { from, to }) {
  return upperBound(times, to) - upperBound(times, from);
}

/**
 * @param {import("../../model/types.js").Series} series
 * @param {import("../../model/types.js").View} view
 * @param {number} width in columns
 * @param {(value: number) => number} y height of a value, downwards
 * @returns {Columns}
 */
export function columnsOf({ times, values }, view, width, y) {
  const columns = {
    top: new Float64Array(width).fill(Infinity),
    bottom: new Float64Array(width).fill(-Infinity),
  };
  const perSecond = width / (view.to - view.from);
  const end = Math.min(times.length, upperBound(times, view.to) + 1);
  let x = NaN;
  let level = NaN;
  for (let k = Math.max(0, upperBound(times, view.from) - 1); k < end; k++) {
    const nextX = (times[k] - view.from) * perSecond;
    const nextLevel = y(values[k]);
    // Neither before the first sample, nor where nothing was recorded.
    if (Number.isFinite(level) && Number.isFinite(nextLevel))
      joinSamples(columns, width, x, level, nextX, nextLevel);
    x = nextX;
    level = nextLevel;
  }
  return columns;
}

/**
 * The straight line from one sample to the next, in every column it passes.
 * @param {Columns} columns
 */
function joinSamples(columns, width, x, level, nextX, nextLevel) {
  const first = Math.max(Math.floor(x), 0);
  const last = Math.min(Math.floor(nextX), width - 1);
  const slope = nextX > x ? (nextLevel - level) / (nextX - x) : 0;
  for (let column = first; column <= last; column++) {
    const from = column <= x ? level : level + (column - x) * slope;
    const to = column + 1 >= nextX ? nextLevel : level + (column + 1 - x) * slope;
    columns.top[column] = Math.min(columns.top[column], from, to);
    columns.bottom[column] = Math.max(columns.bottom[column], from, to);
  }
}
