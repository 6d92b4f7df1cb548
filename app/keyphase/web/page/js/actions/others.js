/** What stands below the segments without being asked for: other tools, and labels others made. */

import { GIVEN } from "../model/recordings/recording_list.js";

/**
 * @param {import("../lib/store.js").Store} store
 * @param {any} actions
 */
export function showOthers(store, actions) {
  let seen = "";
  /** @type {string|null} */
  let offered = null;
  store.later(["recording"], ({ document: doc }) => doc && actions.askLanes());
  // Another tool whose line of the list changed was worked on.
  store.later(["recordings"], ({ recordings, lanes }) => {
    const now = JSON.stringify(
      lanes.map(({ id }) => recordings.items.find((one) => one.id === id)?.strip),
    );
    if (now === seen) return;
    const isNews = seen !== "" && lanes.length > 0;
    seen = now;
    if (isNews) actions.askLanes();
  });
  // Labels that others made are shown once; whoever closes them has seen them.
  store.later(["comparison"], ({ comparison, recording, document: doc }) => {
    if (!comparison || !doc || offered === recording) return;
    offered = recording;
    if (comparison.with === null && comparison.options.includes(GIVEN) && doc.edits === 0)
      actions.compare(GIVEN);
  });
}
