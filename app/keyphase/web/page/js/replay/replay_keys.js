/** Keys while a replay is shown; what edits the demonstration has to wait until it is closed. */

import { keyOf } from "../actions/keys/commands.js";

/**
 * @param {import("../lib/store.js").Store} store
 * @param {any} actions
 * @param {import("../actions/keys/commands.js").Command[]} commands those that are always allowed go through
 * @returns {(event: KeyboardEvent) => boolean} whether the key was the replay's
 */
export function createReplayKeys(store, actions, commands) {
  const own = {
    Space: actions.toggle,
    ".": actions.next,
    H: actions.hold,
    F: () => store.set({ replayView: null }),
  };
  return (event) => {
    const { replay } = store.state;
    if (!replay || event.defaultPrevented || event.altKey || document.querySelector("dialog[open]"))
      return false;
    if (event.key === "Escape") {
      event.preventDefault();
      if (replay.phase === "over") actions.leave();
      else actions.stop();
      return true;
    }
    const target = /** @type {HTMLElement} */ (event.target);
    const key = keyOf(event);
    if (target?.closest?.("input:not([type=range]), textarea, select, [contenteditable]"))
      return true;
    if (["Space", "Enter"].includes(key) && target?.closest?.("button, [role=tab], summary, a"))
      return true;
    if (own[key]) {
      event.preventDefault();
      own[key]();
      return true;
    }
    return !commands.some((command) => command.always && command.keys.includes(key));
  };
}
