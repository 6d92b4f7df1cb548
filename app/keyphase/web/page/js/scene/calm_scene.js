/**
 * Keeps the 3D scene from standing in the way of the hand. Where 3D is drawn in software a frame
 * can take a second of the one thread both pages share. So nothing is drawn while a hand holds
 * something on the timeline (drags, pans, zooms), unless segments or the playhead change; and then
 * one frame at a time, so that the hand is kept waiting for few of its moves.
 *
 * The same goes for a camera's picture: decoding and drawing share the thread, and the picture is what
 * a person waits for.
 *
 * viser also draws a frame every second though nothing has changed. After a frame that took long
 * such frames wait, until most of the time is free. Where there is a graphics card nothing waits.
 */

import { afterFrame } from "../lib/after_frame.js";
import { waitingMessages } from "./viser_client.js";

/** After a change viser goes on drawing for so long, for what arrives late. */
const FOLLOWS_MS = 250;
/** The same after messages and inputs, which may set things going. */
const SETTLES_MS = 1000;
/** An idle scene, and one that follows a hand, rest so many times as long as a frame took. */
const REST = 12;
/** No longer than this, since what was loaded during a long first frame is to be seen soon. */
const REST_MS = 4000;
/** A picture that is sought is often followed by the next one: so long the scene waits for that. */
const SOUGHT_MS = 150;
/** How often we look whether there is something to draw. */
const LOOK_MS = 100;
const INPUTS = ["pointerdown", "pointermove", "pointerup", "wheel", "keydown", "resize"];

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
  let settlesUntil = 0;
  let restsUntil = 0;
  let isHeld = false;
  let isSought = false;
  let sought = 0;

  function mayDraw() {
    const now = performance.now();
    if (isSought && now < restsUntil) return false;
    if (isHeld) return now >= restsUntil && now < drawsUntil;
    return now < drawsUntil || now < settlesUntil || now >= restsUntil;
  }

  function release() {
    if (!mayDraw()) return;
    const callbacks = [...waiting];
    waiting.clear();
    for (const [callback, draw] of callbacks) draw(callback);
  }

  function wake() {
    settlesUntil = performance.now() + SETTLES_MS;
    release();
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
          const begun = performance.now();
          callback(now);
          if (sceneFrames() === before) return;
          drawing.add(callback.draws ?? callback);
          afterFrame(() => {
            const now = performance.now();
            restsUntil = now + Math.min(REST * (now - begun), REST_MS);
          });
        });
      inside.requestAnimationFrame = (/** @type {Callback} */ callback) => {
        if (!isKept(callback)) return draw(callback);
        waiting.set(callback, draw);
        return 0;
      };
      for (const type of INPUTS) inside.addEventListener(type, wake, true);
      // viser hears its messages as it draws; those that wait are something to draw.
      const queue = () => waitingMessages(inside);
      setInterval(() => (queue() ? wake() : release()), LOOK_MS);
    },
    /** The hand takes hold of something, or lets go. @param {boolean} held */
    hold(held) {
      isHeld = held;
      release();
    },
    /** A camera's picture is being sought, or has come. @param {boolean} begins */
    seek(begins) {
      clearTimeout(sought);
      if (begins) isSought = true;
      else
        sought = setTimeout(() => {
          isSought = false;
          release();
        }, SOUGHT_MS);
    },
    /** Something in the scene is about to change: let it draw. */
    changed() {
      const now = performance.now();
      drawsUntil = (isHeld ? Math.max(now, restsUntil) : now) + FOLLOWS_MS;
      wake();
    },
  };
}
