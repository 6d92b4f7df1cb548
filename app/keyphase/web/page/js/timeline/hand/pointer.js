/** The pointer on the timeline: hovering, gestures, wheel, double click, context menu. */

import { segmentAt } from "../../model/segments.js";
import { segmentTitle } from "../segment_title.js";
import { breakAt } from "../breaks.js";
import { eventAt } from "../lanes/events.js";
import { startGesture } from "./gestures.js";
import { createHolding } from "./holding.js";
import { hitTest } from "./hit.js";
import { createPinch } from "../../lib/pinch.js";
import { clampView, zoomView } from "../../lib/scale.js";

const CLICK_PX = 3;
const CURSORS = {
  "overview-from": "ew-resize",
  "overview-to": "ew-resize",
  overview: "grab",
  ruler: "ew-resize",
  boundary: "ew-resize",
  segment: "pointer",
  threshold: "ns-resize",
  line: "ns-resize",
  track: "crosshair",
};
/** A finger hits a boundary this far beside it. */
const FINGER_PX = 16;
const WHEEL_ZOOM = 0.0016;
const WHEEL_REST_MS = 1000;

/**
 * @param {import("../../lib/store.js").Store} store
 * @param {any} timeline
 * @param {any} actions
 */
export function attachPointer(store, timeline, actions) {
  const { surface } = timeline;
  const pinch = createPinch(store, timeline);
  const holding = createHolding(store, surface);
  /** @type {import("./gestures.js").Point} */
  let start = { x: 0, y: 0, event: null };
  let moved = false;
  let turning = 0;

  const at = (event) => pointOn(surface, event);

  function hover(point) {
    const { document: doc, plotWidth } = store.state;
    if (!doc || !store.state.view) return;
    const hit = hitTest(store.state, timeline, point.x, point.y);
    const ruler = timeline.layout().rows.get("ruler");
    const inTracks = point.y >= ruler.y && point.x <= plotWidth;
    surface.style.cursor = CURSORS[hit.kind] ?? "default";
    surface.title = inTracks ? saidAt(store.state, timeline, point, hit) : "";
    store.set({
      hovered: hit.kind === "boundary" ? hit.boundary : null,
      candidate: hit.candidate ?? null,
      lineOver: hit.kind === "line" ? hit.line : null,
      pointer: inTracks ? timeline.scale().time(point.x) : null,
    });
  }

  /**
   * A wheel never says that it was let go; after a moment without a turn it was. Turns that came
   * in while the page was busy are heard before the next frame, so one frame more is awaited.
   */
  function holdWhileTurning() {
    store.set({ holding: true });
    clearTimeout(turning);
    const turn = setTimeout(() => {
      requestAnimationFrame(
        () => turn === turning && store.set({ holding: holding.gesture() !== null }),
      );
    }, WHEEL_REST_MS);
    turning = turn;
  }

  surface.addEventListener("pointermove", (event) => {
    const point = at(event);
    if (pinch.move(event, point.x)) return undefined;
    const gesture = holding.gesture();
    if (!gesture) return hover(point);
    moved ||= Math.hypot(point.x - start.x, point.y - start.y) > CLICK_PX;
    if (!moved) return undefined;
    store.set({ pointer: timeline.scale().time(point.x) });
    return gesture.move(point);
  });

  surface.addEventListener("pointerdown", (event) => {
    if (event.button !== 0 || !store.state.document || !store.state.view) return;
    if (pinch.down(event, at(event).x)) {
      letGo();
      return;
    }
    start = at(event);
    moved = false;
    const isFinger = event.pointerType === "touch";
    const reach = isFinger ? FINGER_PX : undefined;
    const hit = hitTest(store.state, timeline, start.x, start.y, reach);
    if (isFinger && hit.kind !== "boundary") store.set({ current: null, explained: null });
    const gesture = startGesture(store, timeline, actions, hit, start);
    if (!gesture) return;
    holding.take(gesture);
    surface.setPointerCapture(event.pointerId);
    if (gesture.cursor) surface.style.cursor = gesture.cursor;
    surface.focus({ preventScroll: true });
  });

  /** Gives up what is being dragged; whether anything was. */
  function letGo() {
    const gesture = holding.release();
    gesture?.cancel?.();
    return gesture !== null;
  }

  function finish(event) {
    if (pinch.up(event)) return;
    const ending = holding.release();
    if (!ending) return;
    if (event.type === "pointerup") ending.end(at(event), moved);
    else ending.cancel?.();
    if (event.pointerType !== "touch") hover(at(event));
  }
  surface.addEventListener("pointerup", finish);
  surface.addEventListener("pointercancel", finish);
  surface.addEventListener("pointerleave", () => {
    if (!holding.gesture())
      store.set({ pointer: null, hovered: null, candidate: null, lineOver: null });
  });

  surface.addEventListener("dblclick", (event) => {
    const point = at(event);
    const hit = hitTest(store.state, timeline, point.x, point.y);
    if (hit.kind === "segment") actions.rename(hit.segment);
    else if (hit.kind === "overview") actions.fit();
    else if (hit.kind === "threshold") actions.automaticThreshold();
    else if (hit.kind === "line") actions.automaticThreshold(hit.line);
  });

  surface.addEventListener("contextmenu", (event) => {
    event.preventDefault();
    const point = at(event);
    if (!store.state.document) return;
    actions.menu(
      hitTest(store.state, timeline, point.x, point.y),
      timeline.scale().time(point.x),
      event,
    );
  });

  surface.addEventListener(
    "wheel",
    (event) => {
      const { document: doc, view } = store.state;
      if (!doc || !view) return;
      event.preventDefault();
      holdWhileTurning();
      turnWheel(store, timeline, event, at(event).x);
    },
    { passive: false },
  );

  return { cancel: letGo };
}

/**
 * Where a pointer is on an element.
 * @param {HTMLElement} surface
 * @param {PointerEvent} event
 * @returns {import("./gestures.js").Point}
 */
function pointOn(surface, event) {
  const box = surface.getBoundingClientRect();
  return { x: event.clientX - box.left, y: event.clientY - box.top, event };
}

/**
 * Scrolls the tracks (Alt), pans (Shift or sideways) or zooms around the pointer.
 * @param {import("../../lib/store.js").Store} store
 * @param {any} timeline
 * @param {WheelEvent} event
 * @param {number} x of the pointer
 */
function turnWheel(store, timeline, event, x) {
  const { document: doc, view } = store.state;
  const sideways = event.shiftKey ? event.deltaY : event.deltaX;
  if (event.altKey) {
    timeline.scroller.scrollTop += event.deltaY;
  } else if (Math.abs(sideways) > Math.abs(event.shiftKey ? 0 : event.deltaY)) {
    const by = (sideways / store.state.plotWidth) * (view.to - view.from);
    store.set({ view: clampView(view.from + by, view.to + by, doc) });
  } else {
    const anchor = timeline.scale().time(Math.min(Math.max(x, 0), store.state.plotWidth));
    store.set({ view: zoomView(view, Math.exp(-event.deltaY * WHEEL_ZOOM), anchor, doc) });
  }
}

/** The words of an event in its row, of a break, or of a segment and what is executed of it. */
function saidAt({ document: doc }, timeline, { x, y }, hit) {
  const { rows } = timeline.layout();
  const within = (key) => {
    const row = rows.get(key);
    return row && !row.folded && y >= row.y && y < row.y + row.height;
  };
  const broken = breakAt(doc, x, timeline.scale());
  if (within("events")) return eventAt(doc, x, timeline.scale()) || broken;
  if (broken || !(hit.kind === "segment" || within("skills"))) return broken;
  return segmentTitle(doc, segmentAt(doc, timeline.scale().time(x)));
}
