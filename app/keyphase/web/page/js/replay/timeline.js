/** The timeline in a replay: its rows on the replay's own time. */

import { byId, el, svg } from "../lib/dom.js";
import { createGutter } from "../timeline/gutter.js";
import { createPlayhead, drawRuler } from "../timeline/ruler.js";
import { createScale } from "../lib/scale.js";
import { drawCurrent, drawEnds, drawSkills, drawWholePlan } from "./band.js";
import { layOutReplay, REPLAY_TRACKS } from "./rows.js";
import { planned, slotsOf } from "./schedule.js";
import { createReplayTrack } from "./tracks.js";
import { attachReplayView, shownOf } from "./view.js";

const MARGIN_PX = { large: 42, small: 40 };
const GUTTER_PX = { large: 172, small: 132 };
/** In a lower row the pens are not explained, so that every value has its place. */
const SHORT_PX = 110;

/** @param {import("../lib/store.js").Store} store */
export function createReplayTimeline(store) {
  const pane = byId("replay-timeline");
  const { clip, groups, content } = createLayers(pane);
  const gutters = createGutters(pane);
  const fold = (key) => {
    const next = new Set(store.state.replayFolded);
    if (!next.delete(key)) next.add(key);
    store.set({ replayFolded: next });
  };
  const tracks = new Map(
    REPLAY_TRACKS.map((track) => [track.key, buildTrack(track, content, fold)]),
  );
  const playhead = createPlayhead(groups.playhead);
  let layout = layOutReplay(store.state, 0);

  /** @param {import("../lib/store.js").State} state */
  function arrange(state) {
    if (!state.replay) return;
    const size = state.small ? "small" : "large";
    pane.style.setProperty("--gutter", `${GUTTER_PX[size]}px`);
    pane.style.setProperty("--margin", `${MARGIN_PX[size]}px`);
    layout = layOutReplay(state, pane.clientHeight);
    pane.style.setProperty("--head", `${layout.headHeight}px`);
    content.style.setProperty("height", `${layout.height - layout.headHeight}px`);
    for (const [key, gutter] of gutters) gutter.place(layout.rows.get(key));
    for (const [key, { row, gutter }] of tracks) {
      const { y, height, folded } = layout.rows.get(key);
      row.classList.toggle("short", height < SHORT_PX);
      row.style.setProperty("top", `${y - layout.headHeight}px`);
      row.style.setProperty("height", `${height}px`);
      gutter.place({ key, y: 0, height, folded });
    }
    playhead.lay(layout, pane.clientHeight);
    draw(state);
  }

  const left = () => GUTTER_PX[store.state.small ? "small" : "large"];
  const width = () =>
    Math.max(50, pane.clientWidth - left() - MARGIN_PX[store.state.small ? "small" : "large"]);
  let shown = { whole: { from: 0, to: 1 }, view: { from: 0, to: 1 } };
  attachReplayView(store, pane, () => ({
    ...shown,
    width: width(),
    left: pane.getBoundingClientRect().left + left(),
  }));

  /** @param {import("../lib/store.js").State} state */
  function draw(state) {
    const { replay, samples } = state;
    if (!replay || !samples || !pane.clientWidth) return;
    const now = nowOf(state);
    const slots = slotsOf(replay, now);
    shown = shownOf(slots, now, state.replayView);
    const scale = createScale(shown.view, width());
    const whole = createScale(shown.whole, scale.width);
    clip.setAttribute("width", String(scale.width));
    const { rows } = layout;
    const bottom = pane.clientHeight;
    const body = rows.get("skills").y + rows.get("skills").height;
    groups.current.replaceChildren(...drawCurrent(slots, scale, body, bottom));
    groups.plan.replaceChildren(
      ...drawWholePlan(slots, whole, rows.get("overview")),
      ...drawPart(shown, whole, rows.get("overview")),
    );
    groups.ruler.replaceChildren(...drawRuler(scale, rows.get("ruler")));
    groups.skills.replaceChildren(...drawSkills(slots, scale, rows.get("skills"), now));
    groups.ends.replaceChildren(...drawEnds(slots, scale, rows.get("ends"), bottom));
    for (const [key, track] of tracks) {
      track.draw(samples, slots, scale, rows.get(key));
      track.read(samples);
    }
    groups.playhead.style.setProperty(
      "visibility",
      now < scale.from || now > scale.to ? "hidden" : "visible",
    );
    playhead.move(scale, now, groups.ruler.querySelectorAll("text"));
    for (const [name, value] of Object.entries({
      x: whole.x(now) - 0.75,
      y: rows.get("overview").y,
      height: rows.get("overview").height,
    }))
      groups.whole.setAttribute(name, String(value));
    describe(gutters.get("skills"), slots);
  }

  store.on(["replay", "replayFolded", "small", "paneHeight", "paneWidth", "replayShown"], arrange);
  store.on(["samples", "replayView"], draw);
  store.on(["dark"], (state) => {
    for (const track of tracks.values()) track.recolor();
    draw(state);
  });
  new ResizeObserver(() => arrange(store.state)).observe(pane);
}

/** What lies below and above the tracks. @param {HTMLElement} pane */
function createLayers(pane) {
  const clip = svg("rect", { y: -10_000, height: 20_000 });
  const inside = { "clip-path": "url(#replay-clip)" };
  const groups = {
    current: svg("g", inside),
    plan: svg("g"),
    ruler: svg("g"),
    skills: svg("g", inside),
    ends: svg("g", inside),
    playhead: svg("g", { class: "playhead" }),
    whole: svg("rect", { class: "overview-playhead", width: 1.5 }),
  };
  const below = svg("svg", { class: "layer below" }, patterns(), groups.current);
  const above = svg(
    "svg",
    { class: "layer above" },
    svg("clipPath", { id: "replay-clip" }, clip),
    groups.plan,
    groups.whole,
    groups.ruler,
    groups.skills,
    groups.ends,
    groups.playhead,
  );
  const content = el("div", { class: "tracks-content" });
  pane.append(below, el("div", { class: "tracks" }, content), above);
  return { clip, groups, content };
}

/** Where the part in view lies in the whole plan; nothing where all of it is in view. */
function drawPart({ view, whole: all }, whole, { y, height }) {
  if (view.from <= all.from && view.to >= all.to) return [];
  const [from, to] = [whole.x(view.from), whole.x(view.to)];
  return [
    svg("rect", { y, width: Math.max(0, from), height, class: "overview-outside" }),
    svg("rect", {
      x: to,
      y,
      width: Math.max(0, whole.width - to),
      height,
      class: "overview-outside",
    }),
    svg("rect", {
      x: from,
      y: y + 1.5,
      width: Math.max(2, to - from),
      height: height - 3,
      rx: 3,
      class: "overview-window",
    }),
  ];
}

/** Replay time now: that of the newest sample. @param {import("../lib/store.js").State} state */
export function nowOf({ samples, replay }) {
  if (!samples?.count || samples.run !== replay?.run) return replay?.time_s ?? 0;
  return samples.time[samples.count - 1];
}

function buildTrack({ key, title, unit }, content, fold) {
  const gutter = createGutter({ key, title, unit }, fold);
  const plot = el("div", { class: "plot", data: { track: `replay-${key}` } });
  const marks = svg("g");
  const row = el(
    "div",
    { class: "track", data: { key: `replay-${key}` } },
    gutter.node,
    plot,
    svg("svg", { class: "marks" }, marks),
  );
  content.append(row);
  const parts = { plot, marks, gutter: gutter.body, texts: gutter.texts };
  return { ...createReplayTrack(key, parts), row, gutter };
}

function createGutters(pane) {
  const rows = [
    { key: "overview", title: "Whole plan", foldable: false },
    { key: "ruler", title: "Replay time, s", foldable: false },
    { key: "ends", title: "Ends", foldable: false },
    { key: "skills", title: "Skills", foldable: false },
  ];
  const gutters = new Map(rows.map((row) => [row.key, createGutter(row)]));
  for (const { node } of gutters.values()) pane.append(node);
  gutters.get("skills").body.append(el("div", { class: "gutter-note wide" }));
  for (const key of ["ends", "skills"])
    gutters.get(key).node.querySelector(".gutter-name").classList.remove("plain");
  return gutters;
}

/** @param {import("./schedule.js").Slot[]} slots */
function describe(gutter, slots) {
  const skills = planned(slots).length;
  const moves = slots.length - skills;
  gutter.small.textContent = String(skills);
  gutter.body.firstElementChild.textContent =
    moves === 0 ? "" : moves === 1 ? "and a connecting move" : `and ${moves} connecting moves`;
}

/** The hatch of connecting moves, and the stripes of the skill that runs. */
function patterns() {
  const tile = { patternUnits: "userSpaceOnUse", patternTransform: "rotate(45)" };
  return svg(
    "defs",
    {},
    svg(
      "pattern",
      { id: "replay-hatch", width: 6, height: 6, ...tile },
      svg("rect", { width: 6, height: 6, style: { fill: "var(--hatch)" } }),
      svg("rect", { width: 2.2, height: 6, style: { fill: "var(--hatch-line)" } }),
    ),
    svg(
      "pattern",
      { id: "running-stripes", width: 10, height: 10, ...tile },
      svg("rect", { width: 5, height: 10, style: { fill: "#fff", opacity: 0.22 } }),
    ),
  );
}
