/** Which segment is where. */

/** Number of the segment around a time. @param {import("./types.js").Doc} doc @param {number} time */
export function segmentAt(doc, time) {
  const index = doc.segments.findIndex(({ end_s: end }) => time < end);
  return index < 0 ? doc.segments.length - 1 : index;
}

/** The time in a segment's middle, by which an edit names it. @param {import("./types.js").Segment} segment */
export const middle = ({ start_s: start, end_s: end }) => (start + end) / 2;
