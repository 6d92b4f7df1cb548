/** Which segment is where. */

/** Number of the segment around a time. @param {import("./types.js").Doc} doc @param {number} time */
export function segmentAt(doc, time) {
  const index = doc.segments.findIndex(({ end_s: end }) => time < end);
  return index < 0 ? doc.segments.length - 1 : index;
}
