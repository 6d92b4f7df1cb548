/** What stretch of a replay's time is shown: all of it, or a part chosen by wheel and drag. */

import { clampView, zoomView } from "../lib/scale.js";
import { viewOf } from "./schedule.js";

const WHEEL_ZOOM = 0.0016;
const RATE_HZ = 125;

/** @typedef {import("../model/types.js").View} View */

/**
 * All there is, and what of it is shown.
 * @param {View|null} chosen null: all of it
 * @param {import("./schedule.js").Slot[]} slots
 */
export function shownOf(slots, now, chosen) {
  const whole = viewOf(slots, now);
  return { whole, view: chosen ? clampView(chosen.from, chosen.to, bounds(whole)) : whole };
}

const bounds = ({ from, to }) =>
  /** @type {any} */ ({ start_s: from, end_s: to, rate_hz: RATE_HZ });

/**
 * The wheel zooms at the pointer, with Shift it shifts; dragging shifts, a double click shows all.
 * @param {import("../lib/store.js").Store} store
 * @param {HTMLElement} pane
 * @param {() => {whole: View, view: View, left: number, width: number}} shown as it is drawn
 */
export function attachReplayView(store, pane, shown) {
  /** @type {{x: number, view: View}|null} */
  let grip = null;
  const show = (view, whole) =>
    store.set({ replayView: view.to - view.from < whole.to - whole.from ? view : null });

  function shift(view, seconds) {
    const { whole } = shown();
    show(clampView(view.from + seconds, view.to + seconds, bounds(whole)), whole);
  }

  pane.addEventListener(
    "wheel",
    (event) => {
      event.preventDefault();
      const { whole, view, left, width } = shown();
      const sideways = event.shiftKey ? event.deltaY || event.deltaX : event.deltaX;
      const perPixel = (view.to - view.from) / width;
      if (Math.abs(sideways) > Math.abs(event.shiftKey ? 0 : event.deltaY))
        return shift(view, sideways * perPixel);
      const x = Math.min(Math.max(event.clientX - left, 0), width);
      return show(
        zoomView(
          view,
          Math.exp(-event.deltaY * WHEEL_ZOOM),
          view.from + x * perPixel,
          bounds(whole),
        ),
        whole,
      );
    },
    { passive: false },
  );
  pane.addEventListener("pointerdown", (event) => {
    const { view, left } = shown();
    if (event.button !== 0 || event.clientX < left) return;
    grip = { x: event.clientX, view };
    pane.setPointerCapture(event.pointerId);
  });
  pane.addEventListener("pointermove", (event) => {
    if (!grip) return;
    const { width } = shown();
    shift(grip.view, ((grip.x - event.clientX) / width) * (grip.view.to - grip.view.from));
  });
  for (const end of ["pointerup", "pointercancel"]) pane.addEventListener(end, () => (grip = null));
  pane.addEventListener("dblclick", () => store.set({ replayView: null }));
}
