/** Which frames stand along the segments, in small. */

import { frameAt, isFilmed } from "./frames.js";

/** A narrower place shows no picture. */
const LEAST_PX = 14;

/**
 * @typedef {{x: number, width: number, frame: number}} Thumbnail  px on the timeline
 *
 * Each segment in view is filled with as many pictures as it has room for; one that is narrower than
 * a picture shows a part of it. Each is of the middle of its place.
 * @param {{start_s: number, end_s: number}[]} segments
 * @param {import("./frames.js").Camera} camera
 * @param {number} offset
 * @param {import("../../lib/scale.js").Scale} scale
 * @param {number} wide px of a whole picture
 * @returns {Thumbnail[]}
 */
export function thumbnailsOf(segments, camera, offset, scale, wide) {
  return segments.flatMap(({ start_s: start, end_s: end }) => {
    const [from, to] = [Math.max(scale.x(start), 0), Math.min(scale.x(end), scale.width)];
    if (to - from < LEAST_PX) return [];
    const count = Math.max(1, Math.floor((to - from) / wide));
    const width = (to - from) / count;
    return Array.from({ length: count }, (_, k) => from + k * width).flatMap((x) => {
      const time = scale.time(x + width / 2);
      return isFilmed(camera, offset, time)
        ? [{ x, width: width - 1, frame: frameAt(camera, offset, time) }]
        : [];
    });
  });
}
