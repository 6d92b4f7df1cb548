/** Between two messages of the server the playhead runs on by itself, frame by frame. */

/** How many times faster than recorded. */
export const SPEEDS = [0.1, 0.25, 0.5, 1, 2, 4];

/** @param {import("../lib/store.js").Store} store */
export function createPlayback(store) {
  let at = { time: 0, now: 0 };
  let frame = 0;

  function run() {
    frame = 0;
    const { playhead, document: doc } = store.state;
    if (!playhead.playing || !doc) return;
    const elapsed = (performance.now() - at.now) / 1000;
    const clock = runningClock(at.time + elapsed * playhead.speed, playhead, doc);
    follow(store, clock);
    store.set({ clock });
    frame = requestAnimationFrame(run);
  }

  return {
    /** @param {import("./types.js").Playhead} playhead */
    receive(playhead) {
      at = { time: playhead.time_s, now: performance.now() };
      store.set({ playhead, clock: playhead.time_s });
      if (playhead.playing && !frame) frame = requestAnimationFrame(run);
    },
  };
}

/**
 * Where a running playhead is: in a stretch that is played again and again, or on to an end.
 * @param {number} time
 * @param {import("./types.js").Playhead} playhead
 * @param {{start_s: number, end_s: number}} doc
 */
export function runningClock(time, { between_s: between }, { start_s: start, end_s: end }) {
  if (!between) return Math.min(Math.max(time, start), end);
  const [from, to] = between;
  return from + ((((time - from) % (to - from)) + (to - from)) % (to - from));
}

/**
 * Turns the page when the playhead leaves the view.
 * @param {import("../lib/store.js").Store} store
 */
function follow(store, clock) {
  const { view, document: doc } = store.state;
  if (!view || (clock >= view.from && clock <= view.to)) return;
  const span = view.to - view.from;
  const ahead = store.state.playhead.speed > 0 ? 0.05 : 0.95;
  const from = Math.min(Math.max(clock - ahead * span, doc.start_s), doc.end_s - span);
  store.set({ view: { from, to: from + span } });
}
