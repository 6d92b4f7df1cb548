/** A strip of small pictures along the segments, each of the middle of its place. */

import { chosenCameras, offsetOf, seekTime } from "../model/footage/frames.js";
import { thumbnailsOf } from "../model/footage/thumbnails.js";
import { svg } from "../lib/dom.js";

/** Pictures are made when the view has rested so long. */
const REST_MS = 250;
const MOST_KEPT = 500;
const MARGIN_PX = 2;

/**
 * @param {import("../lib/store.js").Store} store
 * @param {SVGElement} group
 * @param {() => import("../lib/scale.js").Scale} scale
 */
export function createFilmStrip(store, group, scale) {
  const maker = createPictures((frame, url) => {
    for (const image of group.querySelectorAll(`[data-frame="${frame}"]`))
      image.setAttribute("href", url);
  });
  return (state) => {
    const row = state.layout.rows.get("cameras");
    const camera = row && !row.folded && chosenCameras(state)[0];
    if (!camera) {
      maker.want(null, []);
      return group.replaceChildren();
    }
    const height = row.height - 2 * MARGIN_PX;
    const wide = (height * camera.width) / camera.height;
    const segments = state.document.segments;
    const places = thumbnailsOf(segments, camera, offsetOf(state.document, camera), scale(), wide);
    maker.want(
      camera,
      places.map(({ frame }) => frame),
    );
    const left = /** @type {SVGElement[]} */ ([...group.children]);
    return group.replaceChildren(
      ...places.map(({ x, width, frame }) => {
        const node = imageOf(frame, left);
        const url = maker.url(frame);
        if (url && node.getAttribute("href") !== url) node.setAttribute("href", url);
        const box = { x: x + 0.5, y: row.y + MARGIN_PX, width, height };
        for (const [name, value] of Object.entries(box)) node.setAttribute(name, String(value));
        return node;
      }),
    );
  };
}

/**
 * The picture of a frame: one that is there already is not decoded again.
 * @param {number} frame
 * @param {SVGElement[]} left those that nobody has taken
 */
function imageOf(frame, left) {
  const at = left.findIndex((node) => node.dataset.frame === String(frame));
  if (at >= 0) return left.splice(at, 1)[0];
  return svg("image", { preserveAspectRatio: "xMidYMid slice", data: { frame } });
}

/** Pictures of frames, made one after another from a video of its own that is never seen. */
function createPictures(made) {
  const canvas = document.createElement("canvas");
  /** @type {Map<number, string>} */
  const urls = new Map();
  let camera = /** @type {any} */ (null);
  let video = /** @type {HTMLVideoElement|null} */ (null);
  let waiting = /** @type {number[]} */ ([]);
  let rest = 0;
  let isBusy = false;

  function turnTo(other) {
    camera = other;
    urls.clear();
    video?.removeAttribute("src");
    video?.load();
    video = null;
    isBusy = false;
  }
  function load() {
    video = document.createElement("video");
    video.muted = true;
    video.preload = "auto";
    video.src = `/app/video/${camera.id}`;
    [canvas.width, canvas.height] = [Math.round((80 * camera.width) / camera.height), 80];
  }
  function next() {
    const frame = waiting.shift();
    if (frame === undefined || isBusy || !camera) return;
    if (!video) load();
    const from = /** @type {HTMLVideoElement} */ (video);
    isBusy = true;
    from.addEventListener(
      "seeked",
      () => {
        if (from !== video) return;
        isBusy = false;
        canvas.getContext("2d")?.drawImage(from, 0, 0, canvas.width, canvas.height);
        const url = canvas.toDataURL("image/jpeg", 0.7);
        if (urls.size >= MOST_KEPT) urls.delete(urls.keys().next().value ?? -1);
        urls.set(frame, url);
        made(frame, url);
        next();
      },
      { once: true },
    );
    from.currentTime = seekTime(camera, frame);
  }
  return {
    url: (frame) => urls.get(frame),
    /** From now on these are wanted, and no others. */
    want(of, frames) {
      if (of?.id !== camera?.id) turnTo(of);
      waiting = [...new Set(frames)].filter((frame) => !urls.has(frame));
      clearTimeout(rest);
      if (waiting.length && !isBusy) rest = setTimeout(next, REST_MS);
    },
  };
}
