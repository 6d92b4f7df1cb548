/** What is proposed for the recording that is shown, from those of its folder that are done. */

import { ANOTHER, PROPOSED, proposedHere } from "../model/recordings/recording_list.js";

/**
 * Shows what is proposed beside the recording as soon as there is something, once for each.
 * @param {import("../lib/store.js").Store} store
 * @param {{compare: (other: string|null) => void}} actions
 */
export function showProposals(store, actions) {
  let shown = "";
  store.later(["recording", "recordings"], (state) => {
    if (state.recording !== shown && !proposedHere(state)) shown = "";
    if (!proposedHere(state) || shown === state.recording) return;
    shown = state.recording ?? "";
    actions.compare(PROPOSED);
  });
}

/**
 * Shows another person's segments beside the recording, where there are any, once for each.
 * @param {import("../lib/store.js").Store} store
 * @param {{compare: (other: string|null) => void}} actions
 */
export function showAnother(store, actions) {
  let shown = "";
  store.later(["recording", "recordings"], ({ recording, recordings }) => {
    const line = recordings.items.find(({ id }) => id === recording);
    if (!recording || shown === recording || !line || line.differences === null) return;
    shown = recording;
    actions.compare(ANOTHER);
  });
}
