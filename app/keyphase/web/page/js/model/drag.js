/** What the document looks like while a boundary is being dragged, before the server knows. */

/**
 * @typedef {{boundary: number, time: number, snapped: string, x: number, y: number}} Drag
 * @param {import("./types.js").Doc} doc
 * @param {Drag|null} drag
 * @returns {import("./types.js").Doc}
 */
export function withDrag(doc, drag) {
  const moved = drag && doc.boundaries[drag.boundary];
  if (!moved) return doc;
  const was = moved.was_s ?? moved.time_s;
  const boundaries = doc.boundaries.with(drag.boundary, {
    ...moved,
    time_s: drag.time,
    was_s: was,
  });
  const before = doc.segments[drag.boundary];
  const after = doc.segments[drag.boundary + 1];
  const segments = doc.segments.slice();
  segments[drag.boundary] = { ...before, end_s: drag.time };
  segments[drag.boundary + 1] = { ...after, start_s: drag.time };
  return { ...doc, boundaries, segments };
}

/**
 * The stretch a boundary may be dragged in: between its neighbours.
 * @param {import("./types.js").Doc} doc
 * @param {number} index
 * @returns {[number, number]}
 */
export function reachOf(doc, index) {
  const gap = 2 / doc.rate_hz;
  const before = doc.boundaries[index - 1]?.time_s ?? doc.start_s;
  const after = doc.boundaries[index + 1]?.time_s ?? doc.end_s;
  return [before + gap, after - gap];
}
