/** viser's client in its frame, and what lies over it. */

import { hideBareGround, isDressed, sceneFrames } from "./viser_client.js";
import { createCalmScene } from "./calm_scene.js";
import { createDrawingNote } from "./drawing_note.js";
import { byId, el, svg } from "../lib/dom.js";
import { moment } from "../lib/format.js";

const NO_3D =
  "This browser cannot draw in 3D (WebGL is off or missing). The timeline and all else work without.";
/** How often we look whether viser has drawn the first of ours. */
const LOOK_MS = 100;

/**
 * @param {import("../lib/store.js").Store} store
 * @param {string} page what this page calls itself
 * @returns {HTMLIFrameElement} viser's frame
 */
export function createScene(store, page) {
  const calm = createCalmScene(sceneFrames);
  let segments = "";
  store.on(["clock", "selected", "dark", "recording"], calm.changed);
  store.on(["document"], ({ document: doc }) => {
    const now =
      doc?.segments.map((one) => `${one.start_s} ${one.label} ${one.kept} ${one.color}`).join() ??
      "";
    if (now !== segments) calm.changed();
    segments = now;
  });
  store.on(["samples", "replay"], calm.changed);
  store.on(["holding"], ({ holding }) => calm.hold(holding));
  store.on(["sought"], ({ sought }) => calm.seek(sought.size > 0));
  const frame = /** @type {HTMLIFrameElement} */ (byId("viser"));
  frame.addEventListener("load", () => {
    const inside = frame.contentWindow;
    lookBeforeEachFrame(inside, () => hideBareGround(inside));
    calm.watch(inside);
    showOnceDressed(frame);
  });
  createDrawingNote(store, () => frame.contentWindow);
  if (!drawsIn3D()) byId("drawing").textContent = NO_3D;
  frame.src = `/viser/${page}/`;

  const hud = byId("hud");
  store.later(["clock", "document", "record"], (state) => hud.replaceChildren(...seen(state)));
  store.later(["document", "record"], ({ document: doc, record }) =>
    byId("legend").replaceChildren(...(doc && !record?.workcell ? legend(doc) : [])),
  );
  return frame;
}

/**
 * What is looked at: a workcell that is led by hand stands in the place of the recording.
 * @param {import("../lib/store.js").State} state
 * @returns {(string|Node)[]}
 */
function seen({ clock, document: doc, record }) {
  if (record?.workcell) return ["Workcell ", el("b", { text: record.workcell })];
  if (!doc) return [];
  const hasFrame = doc.channels.includes("orientation");
  return ["At ", el("b", { text: moment(clock) }), hasFrame ? " · tool frame" : ""];
}

const drawsIn3D = () => Boolean(document.createElement("canvas").getContext("webgl2"));

/** @param {Window} inside @param {() => void} look */
function lookBeforeEachFrame(inside, look) {
  const request = inside.requestAnimationFrame.bind(inside);
  inside.requestAnimationFrame = (callback) =>
    request((now) => {
      look();
      callback(now);
    });
}

/** @param {HTMLIFrameElement} frame */
function showOnceDressed(frame) {
  frame.classList.remove("dressed");
  const look = setInterval(() => {
    if (!isDressed(frame.contentWindow)) return;
    clearInterval(look);
    frame.classList.add("dressed");
  }, LOOK_MS);
}

/** So many Gaussians the server draws at most (MOST_ELLIPSOIDS of path_geometry.py). */
const MOST_ELLIPSOIDS = 60;

/** @param {import("../model/types.js").Doc} doc */
function legend({ gaussians, greatest_step_N: step }) {
  return [
    ...(gaussians ? [el("span", {}, ellipse(), gaussianText(gaussians))] : []),
    ...(step
      ? [el("span", {}, arrow(), `force changes, the longest by ${step.toFixed(1)} N`)]
      : []),
    el("span", {}, dot(), "idle"),
  ];
}

/** @param {number} count */
const gaussianText = (count) =>
  count > MOST_ELLIPSOIDS
    ? `Gaussian, 1 σ (${MOST_ELLIPSOIDS} heaviest of ${count})`
    : "Gaussian, 1 σ";

const ellipse = () =>
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
  );

const arrow = () =>
  svg(
    "svg",
    { width: 26, height: 8 },
    svg("path", { d: "M0 4h20", "stroke-width": 3, style: { stroke: "var(--origin-force)" } }),
    svg("path", { d: "M18 0l8 4-8 4z", style: { fill: "var(--origin-force)" } }),
  );

const dot = () =>
  svg(
    "svg",
    { width: 10, height: 10 },
    svg("circle", { cx: 5, cy: 5, r: 4, style: { fill: "var(--idle)" } }),
  );
