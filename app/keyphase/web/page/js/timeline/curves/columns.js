/**
 * A curve with more samples in view than pixels goes up and down in every one of them. It is drawn
 * as a bar in each, from the least to the greatest: where the browser draws in software, a line
 * through thousands of such points takes a tenth of a second, and the bars a thousandth.
 */

import { upperBound } from "../../model/signals.js";

/** With more samples in view than so many for each pixel a curve is dense. */
const DENSE_PER_PX = 1.8;

/** How many samples of a series are in view. */
export function samplesIn({ times }, { from, to }) {
  return upperBound(times, to) - upperBound(times, from);
}

/**
 * @param {import("../../model/types.js").Series[]} series
 * @param {import("../../model/types.js").View} view
 * @param {number} width px
 */
export function isDense(series, view, width) {
  return series.some((one) => samplesIn(one, view) > DENSE_PER_PX * width);
}

/**
 * The least and greatest height in every column of pixels in view, joined to the one before.
 * @param {import("../../model/types.js").Series} series
 * @param {import("../../model/types.js").View} view
 * @param {number} width in columns
 * @param {(value: number) => number} y height of a value, downwards
 * @param {(column: number, top: number, bottom: number) => void} visit
 */
export function eachColumn({ times, values }, view, width, y, visit) {
  const perSecond = width / (view.to - view.from);
  const end = Math.min(times.length, upperBound(times, view.to) + 1);
  let column = -1;
  let top = Infinity;
  let bottom = -Infinity;
  for (let k = Math.max(0, upperBound(times, view.from) - 1); k < end; k++) {
    const level = y(values[k]);
    const now = Math.floor((times[k] - view.from) * perSecond);
    if (now !== column) {
      if (column >= 0) visit(column, top, bottom);
      // The line comes from the last sample of the column before.
      const last = k > 0 ? y(values[k - 1]) : level;
      column = now;
      top = Math.min(level, last);
      bottom = Math.max(level, last);
    } else {
      top = Math.min(top, level);
      bottom = Math.max(bottom, level);
    }
  }
  if (column >= 0 && column < width) visit(column, top, bottom);
}
