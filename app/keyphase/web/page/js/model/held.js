/**
 * What a person holds, or is about to do something to, while another document comes: whether it is
 * still the same thing. Positions in a document's lists mean nothing in the next one.
 */

import { middle, segmentAt } from "./segments.js";

/** A boundary that differs by less is the same one. */
const SAME_S = 1e-3;

/** @typedef {import("./types.js").Doc} Doc */
/** @typedef {(doc: Doc|null) => boolean} Stands whether what is held is in a document */

/** @param {Doc} before @returns {Stands} */
export const recordingStands = (before) => (doc) => doc?.id === before.id;

/** @param {Doc} before @param {number} index @returns {Stands} */
export const boundaryStands = (before, index) => (doc) =>
  doc?.id === before.id && isNear(doc.boundaries[index]?.time_s, before.boundaries[index].time_s);

/** The whole band: segments that are dragged over must not become others. @param {Doc} before @returns {Stands} */
export const segmentsStand = (before) => (doc) =>
  doc?.id === before.id &&
  doc.segments.length === before.segments.length &&
  doc.segments.every(({ start_s: start }, k) => isNear(start, before.segments[k].start_s));

/** @param {Doc} before @returns {Stands} */
export const planStands = (before) => (doc) =>
  doc?.id === before.id &&
  doc.plan.length === before.plan.length &&
  doc.plan.every(({ time_s: time }, k) => isNear(time, before.plan[k].time_s));

const isNear = (time, before) => Math.abs((time ?? Infinity) - before) < SAME_S;

/**
 * What changes of a page's state when the document of its recording has come anew: what named
 * parts that are others now. Who is naming a segment goes on with the one at the same time.
 * @param {import("./state.js").State} state
 * @param {Doc} doc
 */
export function followed({ document: before, renaming }, doc) {
  if (segmentsStand(before)(doc)) return planStands(before)(doc) ? {} : { planDrag: null };
  const named = renaming === null ? null : before.segments[renaming];
  const others = { hovered: null, explained: null, current: null, selectedTo: null };
  return {
    ...(doc.boundaries.length === before.boundaries.length ? {} : others),
    range: null,
    planDrag: null,
    renaming: named ? segmentAt(doc, middle(named)) : null,
  };
}
