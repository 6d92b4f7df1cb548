/** Keeps the page's address in step with what is shown, and goes where an address says. */

import { addressIn, addressOf } from "../model/address.js";

/** So long the playhead rests before the address follows it. */
const RESTS_MS = 400;

/**
 * @param {import("../lib/store.js").Store} store
 * @param {any} actions
 */
export function createAddress(store, actions) {
  const { state } = store;
  /** Where the address leads, as long as we are not there. */
  let wanted = addressIn(location.hash);
  let shown = "";
  let timer = 0;
  /** What was shown when the connection broke. @type {object|null} */
  let left = null;

  /** Opens the recording the address names, then goes to its time. */
  function go() {
    if (!wanted) return;
    const item = state.recordings.items.find(({ name }) => name === wanted.name);
    if (!item) return;
    if (state.document?.id !== item.id) return actions.open(item.id);
    const { time } = wanted;
    wanted = null;
    if (time !== null && !state.playhead.playing) actions.goTo(time);
  }

  function write(time) {
    const doc = state.document;
    if (!doc || wanted) return;
    const address = addressOf(doc.name, time);
    if (address === location.hash) {
      // It was opened by this address, or is shown anew.
      shown = address;
      return;
    }
    // One step back for each recording, not for each place of the playhead.
    const other = addressIn(shown)?.name !== doc.name;
    history[other && shown ? "pushState" : "replaceState"](null, "", address);
    shown = address;
  }

  // A server that was started anew knows no playhead: the page brings its own back.
  store.on(["connected"], ({ connected, document: doc, clock, following }) => {
    if (connected === false && doc && !wanted && !following)
      wanted = { name: doc.name, time: clock || null };
    left = doc;
  });
  store.later(["document"], ({ connected, document: doc }) => connected && doc !== left && go());
  store.later(["recordings"], () => state.document === null && go());
  store.later(["recording"], () => {
    go();
    write(null);
  });
  store.later(["clock"], ({ clock, playhead }) => {
    clearTimeout(timer);
    if (!playhead.playing) timer = setTimeout(() => write(clock || null), RESTS_MS);
  });
  addEventListener("popstate", () => {
    wanted = addressIn(location.hash);
    shown = location.hash;
    go();
  });
}
