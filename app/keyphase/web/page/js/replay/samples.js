/**
 * What was measured in a replay, growing while it runs; rows as in `replay_samples`.
 *
 * @typedef {{run: number, count: number, factor: number, time: Float64Array,
 *   columns: Map<string, Float64Array>, demonstrated: (Object<string, number[]>|null)[]}} Samples
 */

const COLUMNS = [
  "time",
  "position_x",
  "position_y",
  "position_z",
  "force_x",
  "force_y",
  "force_z",
  "torque_x",
  "torque_y",
  "torque_z",
  "off",
];
const FIRST_ROOM = 4096;

/**
 * The samples with a message's rows; the same object where nothing fits, else a new one, so that
 * whoever compares notices.
 * @param {Samples|null} before
 * @param {import("../messages/replay_messages").ReplaySamples} message
 * @returns {Samples|null}
 */
export function withRows(before, { run, first, factor, rows, demonstrated }) {
  const known = before?.run === run ? before : null;
  if (first > (known?.count ?? 0)) return before;
  const count = first + rows.length;
  const columns = roomFor(known?.columns, count);
  rows.forEach((row, k) => COLUMNS.forEach((name, c) => (columns.get(name)[first + k] = row[c])));
  return {
    run,
    count,
    factor,
    time: columns.get("time"),
    columns,
    demonstrated: demonstrated ?? known?.demonstrated ?? [],
  };
}

function roomFor(columns, count) {
  const room = columns?.get("time").length ?? 0;
  if (columns && room >= count) return columns;
  const larger = Math.max(FIRST_ROOM, 2 * room, count);
  return new Map(
    COLUMNS.map((name) => {
      const values = new Float64Array(larger);
      if (columns) values.set(columns.get(name));
      return [name, values];
    }),
  );
}

/** The curves of a track: x, y and z, or the one it has. @param {Samples} samples @param {string} track */
export function liveSeries(samples, track) {
  const names = track === "off" ? ["off"] : ["x", "y", "z"].map((axis) => `${track}_${axis}`);
  const times = samples.time.subarray(0, samples.count);
  return names.map((name) => ({
    key: name.at(-1),
    times,
    values: samples.columns.get(name).subarray(0, samples.count),
  }));
}

/** Index of the first sample at or after a time. @param {Samples} samples */
export function indexAt({ time, count }, seconds) {
  let low = 0;
  let high = count;
  while (low < high) {
    const middle = (low + high) >> 1;
    if (time[middle] < seconds) low = middle + 1;
    else high = middle;
  }
  return low;
}
