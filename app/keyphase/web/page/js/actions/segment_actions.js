/** Selecting, naming, keeping, dropping and merging segments. */

import { middle, segmentAt } from "../model/segments.js";
import { reveal } from "./reveal.js";

/**
 * @param {import("../lib/store.js").Store} store
 * @param {{edit: (change: import("../model/types.js").Edit) => void,
 *   onSegment: (action: (segment: import("../model/types.js").Segment, index: number) => void,
 *     index?: number) => void,
 *   selectedSegment: () => {index: number}|null, share: import("../model/types.js").Send}} given how things are asked for and shown
 * @param {any} others actions these build on
 */
export function createSegmentActions(store, { edit, onSegment, selectedSegment, share }, others) {
  const { state } = store;
  const doc = () => state.document;
  const actions = {
    /** @param {number|null} index */
    select(index) {
      if (!doc()) return;
      store.set({ selected: index });
      share({ type: "select", segment: index });
    },
    selectNext(direction) {
      if (!doc()) return;
      const last = doc().segments.length - 1;
      const from = state.selected ?? segmentAt(doc(), state.clock) - direction;
      const index = Math.min(Math.max(from + direction, 0), last);
      actions.select(index);
      reveal(store, middle(doc().segments[index]));
    },

    merge() {
      onSegment((_, index) => {
        if (index < doc().segments.length - 1) actions.mergeRange(index, index + 1);
      });
    },
    mergeRange(first, last) {
      const { segments } = doc();
      edit({ kind: "merge", from_s: middle(segments[first]), to_s: middle(segments[last]) });
      actions.select(first);
    },
    toggleDrop: (index) =>
      onSegment(
        (segment) => edit({ kind: "keep", time_s: middle(segment), kept: !segment.kept }),
        index,
      ),
    dropIdle: () => edit({ kind: "drop_idle" }),
    /** @param {import("../model/types.js").Segment} segment @param {Object|null} end null: the proposed one */
    setEnd: (segment, end) => edit({ kind: "end", time_s: middle(segment), end }),
    label: (label, index) =>
      onSegment((segment) => edit({ kind: "label", time_s: middle(segment), label }), index),
    labelByNumber(number) {
      const known = state.labels[number - 1];
      const index = selectedSegment()?.index;
      if (!known || index === undefined || state.readOnly) return;
      actions.label(known.name, index);
      actions.selectKeptAfter(index);
    },
    /** Selects the next segment that is kept, so that names follow each other. */
    selectKeptAfter(index) {
      const next = doc().segments.findIndex(({ kept }, k) => k > index && kept);
      if (next < 0) return;
      actions.select(next);
      reveal(store, middle(doc().segments[next]));
    },
    acceptNames: () => edit({ kind: "accept_labels" }),
    /** Enter: the boundary shown, or the name of the segment that was selected; nothing else. */
    accept() {
      const index = state.explained ?? state.current;
      const boundary = doc()?.boundaries[index];
      if (boundary) return boundary.accepted ? others.nextDoubt() : others.acceptAndGoOn(index);
      const segment = doc()?.segments[state.selected];
      if (segment?.proposed) return actions.label(segment.label, state.selected);
      return segment ? undefined : others.nextDoubt();
    },
    rename(index = selectedSegment()?.index) {
      if (index === undefined || index === null || state.readOnly) return;
      store.set({ renaming: index });
      store.drawNow();
    },
  };
  return actions;
}
