/**
 * Gives the timeline its turn while the scene moves. viser draws frame after frame then, and where
 * 3D is drawn in software each holds up the one thread both pages share. After a frame that took
 * long the next one waits, so that the timeline, keys and messages have their share of the time.
 * Where there is a graphics card frames are cheap, and nothing waits.
 */

import { afterFrame } from "../lib/after_frame.js";

/** A frame that took no longer than this is cheap. */
const CHEAP_MS = 12;
/** After another one the scene rests so many times as long as it took. */
const REST = 1;
/** A key or a click is answered before; no frame comes in between. */
const ANSWERED_MS = 250;

/**
 * @param {() => number|undefined} sceneFrames how many frames the scene has drawn
 * @param {() => boolean} isMoving whether the scene moves by itself, and not by a hand in it
 */
export function createScenePace(sceneFrames, isMoving) {
  /** What the scene draws its frames with, known by its having drawn one. */
  const drawing = new WeakSet();
  let restsUntil = 0;
  const hush = () => (restsUntil = performance.now() + ANSWERED_MS);

  return {
    /** Takes the frame's requests for animation frames in hand. @param {Window} inside */
    watch(inside) {
      addEventListener("keydown", hush, true);
      addEventListener("pointerdown", hush, true);
      inside.addEventListener("keydown", hush, true);
      const request = inside.requestAnimationFrame.bind(inside);
      const draw = (callback) => {
        const frame = (now) => {
          const wait = restsUntil - performance.now();
          if (wait > 0 && isMoving() && drawing.has(callback)) {
            setTimeout(() => draw(callback), wait);
            return;
          }
          const before = sceneFrames();
          const begun = performance.now();
          callback(now);
          if (sceneFrames() === before) return;
          drawing.add(callback);
          afterFrame(() => {
            const took = performance.now() - begun;
            if (took > CHEAP_MS) restsUntil = Math.max(restsUntil, performance.now() + REST * took);
          });
        };
        // So that others who watch the frame still know what it draws with.
        frame.draws = callback;
        return request(frame);
      };
      inside.requestAnimationFrame = draw;
    },
  };
}
