/** What the document looks like while a boundary is being dragged, before the server knows. */

/**
 * @typedef {{boundary: number, time: number, snapped: string}} Drag
 * @param {import("../types.js").Doc} doc
 * @param {Drag|null} drag
 * @returns {import("../types.js").Doc}
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
  const segments = doc.segments.map((segment) => ({
    ...segment,
    start_s: segment.start_s === moved.time_s ? drag.time : segment.start_s,
    end_s: segment.end_s === moved.time_s ? drag.time : segment.end_s,
  }));
  return { ...doc, boundaries, segments };
}

/**
 * The stretch a boundary may be dragged in: between its neighbours.
 * @param {import("../types.js").Doc} doc
 * @param {number} index
 * @returns {[number, number]}
 */
export function reachOf(doc, index) {
  const gap = 2 / doc.rate_hz;
  const before = doc.boundaries[index - 1]?.time_s ?? doc.start_s;
  const after = doc.boundaries[index + 1]?.time_s ?? doc.end_s;
  return [before + gap, after - gap];
}
