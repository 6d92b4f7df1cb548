/** What the document looks like while a boundary is being dragged, before the server knows. */

/**
 * @typedef {{boundary: number, time: number, snapped: string, ripples: boolean, x: number,
 *   y: number}} Drag  ripples: all later boundaries go with it
 * @param {import("./types.js").Doc} doc
 * @param {Drag|null} drag
 * @returns {import("./types.js").Doc}
 */
export function withDrag(doc, drag) {
  const moved = drag && doc.boundaries[drag.boundary];
  if (!moved) return doc;
  const last = drag.ripples ? doc.boundaries.length : drag.boundary + 1;
  return withMoved(doc, drag.boundary, last, drag.time - moved.time_s);
}

/**
 * With the boundaries from `first` to before `last` moved by so much, and the segments with them.
 * @param {import("./types.js").Doc} doc
 * @param {number} first
 * @param {number} last
 * @param {number} by [s]
 * @returns {import("./types.js").Doc}
 */
export function withMoved(doc, first, last, by) {
  const boundaries = doc.boundaries.slice();
  const segments = doc.segments.slice();
  for (let k = first; k < last; k++) {
    const one = boundaries[k];
    boundaries[k] = { ...one, time_s: one.time_s + by, was_s: one.was_s ?? one.time_s };
  }
  // Those beside a moved boundary only: of thousands, copies would cost every move of the hand.
  for (let k = first; k <= last && k < segments.length; k++)
    segments[k] = {
      ...segments[k],
      start_s: boundaries[k - 1]?.time_s ?? segments[k].start_s,
      end_s: boundaries[k]?.time_s ?? segments[k].end_s,
    };
  return { ...doc, boundaries, segments };
}

/** Two boundaries this near are one; so near the server lets none come by a move of many [s]. */
const SAME_S = 0.05;

/**
 * The stretch a boundary may be dragged in: between its neighbours, or as far as those that go with
 * it have room.
 * @param {import("./types.js").Doc} doc
 * @param {number} index
 * @param {boolean} [ripples] all later ones go with it
 * @returns {[number, number]}
 */
export function reachOf(doc, index, ripples = false) {
  const gap = 2 / doc.rate_hz;
  const before = doc.boundaries[index - 1]?.time_s ?? doc.start_s;
  if (ripples) {
    const room = doc.end_s - doc.boundaries.at(-1).time_s;
    return [
      before + (index ? Math.max(gap, SAME_S) : gap),
      doc.boundaries[index].time_s + room - gap,
    ];
  }
  const after = doc.boundaries[index + 1]?.time_s ?? doc.end_s;
  return [before + gap, after - gap];
}
