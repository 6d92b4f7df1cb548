/** Two fingers on the timeline: apart is closer, together is further, and the view goes with them. */

import { clampView } from "./scale.js";

/** So near together two fingers would zoom by far more than they move. */
const LEAST_PX = 20;

/**
 * @param {import("./store.js").Store} store
 * @param {any} timeline
 */
export function createPinch(store, timeline) {
  /** @type {Map<number, number>} where each finger is, px from the plot's left edge */
  const fingers = new Map();
  /** The times under the two fingers, kept under them. @type {[number, number]|null} */
  let grabbed = null;

  const both = () => [...fingers.values()].slice(0, 2);

  return {
    /** A finger came down; whether there are two of them now. */
    down(event, x) {
      if (event.pointerType !== "touch") return false;
      fingers.set(event.pointerId, x);
      if (fingers.size < 2) return false;
      const [a, b] = both().map((at) => timeline.scale().time(at));
      grabbed = [a, b];
      return true;
    },
    /** A finger moved; whether that was part of a pinch. */
    move(event, x) {
      if (!fingers.has(event.pointerId)) return false;
      fingers.set(event.pointerId, x);
      if (!grabbed) return false;
      const [left, right] = both();
      const { document: doc, plotWidth } = store.state;
      const apart = right - left;
      if (Math.abs(apart) < LEAST_PX) return true;
      const perPixel = (grabbed[1] - grabbed[0]) / apart;
      const from = grabbed[0] - left * perPixel;
      if (perPixel > 0) store.set({ view: clampView(from, from + plotWidth * perPixel, doc) });
      return true;
    },
    /** A finger left; whether the pinch goes on or has just ended. */
    up(event) {
      const was = grabbed !== null;
      fingers.delete(event.pointerId);
      if (!fingers.size) grabbed = null;
      return was;
    },
  };
}
