/**
 * Everything a person can do, as one function each: what keys, buttons, menus, the palette and
 * gestures call. Nothing here draws; the server answers with what came of it.
 */

import { middle, segmentAt } from "../model/segments.js";
import { SPEEDS } from "../model/playback.js";
import { createPanelActions } from "./panel_actions.js";
import { createPlanActions } from "./plan_actions.js";
import { createDoubtActions } from "./doubt_actions.js";
import { createViewActions } from "./view_actions.js";
import { createRecordingActions } from "./recording_actions.js";
import { nearestEvidence, REACH_PX } from "../model/snapping.js";
import { clampView } from "../lib/scale.js";

/** What of the playhead is asked for by playing. */
const PLAYED = ["playing", "speed", "loop"];

/**
 * @param {import("../lib/store.js").Store} store
 * @param {import("../model/types.js").Send} send
 * @param {ReturnType<typeof import("../model/latency.js").createLatency>} latency
 * @param {ReturnType<typeof import("../model/own_changes.js").createOwnChanges>} own
 */
export function createActions(store, send, latency, own) {
  const { state } = store;
  const doc = () => state.document;

  /** Whether nothing may be changed now; where a person could not know, they are told. */
  function refuses() {
    if (state.connected === false)
      store.set({
        notice: { level: "warning", text: "keyphase is not running: nothing was changed." },
      });
    return state.readOnly;
  }

  /** One edit; numbered, so that the page can tell how long it took to see. */
  function edit(change) {
    if (!doc() || refuses()) return;
    store.set({ saving: true });
    const timeStamp = window.event?.timeStamp ?? performance.now();
    const event = latency.began(timeStamp, "edit");
    if (send({ type: "edit", edit: change, event })) own.edited(event, change);
    else store.set({ saving: false });
  }

  function selectedSegment() {
    const index = state.selected ?? (doc() ? segmentAt(doc(), state.clock) : null);
    return index === null ? null : { index, segment: doc()?.segments[index] };
  }

  function onSegment(action, index = selectedSegment()?.index) {
    const segment = doc()?.segments[index];
    if (segment) action(segment, index);
  }

  /** Brings a time into view without changing how much is seen. */
  function reveal(time) {
    const { view } = state;
    if (!view || (time >= view.from && time <= view.to)) return;
    const half = (view.to - view.from) / 2;
    store.set({ view: clampView(time - half, time + half, doc()) });
  }

  /** What all windows see; one that may only look keeps it to itself. */
  const share = (message) => !state.lookingOnly && send(message);

  /**
   * What was asked of the playhead and not told back yet: the next change follows it.
   * @type {import("../model/types.js").Playhead|null}
   */
  let asked = null;
  const wanted = () => asked ?? state.playhead;
  store.on(["playhead"], ({ playhead }) => {
    if (PLAYED.every((name) => playhead[name] === asked?.[name])) asked = null;
  });
  store.on(["connected", "recording"], () => (asked = null));

  const actions = {
    send,
    open: (id) => send({ type: "open", id }),
    exportAs: (kind) => doc() && send({ type: "export", kind }),
    /**
     * Once more, after files were in the way.
     * @param {import("../messages/list_messages").InTheWayMessage} inTheWay
     * @param {"replace"|"keep both"} ifThere
     */
    exportAgain: ({ recording, kind }, ifThere) =>
      send({ type: "export", recording, kind: /** @type {any} */ (kind), if_there: ifThere }),

    seek(time) {
      if (!doc()) return;
      const at = Math.min(Math.max(time, doc().start_s), doc().end_s);
      store.set({ clock: at });
      share({ type: "seek", time_s: at });
    },
    play(change = {}) {
      const playhead = { ...wanted(), ...change };
      const { playing, speed, loop } = playhead;
      if (!doc() || !share({ type: "play", playing, speed, loop })) return;
      asked = playhead;
    },
    togglePlay: () => actions.play({ playing: !wanted().playing }),
    toggleLoop: () => actions.play({ loop: !wanted().loop }),
    setSpeed: (speed) => actions.play({ speed }),
    /** The next higher speed, or the next lower one. */
    changeSpeed(direction) {
      const at = SPEEDS.indexOf(wanted().speed) + direction;
      if (SPEEDS[at]) actions.setSpeed(SPEEDS[at]);
    },
    toStart: () => doc() && actions.goTo(doc().start_s),
    toEnd: () => doc() && actions.goTo(doc().end_s),
    goTo(time) {
      actions.seek(time);
      reveal(time);
    },

    /** Goes to the next boundary in time, or the previous one. */
    step(direction) {
      if (!doc()) return;
      const times = doc().boundaries.map((boundary) => boundary.time_s);
      const beyond =
        direction > 0
          ? times.findIndex((time) => time > state.clock + 1e-4)
          : times.findLastIndex((time) => time < state.clock - 1e-4);
      if (beyond < 0) return direction > 0 ? actions.toEnd() : actions.toStart();
      return actions.visit(beyond);
    },
    /** Makes a boundary the current one and shows why it is there. */
    visit(index) {
      store.set({ current: index, explained: index });
      actions.goTo(doc().boundaries[index].time_s);
    },

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
      reveal(middle(doc().segments[index]));
    },

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
      if (boundary.unsure) actions.nextDoubt();
    },
    moveBoundary(from, to) {
      if (Math.abs(to - from) > 1e-6) edit({ kind: "move", from_s: from, to_s: to });
    },
    nudge(direction) {
      const boundary = doc()?.boundaries[state.current];
      if (boundary)
        actions.moveBoundary(
          boundary.time_s,
          boundary.time_s + direction * Math.max(0.01, 1 / doc().rate_hz),
        );
    },
    acceptBoundary(index = state.current) {
      const boundary = doc()?.boundaries[index];
      if (boundary && !boundary.accepted) edit({ kind: "accept", time_s: boundary.time_s });
    },
    acceptAndGoOn(index) {
      actions.acceptBoundary(index);
      actions.nextDoubt();
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
      reveal(middle(doc().segments[next]));
    },
    acceptNames: () => edit({ kind: "accept_labels" }),
    /** Enter: the boundary shown, or the name of the segment that was selected; nothing else. */
    accept() {
      const index = state.explained ?? state.current;
      const boundary = doc()?.boundaries[index];
      if (boundary) return boundary.accepted ? actions.nextDoubt() : actions.acceptAndGoOn(index);
      const segment = doc()?.segments[state.selected];
      if (segment?.proposed) return actions.label(segment.label, state.selected);
      return segment ? undefined : actions.nextDoubt();
    },
    rename(index = selectedSegment()?.index) {
      if (index !== undefined && index !== null && !state.readOnly) store.set({ renaming: index });
    },

    undo: () => !state.readOnly && send({ type: "undo" }),
    redo: () => !state.readOnly && send({ type: "redo" }),
    resetEdits: () => edit({ kind: "reset" }),
    resetParameters: () => send({ type: "reset" }),
    /**
     * A parameter as it is being held, or as it was let go; null is the automatic value.
     * @param {string} name
     * @param {*} value
     * @param {boolean} held
     * @param {Event} [input] what the hand did
     * @param {import("../model/latency.js").Source} [source]
     */
    setParameter(name, value, held, input, source = "slider") {
      if (!doc() || refuses()) return;
      const event = latency.began(input?.timeStamp ?? performance.now(), source);
      if (send({ type: "set", parameter: name, value, event, held }))
        own.moved(event, name, value, held);
    },
    automaticThreshold: (name = "force_threshold") => actions.setParameter(name, null, false),

    forgetLabel: (label) => send({ type: "forget_label", label }),
    bringBack: (index) => edit({ kind: "bring_back", edit: index }),
    forget: (index) => edit({ kind: "forget", edit: index }),
  };
  return Object.assign(
    actions,
    createPlanActions(store, { edit, onSegment }),
    createDoubtActions(store, actions),
    createViewActions(store),
    createRecordingActions(store, send, actions),
    createPanelActions(store, send),
  );
}
