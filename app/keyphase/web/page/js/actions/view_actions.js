/** What a person looks at: how near, which scale, which order, light or dark. */

import { clampView, zoomView } from "../lib/scale.js";

/** @param {import("../lib/store.js").Store} store */
export function createViewActions(store) {
  const { state } = store;
  const doc = () => state.document;
  return {
    zoom(factor, anchor = state.clock) {
      if (!doc()) return;
      const { view } = state;
      const inside = anchor >= view.from && anchor <= view.to;
      store.set({
        view: zoomView(view, factor, inside ? anchor : (view.from + view.to) / 2, doc()),
      });
    },
    /** Zooms to what is selected, and back to what was seen before. */
    zoomToSelection() {
      const segment = doc()?.segments[state.selected];
      if (!segment) return;
      const { view, viewBefore } = state;
      const margin = 0.15 * (segment.end_s - segment.start_s);
      const wanted = clampView(segment.start_s - margin, segment.end_s + margin, doc());
      const isThere = Math.abs(view.from - wanted.from) + Math.abs(view.to - wanted.to) < 1e-6;
      if (!isThere) store.set({ view: wanted, viewBefore: view });
      else if (viewBefore) store.set({ view: viewBefore, viewBefore: null });
    },
    fit: () => doc() && store.set({ view: { from: doc().start_s, to: doc().end_s } }),
    toggleSnap: () => store.set({ snap: !state.snap }),
    toggleScale: () => store.set({ logarithmic: !state.logarithmic }),
    toggleOrder: () => store.set({ leastCertainFirst: !state.leastCertainFirst }),
    toggleTheme: () => store.set({ dark: !state.dark }),
  };
}
