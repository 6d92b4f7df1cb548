/** Bringing a time into view without changing how much is seen. */

import { clampView } from "../lib/scale.js";

/** @param {import("../lib/store.js").Store} store @param {number} time */
export function reveal({ state, set }, time) {
  const { view } = state;
  if (!view || (time >= view.from && time <= view.to)) return;
  const half = (view.to - view.from) / 2;
  set({ view: clampView(time - half, time + half, state.document) });
}
