/**
 * A label's number held down while the recording plays: what plays meanwhile becomes one segment of
 * that name. A short press names the segment at the playhead, as it does at rest.
 */

import { nearestEvidence } from "../../model/snapping.js";

/** A shorter press is meant for the segment that is there. */
const LEAST_MS = 250;
/** As far is looked for evidence of where the stretch really began and ended. */
const REACH_S = 0.12;

/**
 * @param {import("../../lib/store.js").Store} store
 * @param {{labelByNumber: (number: number) => void,
 *   nameStretch: (from: number, to: number, label: string) => void}} actions
 */
export function createHeldLabel(store, actions) {
  const { state } = store;
  /** @type {{code: string, number: number, id: string, since: number}|null} */
  let down = null;

  const snapped = (time) => (state.snap && nearestEvidence(state, time, REACH_S)?.time) || time;

  function end() {
    const { naming, document: doc } = state;
    const held = down;
    down = null;
    store.set({ naming: null });
    if (!held || !naming || doc?.id !== held.id) return;
    if (performance.now() - held.since < LEAST_MS) return actions.labelByNumber(held.number);
    // A playhead that has begun anew had come to the end.
    const to = state.clock > naming.from_s ? state.clock : doc.end_s;
    actions.nameStretch(snapped(naming.from_s), snapped(to), naming.label);
  }

  store.on(["playhead"], ({ playhead }) => down && !playhead.playing && end());
  store.on(["recording"], () => {
    down = null;
    store.set({ naming: null });
  });
  addEventListener("blur", () => down && end());
  return {
    /** @param {KeyboardEvent} event @param {number} number @returns {boolean} whether it is held from now on */
    press({ code, repeat }, number) {
      if (down) return true;
      const label = state.labels[number - 1]?.name;
      const { playing, speed } = state.playhead;
      if (repeat || !label || !playing || speed < 0 || state.readOnly) return repeat;
      down = { code, number, id: state.document.id, since: performance.now() };
      store.set({ naming: { from_s: state.clock, label } });
      return true;
    },
    /** @param {KeyboardEvent} event */
    release: ({ code }) => void (down?.code === code && end()),
  };
}
