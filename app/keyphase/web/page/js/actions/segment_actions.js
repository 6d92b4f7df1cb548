/** Selecting, naming, keeping, dropping and merging segments. */

import { chosenStretch, middle, segmentAt } from "../model/segments.js";
import { reveal } from "./reveal.js";

/**
 * @param {import("../lib/store.js").Store} store
 * @param {{edit: (change: import("../model/types.js").Edit) => void,
 *   onSegment: (action: (segment: import("../model/types.js").Segment, index: number) => void,
 *     index?: number) => void,
 *   selectedSegment: () => {index: number}|null, share: import("../model/types.js").Send,
 *   selecting: (index: number|null) => void}} given how things are asked for and shown
 * @param {any} others actions these build on
 */
export function createSegmentActions(store, given, others) {
  const { edit, onSegment, selectedSegment, share, selecting } = given;
  const { state } = store;
  const doc = () => state.document;
  /** Where more than one is chosen: first, last. */
  const several = () => {
    const chosen = doc() && chosenStretch(state);
    return chosen && chosen[0] < chosen[1] ? chosen : null;
  };
  /** What an edit is about: the chosen ones where it was asked of one of them, else that one. */
  function meant(index) {
    const [first, last] = several() ?? [0, -1];
    const { segments } = doc();
    if (index !== undefined && (index < first || index > last))
      return { segments: [segments[index]], place: { time_s: middle(segments[index]) } };
    const place = { time_s: middle(segments[first]), to_s: middle(segments[last]) };
    return { segments: segments.slice(first, last + 1), place };
  }
  const actions = {
    /** @param {number|null} index */
    select(index) {
      if (!doc()) return;
      store.set({ selected: index, selectedTo: null });
      if (share({ type: "select", segment: index })) selecting(index);
    },
    selectNext(direction) {
      if (!doc()) return;
      const last = doc().segments.length - 1;
      const from = state.selected ?? segmentAt(doc(), state.clock) - direction;
      const index = Math.min(Math.max(from + direction, 0), last);
      actions.select(index);
      reveal(store, middle(doc().segments[index]));
    },

    /** Draws the choice out to a segment, from the selected one. @param {number} index */
    selectTo(index) {
      if (!doc()?.segments[index]) return;
      if (state.selected === null) return actions.select(index);
      const to = index === state.selected ? null : index;
      store.set({ selectedTo: to });
      if (share({ type: "select", segment: state.selected, to })) selecting(state.selected);
    },
    /** Draws the choice out by one segment, or takes it back. */
    selectFurther(direction) {
      if (!doc()) return;
      if (state.selected === null) return actions.selectNext(direction);
      const to = (state.selectedTo ?? state.selected) + direction;
      const index = Math.min(Math.max(to, 0), doc().segments.length - 1);
      actions.selectTo(index);
      reveal(store, middle(doc().segments[index]));
    },

    merge() {
      if (several()) return actions.mergeRange(...several());
      onSegment((_, index) => {
        if (index < doc().segments.length - 1) actions.mergeRange(index, index + 1);
      });
    },
    mergeRange(first, last) {
      const { segments } = doc();
      edit({ kind: "merge", from_s: middle(segments[first]), to_s: middle(segments[last]) });
      actions.select(first);
    },
    /** Drops what is kept of the chosen ones; keeps them where none is. */
    toggleDrop: (index) =>
      onSegment((_, at) => {
        const { segments, place } = meant(at);
        edit({ kind: "keep", ...place, kept: !segments.some(({ kept }) => kept) });
      }, index),
    dropIdle: () => edit({ kind: "drop_idle" }),
    /** @param {import("../model/types.js").Segment} segment @param {Object|null} end null: the proposed one */
    setEnd: (segment, end) => edit({ kind: "end", time_s: middle(segment), end }),
    label: (label, index) =>
      onSegment((_, at) => edit({ kind: "label", ...meant(at).place, label }), index),
    acceptName: (index) =>
      onSegment(
        (segment) => edit({ kind: "label", time_s: middle(segment), label: segment.label }),
        index,
      ),
    labelByNumber(number) {
      const known = state.labels[number - 1];
      const index = selectedSegment()?.index;
      if (index === undefined || state.readOnly) return;
      if (!known) {
        const text = `No name has the number ${number} yet. L names a segment; the phases of the task (Shift G) have the first numbers.`;
        store.set({ notice: { level: "info", text } });
        return;
      }
      const last = several()?.[1] ?? index;
      actions.label(known.name, index);
      actions.selectKeptAfter(last);
    },
    /** Selects the next segment that is kept, so that names follow each other. */
    selectKeptAfter(index) {
      const next = doc().segments.findIndex(({ kept }, k) => k > index && kept);
      if (next < 0) return;
      actions.select(next);
      reveal(store, middle(doc().segments[next]));
    },
    /** What one thinks of the recording as a whole: the parts that change. @param {Object} change */
    assess: (change) => doc() && edit({ kind: "assess", ...doc().assessment, ...change }),
    /** What one thinks of a segment, or of those that are chosen. @param {Object} change */
    assessSegment: (change, index) =>
      onSegment(
        ({ assessment }, at) =>
          edit({ kind: "assess_segment", ...meant(at).place, ...assessment, ...change }),
        index,
      ),
    /** Makes one segment of a stretch and names it. */
    nameStretch: (from, to, label) => edit({ kind: "name_stretch", from_s: from, to_s: to, label }),
    acceptNames: () => edit({ kind: "accept_labels" }),
    /** Enter: the boundary shown, or the name of the segment that was selected; nothing else. */
    accept() {
      const index = state.explained ?? state.current;
      const boundary = doc()?.boundaries[index];
      if (boundary) return boundary.accepted ? others.nextDoubt() : others.acceptAndGoOn(index);
      const segment = doc()?.segments[state.selected];
      if (segment?.proposed) return actions.acceptName(state.selected);
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
