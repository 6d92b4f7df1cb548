/** viser's client in its frame, what lies over it, and the inputs inside it we have to know of. */

import { sceneFrames } from "./viser_client.js";
import { createCalmScene } from "./calm_scene.js";
import { byId, el, svg } from "../lib/dom.js";
import { time as timeText } from "../lib/format.js";

/**
 * @param {import("../lib/store.js").Store} store
 * @param {string} page what this page calls itself
 * @param {{onKey: (event: KeyboardEvent) => void, onSlide: (value: number, at: number) => void}} handlers
 * @returns {HTMLIFrameElement} viser's frame
 */
export function createScene(store, page, { onKey, onSlide }) {
  const calm = createCalmScene(sceneFrames);
  let segments = "";
  store.on(["clock", "selected", "dark", "recording"], calm.changed);
  store.on(["document"], ({ document: doc }) => {
    const now = doc?.segments.map((one) => `${one.start_s} ${one.label} ${one.kept}`).join() ?? "";
    if (now !== segments) calm.changed();
    segments = now;
  });
  store.on(["samples", "replay"], calm.changed);
  store.on(["holding"], ({ holding }) => calm.hold(holding));
  const frame = /** @type {HTMLIFrameElement} */ (byId("viser"));
  frame.addEventListener("load", () => {
    const inside = frame.contentWindow;
    // Keys pressed while the scene has the focus never reach our page by themselves.
    inside.addEventListener("keydown", onKey);
    watchSliders(frame.contentDocument, onSlide);
    watchHolding(inside, store);
    calm.watch(inside);
  });
  frame.src = `/viser/${page}/`;

  const hud = byId("hud");
  store.later(["clock", "document"], ({ clock, document: doc }) => {
    hud.replaceChildren(
      ...(doc
        ? [
            "At ",
            el("b", { text: `${timeText(clock)} s` }),
            doc.channels.includes("orientation") ? " · tool frame" : "",
          ]
        : []),
    );
  });
  store.later(["document"], ({ document: doc }) =>
    byId("legend").replaceChildren(...(doc ? legend(doc) : [])),
  );
  return frame;
}

/** So many Gaussians the server draws at most (MOST_ELLIPSOIDS of path_geometry.py). */
const MOST_ELLIPSOIDS = 60;

function legend(doc) {
  const parts = [];
  if (doc.gaussians.length) {
    parts.push(
      el(
        "span",
        {},
        svg(
          "svg",
          { width: 18, height: 10 },
          svg("ellipse", {
            cx: 9,
            cy: 5,
            rx: 8.5,
            ry: 4,
            style: { fill: "var(--segment-0)", opacity: ".45" },
          }),
        ),
        doc.gaussians.length > MOST_ELLIPSOIDS
          ? `Gaussian, 1 σ (${MOST_ELLIPSOIDS} heaviest of ${doc.gaussians.length})`
          : "Gaussian, 1 σ",
      ),
    );
  }
  if (doc.channels.includes("force")) {
    parts.push(
      el(
        "span",
        {},
        svg(
          "svg",
          { width: 26, height: 8 },
          svg("path", {
            d: "M0 4h20",
            "stroke-width": 3,
            style: { stroke: "var(--origin-force)" },
          }),
          svg("path", { d: "M18 0l8 4-8 4z", style: { fill: "var(--origin-force)" } }),
        ),
        "force, 5 N",
      ),
    );
  }
  parts.push(
    el(
      "span",
      {},
      svg(
        "svg",
        { width: 10, height: 10 },
        svg("circle", { cx: 5, cy: 5, r: 4, style: { fill: "var(--idle)" } }),
      ),
      "idle",
    ),
  );
  return parts;
}

/** A control of the panel is being dragged, as something on the timeline may be. */
function watchHolding(inside, store) {
  inside.addEventListener(
    "pointerdown",
    ({ target }) => {
      if (target.tagName !== "CANVAS") store.set({ holding: true });
    },
    true,
  );
  for (const end of ["pointerup", "pointercancel"])
    inside.addEventListener(end, () => store.set({ holding: false }), true);
}

const INPUTS = ["pointerdown", "pointermove", "keydown", "input", "change", "wheel"];

/**
 * Notes every value a slider or number field of the panel shows and the input event behind it,
 * so that latency can be counted from the hand and not from the network.
 * @param {Document} inside
 * @param {(value: number, at: number) => void} onSlide
 */
function watchSliders(inside, onSlide) {
  let inputAt = 0;
  for (const type of INPUTS)
    inside.addEventListener(type, (event) => (inputAt = event.timeStamp), true);
  // The frame's clock started at another moment than ours.
  const shift =
    (inside.defaultView?.performance.timeOrigin ?? performance.timeOrigin) - performance.timeOrigin;
  const notice = (mutations) => {
    for (const { target } of mutations) {
      const value = shownBy(/** @type {HTMLElement} */ (target));
      if (Number.isFinite(value) && inputAt) onSlide(value, inputAt + shift);
    }
  };
  new MutationObserver(notice).observe(inside, {
    subtree: true,
    attributes: true,
    attributeFilter: ["aria-valuenow", "style"],
  });
}

/** The threshold's slider spans so many decades, from 1 on. */
const DECADES = 4;

/** What a slider's thumb shows: its value, or for the threshold's the decades. NaN for others. */
function shownBy(thumb) {
  if (thumb.hasAttribute("aria-valuenow")) return Number(thumb.getAttribute("aria-valuenow"));
  if (thumb.classList.contains("multi-slider-thumb"))
    return (DECADES * parseFloat(thumb.style.left)) / 100;
  return NaN;
}
