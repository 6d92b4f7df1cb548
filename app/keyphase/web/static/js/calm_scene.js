/**
 * Keeps the 3D scene from standing in the way of the hand. Where 3D is drawn in software each frame
 * takes a fifth of a second of the one thread both pages share. So nothing is drawn while a hand
 * holds something on the timeline (drags, pans, zooms), unless segments or the playhead change.
 *
 * viser also draws a frame every second though nobody asked for one; while the pointer is over the
 * timeline, about to take hold of something, such frames wait.
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
  let askedUntil = 0;
  /** Whether a frame was asked for since the last one was drawn. */
  let isOwed = false;
  let isHeld = false;
  let isNear = false;

  const mayDraw = () => {
    const now = performance.now();
    return now < drawsUntil || (!isHeld && (!isNear || isOwed || now < askedUntil));
  };

  function release() {
    if (!mayDraw()) return;
    const callbacks = [...waiting];
    waiting.clear();
    for (const [callback, draw] of callbacks) draw(callback);
  }

  /** Notices when something in viser asks for a frame, as against its drawing one every second. */
  function hearRequests(viser) {
    const ask = viser.requestRender;
    const heard = () => {
      askedUntil = performance.now() + FOLLOWS_MS;
      isOwed = true;
      ask();
      release();
    };
    heard.isHeard = true;
    viser.requestRender = heard;
  }

  return {
    /** Takes the frame's requests for animation frames in hand. @param {Window} inside */
    watch(inside) {
      const request = inside.requestAnimationFrame.bind(inside);
      const viser = () => /** @type {any} */ (inside).__viserMutable;
      const isKept = (callback) => !mayDraw() && drawing.has(callback.draws ?? callback);
      const draw = (callback) =>
        request((now) => {
          // Asked for before the hand took hold.
          if (isKept(callback)) return void waiting.set(callback, draw);
          if (viser() && !viser().requestRender.isHeard) hearRequests(viser());
          const before = sceneFrames();
          callback(now);
          if (sceneFrames() === before) return;
          drawing.add(callback.draws ?? callback);
          isOwed = false;
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
    /** The pointer comes over the timeline, or leaves it. @param {boolean} near */
    come(near) {
      isNear = near;
      release();
    },
    /** Something in the scene is about to change: let it draw. */
    changed() {
      drawsUntil = performance.now() + FOLLOWS_MS;
      release();
    },
  };
}
