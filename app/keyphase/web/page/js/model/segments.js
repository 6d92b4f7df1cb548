/** Which segment is where. */

/** Number of the segment around a time. @param {import("./types.js").Doc} doc @param {number} time */
export function segmentAt(doc, time) {
  const index = doc.segments.findIndex(({ end_s: end }) => time < end);
  return index < 0 ? doc.segments.length - 1 : index;
}

/** The time in a segment's middle, by which an edit names it. @param {import("./types.js").Segment} segment */
export const middle = ({ start_s: start, end_s: end }) => (start + end) / 2;

/**
 * The segments that are chosen, first and last: from the selected one to where the choice was drawn
 * out; null where none is selected.
 * @param {{selected: number|null, selectedTo: number|null}} state
 * @returns {[number, number]|null}
 */
export function chosenStretch({ selected, selectedTo }) {
  if (selected === null) return null;
  const other = selectedTo ?? selected;
  return [Math.min(selected, other), Math.max(selected, other)];
}
