/**
 * Keeps the 3D scene from standing in the way of the hand. Where 3D is drawn in software each frame
 * takes a fifth of a second of the one thread both pages share. So nothing is drawn while a hand
 * holds something on the timeline (drags, pans, zooms), unless segments or the playhead change.
 */

/** After a change viser goes on drawing for so long, for what arrives late. */
const FOLLOWS_MS = 250;

/**
 * @typedef {FrameRequestCallback & {draws?: FrameRequestCallback}} Callback
 *   `draws` is what a callback wraps, for whoever else has a hand in the frames
 *
 * @param {() => number|undefined} sceneFrames how many frames the scene has drawn
 */
export function createCalmScene(sceneFrames) {
  /** What the scene draws its frames with, known by its having drawn one. */
  const drawing = new WeakSet();
  /** @type {Map<Callback, (callback: Callback) => number>} */
  const waiting = new Map();
  let drawsUntil = 0;
  let isHeld = false;

  const mayDraw = () => !isHeld || performance.now() < drawsUntil;

  function release() {
    if (!mayDraw()) return;
    const callbacks = [...waiting];
    waiting.clear();
    for (const [callback, draw] of callbacks) draw(callback);
  }

  return {
    /** Takes the frame's requests for animation frames in hand. @param {Window} inside */
    watch(inside) {
      const request = inside.requestAnimationFrame.bind(inside);
      const isKept = (callback) => !mayDraw() && drawing.has(callback.draws ?? callback);
      const draw = (callback) =>
        request((now) => {
          // Asked for before the hand took hold.
          if (isKept(callback)) return void waiting.set(callback, draw);
          const before = sceneFrames();
          callback(now);
          if (sceneFrames() === before) return;
          drawing.add(callback.draws ?? callback);
        });
      inside.requestAnimationFrame = (/** @type {Callback} */ callback) => {
        if (!isKept(callback)) return draw(callback);
        waiting.set(callback, draw);
        return 0;
      };
    },
    /** The hand takes hold of something, or lets go. @param {boolean} held */
    hold(held) {
      isHeld = held;
      release();
    },
    /** Something in the scene is about to change: let it draw. */
    changed() {
      drawsUntil = performance.now() + FOLLOWS_MS;
      release();
    },
  };
}
