/** What is proposed for the recording that is shown, from those of its folder that are done. */

import { ANOTHER, PROPOSED, proposedHere } from "../model/recordings/recording_list.js";

/** The recording whose proposal is beside it, and what that was. @typedef {{recording: string|null, what: string}} Shown */

/** @type {Shown} */
const NOTHING = { recording: null, what: "" };

/**
 * What is shown beside the recording from now on, and whether that is asked for: once something is
 * proposed, and whenever that becomes another, for Shift Enter takes over the newest. Where a
 * person closed it, or compares with something else, it stays so.
 * @param {Shown} before
 * @param {Pick<import("../lib/store.js").State, "recording"|"recordings"|"comparison">} state
 * @returns {{shown: Shown, ask: boolean}}
 */
export function followed(before, { recording, recordings, comparison }) {
  const line = proposedHere({ recording, recordings });
  if (!line) return { shown: NOTHING, ask: false };
  const what = JSON.stringify([line.proposed_from, line.proposed_confidence, line.differs]);
  const isAnother = before.recording !== recording;
  const isWanted = isAnother || !comparison || comparison.with === PROPOSED;
  const ask = isWanted && (isAnother || before.what !== what);
  return { shown: { recording, what }, ask };
}

/**
 * Shows what is proposed beside the recording as long as nobody closes it.
 * @param {import("../lib/store.js").Store} store
 * @param {{compare: (other: string|null) => void}} actions
 */
export function showProposals(store, actions) {
  let shown = NOTHING;
  store.later(["recording", "recordings"], (state) => {
    const now = followed(shown, state);
    shown = now.shown;
    if (now.ask) actions.compare(PROPOSED);
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
