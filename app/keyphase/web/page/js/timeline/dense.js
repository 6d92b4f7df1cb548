/**
 * More segments or boundaries than can be told apart: drawn as a few paths instead of one group
 * each, at most one mark per pixel, so that an hour of recording draws as fast as ten seconds.
 */

import { originColor, segmentFill } from "../lib/colors.js";
import { svg } from "../lib/dom.js";

/** Beyond so many in view, marks lose their texts and shapes. */
export const MOST_IN_DETAIL = 300;
/** So they do where each has less room than this on the average [px]. */
const LEAST_ROOM_PX = 4;

/** Whether so many marks in view are too many to be told apart. @param {number} count @param {{width: number}} scale */
export const isCrowded = (count, { width }) =>
  count > Math.min(MOST_IN_DETAIL, Math.max(width / LEAST_ROOM_PX, MOST_ANYWHERE));

/** So many are told apart in any width. */
const MOST_ANYWHERE = 24;

/** @param {import("../model/types.js").Segment[]} segments @param {import("../lib/scale.js").Scale} scale */
export function segmentsInView(segments, scale) {
  return segments.filter(
    ({ start_s: start, end_s: end }) => end >= scale.from && start <= scale.to,
  );
}

/**
 * Segments as one path per colour.
 * @param {import("../model/types.js").Segment[]} segments
 * @param {import("../lib/scale.js").Scale} scale
 * @param {number} top
 * @param {number} height
 */
export function denseSegments(segments, scale, top, height) {
  /** @type {Map<string, string>} */
  const paths = new Map();
  let free = -Infinity;
  for (const segment of segmentsInView(segments, scale)) {
    const left = Math.max(scale.x(segment.start_s), free, 0);
    const right = Math.min(Math.max(scale.x(segment.end_s), left + 1), scale.width);
    // Of several segments within one pixel the first is seen.
    if (scale.x(segment.end_s) <= free || right <= left) continue;
    free = right;
    const fill = segment.kept ? segmentFill(segment) : "var(--hatch-line)";
    paths.set(
      fill,
      `${paths.get(fill) ?? ""}M${left.toFixed(1)} ${top}h${(right - left).toFixed(1)}v${height}h${(left - right).toFixed(1)}z`,
    );
  }
  return [...paths].map(([fill, d]) =>
    svg("path", { d, class: "dense-segments", style: { fill } }),
  );
}

/**
 * Boundaries as one path per origin: a tick in their own row.
 * @param {import("../model/types.js").Boundary[]} boundaries
 * @param {import("../lib/scale.js").Scale} scale
 * @param {import("../model/rows.js").Row} row
 */
export function denseBoundaries(boundaries, scale, { y, height }) {
  /** @type {Map<string, {d: string, last: number}>} */
  const paths = new Map();
  for (const { time_s: time, origin } of boundaries) {
    const x = Math.round(scale.x(time));
    const path = paths.get(origin) ?? { d: "", last: -1 };
    if (x < 0 || x > scale.width || x === path.last) continue;
    paths.set(origin, { d: `${path.d}M${x + 0.5} ${y + 4}v${height - 8}`, last: x });
  }
  return [...paths].map(([origin, { d }]) =>
    svg("path", {
      d,
      class: "dense-boundaries",
      style: { stroke: originColor(/** @type {any} */ (origin)) },
    }),
  );
}
