/**
 * Keeps the 3D scene from standing in the way of the hand. viser draws a frame every second even
 * when nothing has changed; where 3D is drawn in software each takes a fifth of a second of the
 * one thread both pages share. While something is being dragged, such frames wait until the
 * segments change, or until the hand lets go. A scene that was moving before goes on moving.
 */

const FOLLOWS_MS = 250;
/** More frames than this in the last second: the scene is not idle. */
const IDLE_FRAMES = 2;

/** @param {() => number|undefined} sceneFrames how many frames the scene has drawn */
export function createCalmScene(sceneFrames) {
  /** What the scene draws its frames with, known by its having drawn one. */
  const drawing = new WeakSet();
  /** @type {Map<FrameRequestCallback, (callback: FrameRequestCallback) => number>} */
  const waiting = new Map();
  let drawsUntil = 0;
  let isCalm = false;
  /** @type {number[]} */
  let drawnAt = [];

  function release() {
    isCalm = false;
    const callbacks = [...waiting];
    waiting.clear();
    for (const [callback, draw] of callbacks) draw(callback);
  }

  return {
    /** Takes the frame's requests for animation frames in hand. @param {Window} inside */
    watch(inside) {
      const request = inside.requestAnimationFrame.bind(inside);
      const draw = (callback) =>
        request((now) => {
          const before = sceneFrames();
          callback(now);
          if (sceneFrames() === before) return;
          drawing.add(callback);
          drawnAt = [...drawnAt.slice(-IDLE_FRAMES), performance.now()];
        });
      inside.requestAnimationFrame = (callback) => {
        if (!isCalm || performance.now() < drawsUntil || !drawing.has(callback))
          return draw(callback);
        waiting.set(callback, draw);
        return 0;
      };
    },
    /** The hand takes hold of something. */
    hold() {
      isCalm = drawnAt.length <= IDLE_FRAMES || performance.now() - drawnAt[0] > 1000;
    },
    /** Something in the scene is about to change: let it draw. */
    changed() {
      const wasCalm = isCalm;
      drawsUntil = performance.now() + FOLLOWS_MS;
      release();
      isCalm = wasCalm;
    },
    release,
  };
}
