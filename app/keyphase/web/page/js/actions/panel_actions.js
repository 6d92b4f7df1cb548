/** What the panel asks for: recording, the world of a replay, trials, the robot, what is shown. */

import { addressOf } from "../model/address.js";

/**
 * @param {import("../lib/store.js").Store} store
 * @param {import("../model/types.js").Send} send
 */
export function createPanelActions(store, send) {
  const own = {
    show: (what, visible) => send({ type: "show", what, visible }),
    toggleRobot: () => !store.state.lookingOnly && own.show("robot", !store.state.shown.robot),
    /** @param {"open"|"close"|"start"|"stop"|"reset"|"undo_take"|"redo_take"} what */
    record: (what, workcell = null) => send({ type: "record", do: what, workcell }),
    replaySettings: (changed) => send({ type: "replay_settings", ...changed }),
    push: (offered) => send({ type: "push", offered }),
    trials: (count) => send({ type: "trials", count }),
    /** @param {"begin"|"cancel"} what */
    margin: (what) => send({ type: "margin", do: what }),
    cancelTrials: () => send({ type: "trials_cancel" }),
    robot: (changed) => send({ type: "robot", ...changed }),
    /** Goes where another page goes; null: no longer. @param {string|null} page */
    follow: (page) => send({ type: "follow", page }),
    copyAddress: ({ name }) => own.copy(`${location.origin}/${addressOf(name, null)}`),
    async copy(text) {
      try {
        await navigator.clipboard.writeText(text);
        store.set({ notice: { level: "info", text: "Copied." } });
      } catch {
        store.set({
          notice: { level: "warning", text: "This browser does not let the page copy." },
        });
      }
    },
  };
  return own;
}
