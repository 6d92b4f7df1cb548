/**
 * What a person did that the server has not yet told back: drawn at once over the last document,
 * until a document that contains it has come, or a refusal.
 *
 * @typedef {import("./types.js").Doc} Doc
 * @typedef {import("./types.js").Segment} Segment
 * @typedef {import("./types.js").Edit} Edit
 * @typedef {{event: number, edit: Edit}} Pending
 */

import { withMoved } from "./drag.js";

/** How far apart two times may be and still be one boundary's. */
const SAME_S = 1e-6;

/**
 * The document with what is pending in it, in order; the same object where nothing is.
 * @param {Doc|null} doc
 * @param {Pending[]} pending
 * @returns {Doc|null}
 */
export function withPending(doc, pending) {
  if (!doc) return doc;
  return pending.reduce((shown, { edit }) => {
    const draw = /** @type {(doc: Doc, edit: Edit) => Doc|null} */ (DRAWN[edit.kind]);
    return draw?.(shown, edit) ?? shown;
  }, doc);
}

/**
 * What stays pending once a document has come that contains everything up to an event.
 * @param {Pending[]} pending
 * @param {number} event
 */
export function stillPending(pending, event) {
  return pending.filter((one) => one.event > event);
}

/**
 * How each kind of edit looks before the server knows of it.
 * @type {{[E in Edit as E["kind"]]?: (doc: Doc, edit: E) => Doc|null}}
 */
const DRAWN = {
  assess: (doc, { outcome = null, quality = null, note = "" }) => ({
    ...doc,
    assessment: { outcome, quality, note },
  }),
  assess_segment: (doc, { time_s: time, to_s: to, outcome = null, quality = null, note = "" }) =>
    withSegments(doc, time, to, { assessment: { outcome, quality, note } }),
  camera_offset: (doc, { camera, offset_s: offset }) => ({
    ...doc,
    camera_offsets: { ...doc.camera_offsets, [camera]: offset },
  }),
  move(doc, { from_s: from, to_s: to }) {
    const index = boundaryAt(doc, from);
    const moved = doc.boundaries[index];
    if (!moved) return null;
    const boundaries = doc.boundaries.with(index, {
      ...moved,
      time_s: to,
      was_s: moved.was_s ?? moved.time_s,
      taken_from: null,
      unsure: false,
      origin: /** @type {const} */ ("user"),
    });
    const segments = doc.segments
      .with(index, { ...doc.segments[index], end_s: to })
      .with(index + 1, { ...doc.segments[index + 1], start_s: to });
    return { ...doc, boundaries, segments };
  },
  ripple(doc, { from_s: from, by_s: by }) {
    const first = boundaryAt(doc, from);
    if (first < 0) return null;
    const moved = withMoved(doc, first, doc.boundaries.length, by);
    const boundaries = moved.boundaries.map((one, k) =>
      k < first ? one : { ...one, unsure: false, origin: /** @type {const} */ ("user") },
    );
    return { ...moved, boundaries };
  },
  add(doc, { time_s: time }) {
    const index = segmentAt(doc, time);
    const cut = doc.segments[index];
    if (!cut || time <= cut.start_s || time >= cut.end_s) return null;
    const segments = [
      ...doc.segments.slice(0, index),
      { ...cut, end_s: time },
      { ...cut, start_s: time },
      ...doc.segments.slice(index + 1),
    ];
    const boundaries = doc.boundaries.toSpliced(index, 0, placed(time));
    return renumbered({ ...doc, boundaries, segments }, doc);
  },
  remove(doc, { time_s: time }) {
    const index = boundaryAt(doc, time);
    return index < 0 ? null : without(doc, index, 1);
  },
  merge(doc, { from_s: from, to_s: to }) {
    const inside = doc.boundaries.filter(({ time_s: time }) => time > from && time < to).length;
    const first = doc.boundaries.findIndex(({ time_s: time }) => time > from);
    return inside ? without(doc, first, inside) : null;
  },
  label: (doc, { time_s: time, to_s: to, label }) =>
    withSegments(doc, time, to, { label, short: [label, label, label], proposed: false }),
  keep: (doc, { time_s: time, to_s: to, kept }) => withSegments(doc, time, to, { kept }),
  accept: (doc, { time_s: time }) => withBoundary(doc, time, { accepted: true, unsure: false }),
  contact: (doc, { time_s: time, contact_change: contact }) =>
    withBoundary(doc, time, { contact_change: contact }),
  drop_idle: (doc) => ({
    ...doc,
    segments: doc.segments.map((one) => (one.idle ? { ...one, kept: false } : one)),
  }),
  accept_labels: (doc) => ({
    ...doc,
    segments: doc.segments.map((one) => ({ ...one, proposed: false })),
  }),
  plan(doc, { order }) {
    const times = new Map();
    const plan = order.map((time) => {
      const segment = segmentAt(doc, time);
      const repeat = times.get(segment) ?? 0;
      times.set(segment, repeat + 1);
      const known = doc.plan.find((entry) => entry.segment === segment);
      return {
        connect_mm: null,
        ...known,
        time_s: time,
        segment,
        repeat,
      };
    });
    return { ...doc, plan };
  },
};

/** Number of the boundary at a time, -1 where none is. @param {Doc} doc @param {number} time */
function boundaryAt({ boundaries }, time) {
  return boundaries.findIndex((one) => Math.abs(one.time_s - time) < SAME_S);
}

/** @param {Doc} doc @param {number} time */
function segmentAt({ segments }, time) {
  const index = segments.findIndex(({ end_s: end }) => time < end);
  return index < 0 ? segments.length - 1 : index;
}

/**
 * With a change to the segment at a time, or to all from there to another time.
 * @param {Doc} doc
 * @param {number} time
 * @param {number|null|undefined} to
 * @param {Partial<Segment>} change
 */
function withSegments(doc, time, to, change) {
  const [first, last] = [segmentAt(doc, time), segmentAt(doc, to ?? time)];
  const isMeant = (index) => index >= first && index <= last;
  const segments = doc.segments.map((one, k) => (isMeant(k) ? { ...one, ...change } : one));
  return { ...doc, segments };
}

/** @param {Doc} doc @param {number} time @param {Partial<import("./types.js").Boundary>} change */
function withBoundary(doc, time, change) {
  const index = boundaryAt(doc, time);
  const boundary = doc.boundaries[index];
  return boundary
    ? { ...doc, boundaries: doc.boundaries.with(index, { ...boundary, ...change }) }
    : null;
}

/**
 * Without so many boundaries from `first` on; the segments they parted are one.
 * @param {import("./types.js").Doc} doc
 */
function without(doc, first, count) {
  const joined = { ...doc.segments[first], end_s: doc.segments[first + count].end_s };
  const boundaries = doc.boundaries.toSpliced(first, count);
  const segments = doc.segments.toSpliced(first, count + 1, joined);
  return renumbered({ ...doc, boundaries, segments }, doc);
}

/** What names segments by their number, after their number has changed. @param {Doc} doc @param {Doc} before */
function renumbered(doc, before) {
  const dropped = before.proposed_drops.map((index) => {
    const { start_s: start, end_s: end } = before.segments[index];
    return segmentAt(doc, (start + end) / 2);
  });
  return {
    ...doc,
    plan: doc.plan.map((entry) => ({ ...entry, segment: segmentAt(doc, entry.time_s) })),
    proposed_drops: [...new Set(dropped)],
  };
}

/** A boundary that a person has just put there. @returns {import("./types.js").Boundary} */
function placed(time) {
  return {
    time_s: time,
    origin: "user",
    interval_s: [time, time],
    confidence: 1,
    contact_change: false,
    change: "",
    was_s: null,
    taken_from: null,
    accepted: true,
    unsure: false,
    at_m: null,
    why: {
      sentences: [],
      reasons: [],
      height: null,
      times_threshold: null,
      position_s: null,
      steps: [],
    },
  };
}
