/** Playing, and going from place to place in a recording. */

import { reveal } from "./reveal.js";
import { SPEEDS } from "../model/playback.js";

/** What of the playhead is asked for by playing. */
const PLAYED = ["playing", "speed", "loop"];

/**
 * @param {import("../lib/store.js").Store} store
 * @param {import("../model/types.js").Send} share
 */
export function createPlaybackActions(store, share) {
  const { state } = store;
  const doc = () => state.document;

  /**
   * What was asked of the playhead and not told back yet: the next change follows it.
   * @type {import("../model/types.js").Playhead|null}
   */
  let asked = null;
  /** What was told before it was asked for is no answer, though it may look like one. */
  let before = state.playhead;
  const wanted = () => asked ?? state.playhead;
  store.on(["playhead"], ({ playhead }) => {
    if (playhead !== before && PLAYED.every((name) => playhead[name] === asked?.[name]))
      asked = null;
  });
  store.on(["connected", "recording"], () => (asked = null));

  const actions = {
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
      before = state.playhead;
    },
    togglePlay() {
      const { playing, speed } = wanted();
      actions.play({ playing: !playing, speed: playing ? speed : Math.abs(speed) });
    },
    /**
     * As in editors of film: plays one way, and the same again twice as fast; 0 stops.
     * @param {-1|0|1} way
     */
    shuttle(way) {
      const { playing, speed } = wanted();
      const isGoing = playing && speed * way > 0;
      const faster = SPEEDS.find((one) => one > Math.abs(speed)) ?? Math.abs(speed);
      if (way === 0) actions.play({ playing: false, speed: 1 });
      else actions.play({ playing: true, speed: way * (isGoing ? faster : 1) });
    },
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
      reveal(store, time);
    },

    /** Plays what is right before and after a time again and again, where motion is welcome. */
    playAround(time) {
      if (doc() && !matchMedia("(prefers-reduced-motion: reduce)").matches)
        share({ type: "play_around", time_s: time });
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
  };
  return actions;
}
