/** Placing, moving, taking out and judging boundaries. */

import { nearestEvidence, REACH_PX } from "../model/snapping.js";

/**
 * @param {import("../lib/store.js").Store} store
 * @param {(change: import("../model/types.js").Edit) => void} edit
 * @param {any} others actions these build on
 */
export function createBoundaryActions(store, edit, others) {
  const { state } = store;
  const doc = () => state.document;
  const actions = {
    /** A boundary at the playhead; while playing, at the nearest evidence. */
    split() {
      if (!doc()) return;
      const reach = Math.max(
        0.12,
        (REACH_PX * (state.view.to - state.view.from)) / state.plotWidth,
      );
      const evidence =
        state.playhead.playing && state.snap ? nearestEvidence(state, state.clock, reach) : null;
      edit({ kind: "add", time_s: evidence?.time ?? state.clock });
    },
    addBoundary: (time) => edit({ kind: "add", time_s: time }),
    /** Takes a boundary out; after an unsure one the next of them is shown. */
    removeBoundary(index = state.current) {
      const boundary = doc()?.boundaries[index];
      if (!boundary || state.readOnly) return;
      store.set({ current: null, explained: null });
      edit({ kind: "remove", time_s: boundary.time_s });
      if (boundary.unsure) others.nextDoubt();
    },
    /** @param {number} from @param {number} to @param {boolean} [ripples] all later ones go with it */
    moveBoundary(from, to, ripples = false) {
      if (Math.abs(to - from) <= 1e-6) return;
      if (ripples) edit({ kind: "ripple", from_s: from, by_s: to - from });
      else edit({ kind: "move", from_s: from, to_s: to });
    },
    /** Opens the time of the current boundary, or of the one nearest to the playhead, to be typed. */
    typeTime() {
      const { boundaries = [] } = doc() ?? {};
      if (!boundaries.length || state.readOnly) return;
      const away = ({ time_s: time }) => Math.abs(time - state.clock);
      const nearest = boundaries.reduce(
        (best, one, k) => (away(one) < away(boundaries[best]) ? k : best),
        0,
      );
      others.visit(state.current ?? nearest);
      store.drawNow();
      /** @type {HTMLElement|null} */ (document.querySelector("#why .typed-time"))?.focus();
    },
    nudge(direction, ripples = false) {
      const boundary = doc()?.boundaries[state.current];
      if (!boundary) return;
      const by = direction * Math.max(0.01, 1 / doc().rate_hz);
      actions.moveBoundary(boundary.time_s, boundary.time_s + by, ripples);
    },
    acceptBoundary(index = state.current) {
      const boundary = doc()?.boundaries[index];
      if (boundary && !boundary.accepted) edit({ kind: "accept", time_s: boundary.time_s });
    },
    acceptAndGoOn(index) {
      actions.acceptBoundary(index);
      others.nextDoubt();
    },
    toggleContact(index = state.current) {
      const boundary = doc()?.boundaries[index];
      if (boundary)
        edit({
          kind: "contact",
          time_s: boundary.time_s,
          contact_change: !boundary.contact_change,
        });
    },
  };
  return actions;
}
