/** What a person can do with whole recordings: finish, compare, share, go from one to the next. */

import { plural } from "../lib/format.js";
import {
  ANOTHER,
  nextDiffering,
  nextUndone,
  PROPOSED,
  proposedHere,
  recordingBeside,
} from "../model/recordings/recording_list.js";
import { unsureBoundaries } from "../model/unsure.js";

/**
 * @param {import("../lib/store.js").Store} store
 * @param {import("../model/types.js").Send} send
 * @param {any} actions those these build on
 */
export function createRecordingActions(store, send, actions) {
  const { state } = store;
  const doc = () => state.document;
  const own = {
    /** Done, also as it is after changes, or not after all. */
    toggleDone: () => own.setDone(doc().state !== "done" || doc().changed_since_done),
    /** Says that a recording is done, or not after all. */
    setDone(done) {
      if (doc() && !state.readOnly) send({ type: "done", done });
    },
    /** Asks how a recording is read that cannot be read as it is. */
    describe: (recording) => !state.readOnly && send({ type: "describe", recording }),
    doneAndOn() {
      if (state.readOnly) return;
      const undecided = unsureBoundaries(doc()).length;
      const next = nextUndone(state);
      own.setDone(true);
      store.set({ notice: { level: "info", text: farewell(undecided, next), of: next?.id } });
      if (next) actions.open(next.id);
      else own.showTab("export");
    },
    /** "look" what these parameters would change in the other recordings, "apply" it, or "leave" it. */
    spread: (step, includeDone = false) =>
      !state.readOnly && send({ type: "spread", step, include_done: includeDone }),
    /** Beside which segmentation this one is shown; null asks which there are. */
    compare(other) {
      if (other === null) store.set({ comparison: null });
      if (doc()) send({ type: "compare", with: other });
    },
    /** Asks what the other tools did that were recorded at the same time. */
    askLanes: () => send({ type: "lanes" }),
    toggleCompare: () => own.compare(state.comparison?.with ? null : "automatic"),
    /** Goes to the next boundary that only one of the two has. */
    visitDifference(direction) {
      if (!state.comparison?.with) return;
      const times = state.comparison.differs_s;
      const next =
        direction > 0
          ? times.find((time) => time > state.clock + 1e-4)
          : times.findLast((time) => time < state.clock - 1e-4);
      if (next === undefined && state.comparison.with === ANOTHER)
        return own.nextDiffering(direction);
      if (next === undefined)
        return store.set({
          notice: {
            level: "info",
            text: times.length ? "No further difference." : "Both have the same boundaries.",
          },
        });
      return actions.goTo(next);
    },
    /** Goes on to the next recording in which another person's segments differ. */
    nextDiffering(direction) {
      const next = nextDiffering(state, direction);
      const text = next
        ? `${next.name}: ${plural(next.differences ?? 0, "difference")}, J goes to the first.`
        : "No further difference in any recording.";
      store.set({ notice: { level: "info", text, of: next?.id } });
      if (next) actions.open(next.id);
    },
    /** Takes over what is proposed from finished recordings; where nothing is, all names. */
    acceptAll() {
      const proposed = proposedHere(state);
      if (!proposed) return actions.acceptNames();
      if (state.readOnly) return undefined;
      actions.doubtsOfProposal(proposed.differs);
      send({ type: "take_over", from: PROPOSED });
      return own.compare(null);
    },
    /** Makes the other segmentation this recording's, as one step. */
    takeOver() {
      const from = state.comparison?.with;
      if (from === PROPOSED && proposedHere(state)) return own.acceptAll();
      if (from && !state.readOnly) send({ type: "take_over", from });
      return undefined;
    },
    /** The recording as it now is, without what was made of it as it was. */
    startOver() {
      actions.resetEdits();
      own.keepLabels();
    },
    /** Takes over what was done to the same bytes under another name. */
    takeJournal: () => send({ type: "take_journal" }),
    keepLabels: () => send({ type: "keep_labels" }),

    openDemonstration() {
      if (send({ type: "open_demonstration" })) store.set({ firstSteps: true });
    },
    /** To where a first one can be recorded. */
    recordFirst: () => own.showTab("record"),
    /** Opens a tab of the panel, which is a drawer in a narrow window. @param {string} tab */
    showTab: (tab) => store.set({ tab, drawer: "panel" }),

    nextRecording(direction) {
      const next = recordingBeside(state, direction);
      if (next) actions.open(next.id);
    },
    leastCertain() {
      const least = leastCertainOf(state.recordings);
      if (least) actions.open(least.id);
    },
  };
  return own;
}

/** What a recording that is called done leaves behind, and where one goes. */
function farewell(undecided, next) {
  const left = undecided
    ? ` with ${plural(undecided, "boundary", "boundaries")} unsure (Ctrl Z)`
    : "";
  return next
    ? `Done${left}. Next: ${next.name}.`
    : `Done${left}. No recording is left: export them.`;
}

/** The recording with the lowest confidence that is not done. */
export function leastCertainOf({ items }) {
  const open = items.filter(
    (item) => item.state !== "done" && item.confidence !== null && !item.error,
  );
  return open.reduce(
    (least, item) => (least && least.confidence <= item.confidence ? least : item),
    null,
  );
}
