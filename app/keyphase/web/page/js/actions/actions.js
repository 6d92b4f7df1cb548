/**
 * Everything a person can do, as one function each: what keys, buttons, menus, the palette and
 * gestures call. Nothing here draws; the server answers with what came of it.
 */

import { segmentAt } from "../model/segments.js";
import { createBoundaryActions } from "./boundary_actions.js";
import { createPlaybackActions } from "./playback_actions.js";
import { createSegmentActions } from "./segment_actions.js";
import { createCameraActions } from "./camera_actions.js";
import { createExportActions } from "./export_actions.js";
import { createPanelActions } from "./panel_actions.js";
import { createPlanActions } from "./plan_actions.js";
import { createDoubtActions } from "./doubt_actions.js";
import { createGridActions } from "./grid_actions.js";
import { createViewActions } from "./view_actions.js";
import { createRecordingActions } from "./recording_actions.js";
import { createParameterActions, refuses } from "./parameter_actions.js";

/**
 * @param {import("../lib/store.js").Store} store
 * @param {import("../model/types.js").Send} send
 * @param {ReturnType<typeof import("../model/latency.js").createLatency>} latency
 * @param {ReturnType<typeof import("../model/own_changes.js").createOwnChanges>} own
 */
export function createActions(store, send, latency, own) {
  const { state } = store;
  const doc = () => state.document;

  /** One edit; numbered, so that the page can tell how long it took to see. */
  function edit(change) {
    if (!doc() || refuses(store)) return;
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

  /** What all windows see; one that may only look keeps it to itself. */
  const share = (message) => !state.lookingOnly && send(message);

  const actions = {
    send,
    open(id) {
      store.set({ asked: id });
      return send({ type: "open", id });
    },

    undo: () => !state.readOnly && send({ type: "undo" }),
    redo: () => !state.readOnly && send({ type: "redo" }),
    resetEdits: () => edit({ kind: "reset" }),
    forgetLabel: (label) => send({ type: "forget_label", label }),
    bringBack: (index) => edit({ kind: "bring_back", edit: index }),
    forget: (index) => edit({ kind: "forget", edit: index }),
  };
  return Object.assign(
    actions,
    createPlaybackActions(store, share),
    createBoundaryActions(store, edit, actions),
    createSegmentActions(
      store,
      { edit, onSegment, selectedSegment, share, selecting: own.selecting },
      actions,
    ),
    createPlanActions(store, { edit, onSegment }),
    createDoubtActions(store, actions),
    createViewActions(store),
    createParameterActions(store, send, latency, own),
    createRecordingActions(store, send, actions),
    createGridActions(store, send, actions),
    createPanelActions(store, send),
    createExportActions(store, send),
    createCameraActions(store, edit, actions),
  );
}
