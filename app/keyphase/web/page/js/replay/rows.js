/** The rows of the timeline in a replay and how high each is; open tracks fill what is left. */

import { FOLDED_PX } from "../model/rows.js";

const HEAD = [
  { key: "overview", large: 26, small: 20 },
  { key: "ruler", large: 18, small: 18 },
  { key: "ends", large: 20, small: 18 },
  { key: "skills", large: 42, small: 34 },
];

/** Every track of a replay: what it shows, and its heights. */
export const REPLAY_TRACKS = [
  { key: "force", title: "Force", unit: "N", large: 146, small: 124 },
  { key: "position", title: "Position", unit: "mm", large: 92, small: 62 },
  { key: "off", title: "Off the path", unit: "mm", large: 76, small: 44 },
  { key: "torque", title: "Torque", unit: "N m", large: 86, small: 56 },
];

/** Lower than this letters and ticks stand on each other; the rows scroll instead. */
const LEAST_PX = 42;

/**
 * @param {{small: boolean, replayFolded: Set<string>}} state
 * @param {number} room height of the pane
 * @returns {import("../model/rows.js").Layout}
 */
export function layOutReplay({ small, replayFolded }, room) {
  const rows = new Map();
  let y = 0;
  const put = (key, height, folded) => {
    rows.set(key, { key, y, height, folded });
    y += height;
  };
  for (const { key, large, small: low } of HEAD) put(key, small ? low : large, false);
  const headHeight = y;
  const heights = REPLAY_TRACKS.map(({ key, large, small: low }) =>
    replayFolded.has(key) ? FOLDED_PX : small ? low : large,
  );
  const folded = REPLAY_TRACKS.filter(({ key }) => replayFolded.has(key)).length * FOLDED_PX;
  const natural = heights.reduce((sum, height) => sum + height, 0) - folded;
  const stretch = natural > 0 ? Math.max(0.5, (room - headHeight - folded) / natural) : 1;
  REPLAY_TRACKS.forEach(({ key }, k) =>
    put(
      key,
      replayFolded.has(key) ? FOLDED_PX : Math.max(LEAST_PX, Math.floor(heights[k] * stretch)),
      replayFolded.has(key),
    ),
  );
  return { rows, headHeight, height: y };
}
