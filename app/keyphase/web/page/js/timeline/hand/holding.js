/** The one thing that is held on the timeline. */

import { recordingStands } from "../../model/held.js";

/**
 * What another document took away is let go, and nothing more is asked for: it would be done to
 * what stands in its place.
 * @param {import("../../lib/store.js").Store} store
 * @param {HTMLElement} surface
 */
export function createHolding(store, surface) {
  /** @type {import("./gestures.js").Gesture|null} */
  let held = null;
  /** @type {import("../../model/held.js").Stands} whether its recording is shown still */
  let isSame = () => true;

  function release(patch = {}) {
    const gesture = held;
    held = null;
    store.set({ holding: false, ...patch });
    surface.classList.remove("held");
    return gesture;
  }

  /** What is held, if it is there still. */
  function gesture() {
    const { document: doc } = store.state;
    if (held && !(isSame(doc) && (held.stands?.(doc) ?? true)))
      release({ drag: null, range: null });
    return held;
  }
  store.on(["document"], gesture);

  return {
    gesture,
    /** @param {import("./gestures.js").Gesture} wanted */
    take(wanted) {
      held = wanted;
      isSame = recordingStands(store.state.document);
      store.set({ holding: true });
      surface.classList.add("held");
    },
    /** Opens the hand; what was in it. */
    release: () => (gesture() ? release() : null),
  };
}
