/**
 * The take that is being recorded, as far as the server has told it: a sample some ten times a
 * second.
 *
 * @typedef {{begin: number[], times: number[], position: number[][], force: number[][]}} Take
 *   position in mm from where it began and force in N, each x y z
 */

const MM = 1000;
/** With more samples than this every other one goes. */
const MOST = 2000;

/**
 * With what a message tells; another take where its time is less, none where none is recorded.
 * @param {Take|null} take
 * @param {import("../../messages/control_messages").RecordMessage} record
 * @returns {Take|null}
 */
export function takeWith(take, { recorded_s: time, newest }) {
  if (time === null || !newest) return null;
  const position = newest.slice(0, 3);
  const goesOn = take && take.times.at(-1) <= time;
  const before = goesOn ? thinned(take) : { begin: position, times: [], position: [], force: [] };
  return {
    begin: before.begin,
    times: [...before.times, time],
    position: [...before.position, position.map((value, k) => MM * (value - before.begin[k]))],
    force: [...before.force, newest.slice(3)],
  };
}

/** @param {Take} take @returns {Take} */
function thinned(take) {
  if (take.times.length < MOST) return take;
  const some = (/** @type {any[]} */ values) => values.filter((_, k) => k % 2 === 0);
  const { begin, times, position, force } = take;
  return { begin, times: some(times), position: some(position), force: some(force) };
}

/**
 * The curves of a take in a box: for each axis points "x,y …".
 * @param {number[]} times
 * @param {number[][]} rows one for each time
 * @param {{width: number, height: number, least: number}} box `least` of the value's range
 */
export function curvesIn(times, rows, { width, height, least }) {
  const whole = Math.max(times.at(-1), SHOWN_S);
  const values = rows.flat();
  const [low, high] = [Math.min(...values), Math.max(...values)];
  const spare = Math.max(least - (high - low), 0) / 2;
  const [bottom, top] = [low - spare, high + spare];
  return [0, 1, 2].map((axis) =>
    rows
      .map((row, k) => {
        const x = (times[k] / whole) * width;
        const y = height * (1 - (row[axis] - bottom) / (top - bottom));
        return `${x.toFixed(1)},${y.toFixed(1)}`;
      })
      .join(" "),
  );
}

/** A short take does not fill the width. */
const SHOWN_S = 10;
