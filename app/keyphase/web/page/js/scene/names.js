/**
 * Names of segments and times of contact changes over the 3D scene, each with a line to what it is
 * about. They are our own elements, so that they look like the rest of the page in both themes,
 * and a click on one selects what it names. They follow viser's camera.
 */

import { segmentFill } from "../lib/colors.js";
import { chosenStretch } from "../model/segments.js";
import { isPlaced, sceneFrames, viserIn } from "./viser_client.js";
import { byId, el, svg } from "../lib/dom.js";
import { time as timeText } from "../lib/format.js";
import { glyphIcon } from "../timeline/glyphs.js";
import { projection } from "./projection.js";
import { placed } from "./placing.js";
import { forceName, forceNow, skillNames } from "./replay_names.js";

/** With more names than this only what is selected is named. */
const MOST = 10;
/** The node the server shows and hides for all names, and the one that holds a replay. */
const NODE = "/labels";
const REPLAY_NODE = "/replay";
/** The force of a replay is told again after so many frames of the scene. */
const FORCE_EVERY_FRAMES = 2;
/** How often we look whether viser has started, and whether it still shows that node. */
const LOOK_MS = 250;

/**
 * @typedef {{at: number[], color: string, title: string, isSelected: boolean, mark: Node, text: string,
 *   chosen?: (actions: any) => void}} Named
 * @typedef {{at: number[]|null, plate: HTMLElement, line: SVGElement, dot: SVGElement}} Name
 *
 * @param {import("../lib/store.js").Store} store
 * @param {any} actions
 * @param {() => Window|null} inside viser's window
 */
export function createNames(store, actions, inside) {
  const layer = byId("names");
  const lines = svg("svg", { "aria-hidden": "true" });
  /** @type {Name[]} */
  let names = [];
  /** @type {Name|null} the last of the names in a replay */
  let force = null;
  let drawnBefore = 0;
  let followed = null;

  function build() {
    const { document: doc, small, replay } = store.state;
    const selected = chosenStretch(store.state);
    const named = replay ? skillNames(replay) : doc ? namesOf(doc, selected, small) : [];
    names = named.map((name) => drawn(name, actions));
    force = replay ? drawn(forceName(), actions) : null;
    if (force) names.push(force);
    lines.replaceChildren(...names.flatMap(({ line, dot }) => [line, dot]));
    layer.replaceChildren(lines, ...names.map(({ plate }) => plate));
    if (force) tellForce();
    place();
  }

  function place() {
    const viser = viserIn(inside());
    const node = store.state.replay ? REPLAY_NODE : NODE;
    const about = viser?.nodeRefFromName[node];
    layer.hidden = !about?.visible || !isPlaced(about) || !names.length;
    if (layer.hidden) return;
    const project = projection(viser, node);
    const seen = names.map(({ at, plate }) => ({
      anchor: at && project(at),
      width: plate.offsetWidth,
    }));
    const inView = seen.map(({ anchor }) => anchor && isInside(anchor, viser.canvas));
    const places = placed(
      seen.filter((_, k) => inView[k]),
      {
        width: viser.canvas.clientWidth,
        height: viser.canvas.clientHeight,
      },
      coveredCorner(),
    );
    names.forEach((name, k) => put(name, seen[k].anchor, inView[k] ? places.shift() : null));
  }

  function tellForce() {
    drawnBefore = sceneFrames() ?? 0;
    const now = forceNow(store.state.replay, store.state.samples);
    force.at = now?.at ?? null;
    if (now) force.plate.lastChild.textContent = now.text;
  }

  /** With the arrow, which is drawn by the scene: in between, all under the plates would be drawn again. */
  function forceChanged() {
    if (!force || (sceneFrames() ?? 0) < drawnBefore + FORCE_EVERY_FRAMES) return;
    tellForce();
    place();
  }

  /** viser may make its camera controls anew; they tell of every move before it is drawn. */
  function look() {
    const viser = viserIn(inside());
    const control = viser?.cameraControl ?? null;
    if (control !== followed) {
      followed = control;
      control?.addEventListener("update", place);
    }
    place();
  }

  store.later(["document", "selected", "selectedTo", "small", "replay"], build);
  store.later(["samples"], forceChanged);
  store.later(["dark", "firstSteps"], place);
  setInterval(look, LOOK_MS);
}

/**
 * What is to be named.
 * @param {import("../model/types.js").Doc} doc
 * @param {[number, number]|null} selected first and last
 * @param {boolean} small
 * @returns {Named[]}
 */
function namesOf(doc, selected, small) {
  const kept = doc.segments.flatMap((one, index) => (one.kept ? [index] : []));
  const contacts = doc.boundaries.flatMap((one, index) => (one.at_m ? [index] : []));
  const shown = kept.length > MOST ? [] : kept;
  const told = small || kept.length + contacts.length > MOST ? [] : contacts;
  const [first, last] = selected ?? [0, -1];
  const isSelected = (index) => index >= first && index <= last;
  const named = doc.segments.flatMap((_, index) =>
    shown.includes(index) || (isSelected(index) && last - first < MOST) ? [index] : [],
  );
  return [
    ...named.map((index) => segmentName(doc, index, isSelected(index), small)),
    ...told.map((index) => contactName(doc, index)),
  ];
}

/** @param {import("../model/types.js").Doc} doc @param {number} index @param {boolean} isSelected @param {boolean} small */
function segmentName(doc, index, isSelected, small) {
  const { middle_m: at, short, color: number, kept, label } = doc.segments[index];
  const color = kept ? segmentFill({ color: number }) : "var(--idle)";
  return {
    at,
    isSelected,
    title: label,
    color,
    mark: el("i", { style: { background: color } }),
    text: `${index + 1} ${short[small && !isSelected ? 1 : 0]}`,
    chosen: (actions) => actions.select(index),
  };
}

/** @param {import("../model/types.js").Doc} doc @param {number} index */
function contactName(doc, index) {
  const { at_m: at, origin, time_s: time } = doc.boundaries[index];
  return {
    at,
    isSelected: false,
    title: "",
    color: `var(--origin-${origin})`,
    mark: glyphIcon(origin, true),
    text: `contact change ${timeText(time)} s`,
    chosen: (actions) => actions.goTo(time),
  };
}

/** @param {Named} named @returns {Name} */
function drawn({ at, isSelected, title, color, mark, text, chosen }, actions) {
  const look = { class: isSelected ? "name selected" : "name", title };
  const plate = chosen
    ? el(
        "button",
        { ...look, type: "button", tabindex: -1, on: { click: () => chosen(actions) } },
        mark,
        text,
      )
    : el("div", look, mark, el("span", { text }));
  return { at, plate, line: svg("path"), dot: svg("circle", { r: 2.5, style: { fill: color } }) };
}

/** So much of the scene's lower right corner the first steps cover [px]. */
function coveredCorner() {
  const card = byId("first-steps");
  if (card.hidden) return { width: 0, height: 0 };
  const { right, bottom } = byId("viser").getBoundingClientRect();
  const { left, top } = card.getBoundingClientRect();
  return { width: right - left, height: bottom - top };
}

function isInside({ x, y }, canvas) {
  return x > 0 && y > 0 && x < canvas.clientWidth && y < canvas.clientHeight;
}

function put({ plate, line, dot }, anchor, to) {
  for (const node of [plate, line, dot]) node.toggleAttribute("hidden", !to);
  line.style.display = dot.style.display = to ? "" : "none";
  if (!to) return;
  const back = to.side === "left" ? "-100%" : "0";
  plate.style.transform = `translate(${Math.round(to.x)}px, ${Math.round(to.y)}px) translate(${back}, -50%)`;
  line.setAttribute("d", `M${to.x} ${to.y}L${anchor.x} ${anchor.y}`);
  dot.setAttribute("cx", anchor.x);
  dot.setAttribute("cy", anchor.y);
}
