/**
 * What dragging does, by what was grabbed. A gesture answers pointer positions: `move` while
 * held, `end` when let go (`moved` false: it was a click), `cancel` on Escape. `stands`: whether what
 * was grabbed is in a document still; where not, the gesture is forgotten.
 *
 * @typedef {{x: number, y: number, event: PointerEvent}} Point
 * @typedef {{cursor?: string, move: (point: Point) => void,
 *   end: (point: Point, moved: boolean) => void, cancel?: () => void,
 *   stands?: import("../../model/held.js").Stands}} Gesture
 */

import { segmentAt } from "../../model/segments.js";
import { reachOf } from "../../model/drag.js";
import { boundaryStands, segmentsStand } from "../../model/held.js";
import { clampView, createScale } from "../../lib/scale.js";
import { dragLine } from "../evidence/drag_line.js";
import { nearestEvidence, REACH_PX } from "../../model/snapping.js";

/** So near the automatic threshold, as a share of it, the line is caught. */
const CATCHES = 0.08;

/**
 * @param {import("../../lib/store.js").Store} store
 * @param {any} timeline
 * @param {any} actions
 * @param {import("./hit.js").Hit} hit
 * @param {Point} start
 * @returns {Gesture|null}
 */
export function startGesture(store, timeline, actions, hit, start) {
  const { readOnly } = store.state;
  switch (hit.kind) {
    case "overview":
      return moveWindow(store, start);
    case "overview-from":
      return resizeWindow(store, "from");
    case "overview-to":
      return resizeWindow(store, "to");
    case "ruler":
      return scrub(timeline, actions, start);
    case "threshold":
      return readOnly ? null : dragThreshold(store, timeline, actions);
    case "line":
      return readOnly ? null : dragLine(store, timeline, actions, hit.line, start);
    case "boundary":
      return dragBoundary(store, timeline, actions, hit.boundary, start, readOnly);
    case "segment":
      return dragSegments(store, timeline, actions, hit.segment, readOnly);
    case "track":
      return pan(store, timeline, actions, start);
    default:
      return null;
  }
}

function wholeScale({ document: doc, plotWidth }) {
  return createScale({ from: doc.start_s, to: doc.end_s }, plotWidth);
}

/** @param {import("../../lib/store.js").Store} store */
function moveWindow(store, start) {
  const { view, document: doc } = store.state;
  const whole = wholeScale(store.state);
  const grabbed = whole.time(start.x);
  const inside = grabbed >= view.from && grabbed <= view.to;
  const offset = inside ? grabbed - view.from : (view.to - view.from) / 2;
  const show = ({ x }) => {
    const from = whole.time(x) - offset;
    store.set({ view: clampView(from, from + view.to - view.from, doc) });
  };
  if (!inside) show(start);
  return { cursor: "grabbing", move: show, end() {} };
}

/** @param {import("../../lib/store.js").Store} store */
function resizeWindow(store, side) {
  const { document: doc } = store.state;
  const whole = wholeScale(store.state);
  return {
    cursor: "ew-resize",
    move({ x }) {
      const { view } = store.state;
      const time = Math.min(Math.max(whole.time(x), doc.start_s), doc.end_s);
      const least = 8 / doc.rate_hz;
      store.set({
        view:
          side === "from"
            ? { from: Math.min(time, view.to - least), to: view.to }
            : { from: view.from, to: Math.max(time, view.from + least) },
      });
    },
    end() {},
  };
}

function scrub(timeline, actions, start) {
  const seek = ({ x }) => actions.seek(timeline.scale().time(x));
  seek(start);
  return { cursor: "ew-resize", move: seek, end() {} };
}

/** @param {import("../../lib/store.js").Store} store */
function pan(store, timeline, actions, start) {
  const { view, document: doc } = store.state;
  const perPixel = (view.to - view.from) / store.state.plotWidth;
  return {
    cursor: "grabbing",
    move({ x }) {
      const from = view.from - (x - start.x) * perPixel;
      store.set({ view: clampView(from, from + view.to - view.from, doc) });
    },
    end({ x }, moved) {
      if (!moved) actions.seek(timeline.scale().time(x));
    },
  };
}

/** @param {import("../../lib/store.js").Store} store */
function dragThreshold(store, timeline, actions) {
  const { document: doc } = store.state;
  const given = doc.parameters.force_threshold;
  const tell = (point, held) => {
    const value = timeline.errorAt(point.y);
    if (!(value > 0)) return;
    actions.setParameter("force_threshold", caught(value, doc), held, point.event, "line");
  };
  return {
    cursor: "ns-resize",
    move: (point) => tell(point, true),
    end: (point, moved) => moved && tell(point, false),
    cancel: () => actions.setParameter("force_threshold", given, false),
  };
}

/** Near the automatic threshold the line falls back to it. */
function caught(value, { automatic_threshold: automatic }) {
  if (automatic && Math.abs(Math.log(value / automatic)) < CATCHES) return null;
  return Number(value.toPrecision(4));
}

/** @param {import("../../lib/store.js").Store} store */
function dragBoundary(store, timeline, actions, index, start, readOnly) {
  const { document: doc } = store.state;
  const boundary = doc.boundaries[index];
  const offset = timeline.scale().x(boundary.time_s) - start.x;
  const stop = () => store.set({ drag: null });
  return {
    cursor: "ew-resize",
    stands: boundaryStands(doc, index),
    move({ x, y, event }) {
      if (readOnly) return;
      const scale = timeline.scale();
      const wanted = scale.time(x + offset);
      const reach = (REACH_PX * (scale.to - scale.from)) / scale.width;
      const snap = store.state.snap && !event.altKey;
      const evidence = snap ? nearestEvidence(store.state, wanted, reach, index) : null;
      const ripples = event.shiftKey;
      const [low, high] = reachOf(doc, index, ripples);
      const time = Math.min(Math.max(evidence?.time ?? wanted, low), high);
      store.set({
        drag: { boundary: index, time, snapped: evidence?.name ?? "", ripples, x, y },
        current: index,
      });
    },
    end(_, moved) {
      const { drag } = store.state;
      stop();
      store.set({ current: index });
      if (moved && drag) actions.moveBoundary(boundary.time_s, drag.time, drag.ripples);
      else actions.seek(boundary.time_s);
      // A finger cannot rest over it: what a mouse is shown then, a tap shows.
      if (!moved && start.event.pointerType === "touch") store.set({ explained: index });
    },
    cancel: stop,
  };
}

/** @param {import("../../lib/store.js").Store} store */
function dragSegments(store, timeline, actions, first, readOnly) {
  const under = ({ x }) => segmentAt(store.state.document, timeline.scale().time(x));
  const span = (point) => [Math.min(first, under(point)), Math.max(first, under(point))];
  return {
    stands: segmentsStand(store.state.document),
    move(point) {
      const [from, to] = span(point);
      store.set({ range: !readOnly && from < to ? [from, to] : null });
    },
    end(point, moved) {
      const [from, to] = span(point);
      store.set({ range: null });
      if (moved && from < to && !readOnly) actions.mergeRange(from, to);
      else if (point.event.shiftKey) actions.selectTo(first);
      else actions.select(first);
    },
    cancel: () => store.set({ range: null }),
  };
}
