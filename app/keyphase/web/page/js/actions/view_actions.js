/** What a person looks at: how near, which scale, which order, light or dark. */

import { clampView, zoomView } from "../lib/scale.js";
import { chosenStretch } from "../model/segments.js";

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
      const [first, last] = chosenStretch(state) ?? [];
      const from = doc()?.segments[first]?.start_s;
      const to = doc()?.segments[last]?.end_s;
      if (from === undefined || to === undefined) return;
      const { view, viewBefore } = state;
      const margin = 0.15 * (to - from);
      const wanted = clampView(from - margin, to + margin, doc());
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
