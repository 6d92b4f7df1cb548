/** One camera's picture: the frame of a time, confirmed by the browser, or running with the playhead. */

import { fileTime, frameAt, frameShown, isFilmed, seekTime } from "../../model/footage/frames.js";
import { el } from "../../lib/dom.js";

/** Farther apart, a running picture is put where the playhead is. */
const LOST_S = 0.3;
/** A frame that the browser does not bring at once is asked for so often. */
const MOST_TRIES = 3;
/** A picture of the same frame is not always told anew. */
const UNTOLD_MS = 500;
/** As it stops, a running picture may be this many frames past the last one that was told. */
const MAY_BE_PAST = 2;
/** Any other picture is told; one that takes longer is asked for again. */
const ASKED_AGAIN_MS = 5000;

/**
 * @param {import("../../model/footage/frames.js").Camera} camera
 * @param {(frame: number) => void} told of each frame that is on the screen
 * @param {(why: string) => void} broke where the browser cannot play it
 * @param {(sought: boolean) => void} seeks whether a frame is being sought
 */
export function createPlayer(camera, told, broke, seeks) {
  const video = /** @type {HTMLVideoElement} */ (
    el("video", { preload: "auto", playsinline: true, disablepictureinpicture: true })
  );
  video.muted = true;
  video.src = `/app/video/${camera.id}`;
  video.setAttribute("aria-label", `Camera ${camera.name}`);
  video.addEventListener("error", () => {
    seeks(false);
    broke(video.error?.message || "It cannot be played.");
  });
  let wanted = /** @type {number|null} */ (null);
  let shown = /** @type {number|null} */ (null);
  /** The last frame that the browser told of; before it tells of any, the first is on the screen. */
  let presented = 0;
  let isSeeking = false;
  let tries = 0;
  let patience = 0;
  /** Waits no more for the frame that is sought. */
  let leave = () => {};

  function see(mediaTime) {
    clearTimeout(patience);
    shown = presented = frameShown(camera, mediaTime);
    video.dataset.frame = String(shown);
    told(shown);
  }
  function seek() {
    if (isSeeking || wanted === null || wanted === shown || !video.paused) return;
    isSeeking = true;
    seeks(true);
    const target = wanted;
    const isUnknown = shown === null;
    const ask = () => (video.currentTime = seekTime(camera, target));
    const over = new AbortController();
    const next = (mediaTime) => {
      over.abort();
      see(mediaTime);
      isSeeking = false;
      tries = wanted === target && shown !== target ? tries + 1 : 0;
      if (tries < MOST_TRIES) seek();
      if (!isSeeking) seeks(false);
    };
    const asked = video.requestVideoFrameCallback((_now, { mediaTime }) => next(mediaTime));
    over.signal.addEventListener("abort", () => video.cancelVideoFrameCallback(asked));
    video.addEventListener(
      "seeked",
      () => {
        // Of the seek before this one, told late.
        if (video.seeking) return;
        clearTimeout(patience);
        // The very frame that is on the screen already is not presented once more.
        const isPerhapsSeen = isUnknown && Math.abs(target - presented) <= MAY_BE_PAST;
        patience = isPerhapsSeen
          ? setTimeout(() => next(seekTime(camera, target) - 0.5 / camera.fps), UNTOLD_MS)
          : setTimeout(ask, ASKED_AGAIN_MS);
      },
      { signal: over.signal },
    );
    leave = () => over.abort();
    ask();
  }
  function leaveSeeking() {
    leave();
    clearTimeout(patience);
    isSeeking = false;
    seeks(false);
  }
  function run(_now, { mediaTime }) {
    see(mediaTime);
    if (!video.paused) video.requestVideoFrameCallback(run);
  }

  return {
    node: video,
    /** The frame of a time stands still. */
    rest(offset, time) {
      if (!video.paused) {
        video.pause();
        shown = null;
      }
      video.classList.toggle("not-filmed", !isFilmed(camera, offset, time));
      const frame = frameAt(camera, offset, time);
      if (frame !== wanted) tries = 0;
      wanted = frame;
      seek();
    },
    /** The picture runs, and keeps to the playhead by small changes of its speed. */
    follow(offset, time, speed) {
      if (!isFilmed(camera, offset, time)) return this.rest(offset, time);
      video.classList.remove("not-filmed");
      const ahead = video.currentTime - fileTime(camera, offset, time);
      const isLost = Math.abs(ahead) > LOST_S * Math.max(1, speed);
      if (isLost && !video.seeking) video.currentTime = fileTime(camera, offset, time);
      video.playbackRate = Math.min(
        Math.max(speed * (1 - Math.max(Math.min(ahead, 0.2), -0.2)), 0.07),
        16,
      );
      if (!video.paused) return undefined;
      leaveSeeking();
      wanted = shown = null;
      video.requestVideoFrameCallback(run);
      video.play().catch(() => undefined);
      return undefined;
    },
    close() {
      leaveSeeking();
      video.pause();
      video.removeAttribute("src");
      video.load();
    },
  };
}
