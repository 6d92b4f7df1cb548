/** From seconds to pixels and back, for the stretch in view. */

/**
 * @typedef {{from: number, to: number, width: number, x: (time: number) => number,
 *   time: (x: number) => number}} Scale
 */

/**
 * @param {import("../model/types.js").View} view
 * @param {number} width px
 * @returns {Scale}
 */
export function createScale({ from, to }, width) {
  const pixelsPerSecond = width / (to - from);
  return {
    from,
    to,
    width,
    x: (time) => (time - from) * pixelsPerSecond,
    time: (x) => from + x / pixelsPerSecond,
  };
}

/**
 * The shortest stretch one can zoom into: four samples.
 * @param {import("../model/types.js").Doc} doc
 */
function shortest(doc) {
  return Math.min(doc.end_s - doc.start_s, Math.max(4 / doc.rate_hz, 1e-4));
}

/**
 * A view moved and sized so that it lies inside the recording.
 * @param {number} from @param {number} to
 * @param {import("../model/types.js").Doc} doc
 * @returns {import("../model/types.js").View}
 */
export function clampView(from, to, doc) {
  const length = doc.end_s - doc.start_s;
  const span = Math.min(Math.max(to - from, shortest(doc)), length);
  const centred = (from + to - span) / 2;
  const start = Math.min(Math.max(centred, doc.start_s), doc.end_s - span);
  return { from: start, to: start + span };
}

/**
 * Zooms by `factor` (above one: closer) and keeps `anchor` where it is on the screen.
 * @param {import("../model/types.js").View} view
 * @param {import("../model/types.js").Doc} doc
 */
export function zoomView(view, factor, anchor, doc) {
  const span = Math.max((view.to - view.from) / factor, shortest(doc));
  const share = (anchor - view.from) / (view.to - view.from);
  const from = anchor - share * span;
  return clampView(from, from + span, doc);
}

/** Round steps for ticks: 1, 2 or 5 times a power of ten, at most `count` of them. */
export function tickStep(span, count) {
  const raw = span / Math.max(count, 1);
  const power = 10 ** Math.floor(Math.log10(raw));
  const step = [1, 2, 5, 10].find((factor) => factor * power >= raw * (1 - 1e-9)) ?? 10;
  return step * power;
}

/** The same for an axis from `low` to `high`, finer where one tick alone would give no size. */
export function axisStep(low, high, count) {
  let step = tickStep(high - low, count);
  if (!(high > low)) return step;
  for (let more = 2 * Math.max(count, 1); multiples(low, high, step).length < 2; more *= 2) {
    step = tickStep(high - low, more);
  }
  return step;
}

/** All multiples of `step` from `low` to `high`. */
export function multiples(low, high, step) {
  const values = [];
  for (let k = Math.ceil(low / step - 1e-9); k * step <= high + 1e-9 * step; k++) {
    values.push(Number((k * step).toPrecision(12)));
  }
  return values;
}
