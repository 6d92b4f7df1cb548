/**
 * The timeline: rows on one time axis. This file owns the elements and says what is drawn anew
 * when; every kind of row draws itself in a file of its own.
 */

import { el, svg } from "../lib/dom.js";
import { drawBand } from "./band.js";
import { drawBoundaries, drawGhosts, drawIntervals } from "./boundaries.js";
import { drawComparison } from "./comparison.js";
import { withDrag } from "../model/drag.js";
import { createErrorTrack, thresholdOf } from "./error_track.js";
import { createEvidenceTrack } from "./evidence/evidence_track.js";
import { evidenceOnSurface } from "./evidence/on_surface.js";
import { createGutter } from "./gutter.js";
import { createHeadGutters } from "./head_gutters.js";
import { drawOverviewCurve, drawOverviewStrip, drawWindow } from "./overview.js";
import { fold, layOut, TRACKS, tracksOf } from "../model/rows.js";
import { createPlayhead, drawRuler } from "./ruler.js";
import { createScale } from "../lib/scale.js";
import { createTrack } from "./tracks.js";

const MARGIN_PX = { large: 42, small: 40 };
const GUTTER_PX = { large: 172, small: 132 };
/** @type {Object<string, (parts: any, store: any) => any>} tracks with lines that one can drag */
const LINED = { error: createErrorTrack, evidence: createEvidenceTrack };

/**
 * @param {HTMLElement} pane
 * @param {import("../lib/store.js").Store} store
 * @param {any} actions
 */
export function createTimeline(pane, store, actions) {
  const below = layer("below");
  const scroller = el("div", { class: "tracks" });
  const content = el("div", { class: "tracks-content" });
  const above = layer("above");
  const groups = {
    intervals: svg("g"),
    overview: svg("g"),
    ruler: svg("g"),
    band: svg("g"),
    boundaries: svg("g"),
    ghosts: svg("g"),
    overviewCurve: svg("g"),
    overviewWindow: svg("g"),
    comparison: svg("g", { class: "comparison" }),
    pointer: svg("path", { class: "pointer-line" }),
    playhead: svg("g", { class: "playhead" }),
    overviewPlayhead: svg("rect", { class: "overview-playhead", width: 1.5 }),
  };
  const { clips } = clipPaths();
  below.append(clips, groups.intervals);
  above.append(
    groups.overviewCurve,
    groups.overview,
    groups.overviewWindow,
    groups.overviewPlayhead,
    groups.ruler,
    groups.comparison,
    groups.pointer,
    groups.band,
    groups.boundaries,
    groups.ghosts,
    groups.playhead,
  );
  const surface = el("div", { class: "surface", tabindex: "-1" });
  scroller.append(content);
  pane.append(below, scroller, above, surface);

  const gutters = createHeadGutters(pane, store, actions);
  const playhead = createPlayhead(groups.playhead);
  /** @type {Map<string, any>} */
  const tracks = new Map();
  let layout = layOut(store.state);

  function geometry() {
    const size = store.state.small ? "small" : "large";
    return { gutter: GUTTER_PX[size], margin: MARGIN_PX[size] };
  }

  const scale = () => createScale(store.state.view, store.state.plotWidth);
  const bottom = () => pane.clientHeight;

  /** Creates a track the first time it is shown; hidden ones keep their chart. */
  function trackOf({ key, title, unit }) {
    if (tracks.has(key)) return tracks.get(key);
    const gutter = createGutter({ key, title, unit }, (name) => fold(store, name));
    const plot = el("div", { class: "plot", data: { track: key } });
    const marks = svg("g", { data: { marks: key } });
    const holder = svg("svg", { class: "marks" }, marks);
    const row = el("div", { class: "track", data: { key } }, gutter.node, plot, holder);
    content.append(row);
    const parts = { plot, marks, gutter: gutter.body, texts: gutter.texts };
    const drawn = LINED[key]?.(parts, store) ?? createTrack(key, parts);
    const track = { ...drawn, row, gutter, holder };
    tracks.set(key, track);
    return track;
  }

  function arrange(state) {
    if (!state.document) return;
    const { gutter, margin } = geometry();
    pane.style.setProperty("--gutter", `${gutter}px`);
    pane.style.setProperty("--margin", `${margin}px`);
    store.set({ plotWidth: Math.max(50, pane.clientWidth - gutter - margin) });
    layout = layOut(state, state.paneHeight);
    pane.style.setProperty("--head", `${layout.headHeight}px`);
    content.style.setProperty("height", `${layout.height - layout.headHeight}px`);
    for (const [key, gutterOf] of gutters) {
      const row = layout.rows.get(key);
      gutterOf.node.hidden = !row;
      if (row) gutterOf.place(row);
    }
    const shown = tracksOf(state);
    for (const { key } of TRACKS) if (tracks.has(key)) tracks.get(key).row.hidden = true;
    for (const definition of shown)
      placeTrack(trackOf(definition), layout.rows.get(definition.key));
    playhead.lay(layout, bottom());
    store.set({ layout });
  }

  function placeTrack(track, row) {
    track.row.hidden = false;
    track.row.classList.toggle("short", row.height < 66);
    track.row.style.setProperty("top", `${row.y - layout.headHeight}px`);
    track.row.style.setProperty("height", `${row.height}px`);
    track.gutter.place({ ...row, y: 0 });
  }

  function drawTracks(state) {
    if (!isReady(state)) return;
    for (const { key } of tracksOf(state)) {
      if (layout.rows.has(key) && tracks.has(key))
        tracks.get(key).draw(state, scale(), layout.rows.get(key));
    }
    readValues(state);
  }

  function drawLined(state) {
    if (!isReady(state)) return;
    for (const key of Object.keys(LINED))
      if (layout.rows.has(key)) tracks.get(key)?.draw(state, scale(), layout.rows.get(key));
  }

  function drawSegments(plain) {
    if (!isReady(plain)) return;
    const state = { ...plain, document: withDrag(plain.document, plain.drag) };
    const at = scale();
    groups.intervals.replaceChildren(...drawIntervals(state, at, layout, bottom()));
    groups.band.replaceChildren(...drawBand(state, at, layout.rows.get("segments")));
    groups.boundaries.replaceChildren(...drawBoundaries(state, at, layout, bottom()));
    groups.ghosts.replaceChildren(...drawGhosts(state, at, layout, bottom()));
    gutters.get("segments").describe(plain.document);
    gutters.get("boundaries").small.textContent = String(state.document.boundaries.length);
  }

  function drawView(state) {
    if (!isReady(state)) return;
    groups.ruler.replaceChildren(...drawRuler(scale(), layout.rows.get("ruler")));
    groups.overviewWindow.replaceChildren(
      ...drawWindow(state, layout.rows.get("overview"), state.plotWidth),
    );
  }

  function drawWhole(state) {
    if (isReady(state))
      groups.overviewCurve.replaceChildren(
        ...drawOverviewCurve(state, layout.rows.get("overview"), state.plotWidth),
      );
  }

  function drawOther(state) {
    const row = layout.rows.get("comparison");
    const shown = isReady(state) && row && state.comparison?.with;
    groups.comparison.replaceChildren(...(shown ? drawComparison(state, scale(), row) : []));
    if (shown) gutters.get("comparison").describe(state.comparison);
  }

  function drawStrip(state) {
    if (isReady(state))
      groups.overview.replaceChildren(
        ...drawOverviewStrip(state, layout.rows.get("overview"), state.plotWidth),
      );
  }

  function drawPlayhead(state) {
    if (!isReady(state)) return;
    const { document: doc, clock } = state;
    playhead.move(scale(), clock, groups.ruler.querySelectorAll("text"));
    const row = layout.rows.get("overview");
    const x = ((clock - doc.start_s) / (doc.end_s - doc.start_s)) * state.plotWidth;
    groups.overviewPlayhead.setAttribute("x", (x - 0.75).toFixed(1));
    groups.overviewPlayhead.setAttribute("y", String(row.y));
    groups.overviewPlayhead.setAttribute("height", String(row.height));
  }

  function readValues(state) {
    if (!isReady(state)) return;
    const time = state.pointer ?? state.clock;
    for (const { key } of tracksOf(state)) tracks.get(key)?.read(state, time);
    const x = state.pointer === null ? -1 : scale().x(state.pointer);
    const ruler = layout.rows.get("ruler");
    groups.pointer.setAttribute(
      "d",
      x < 0 || x > state.plotWidth
        ? ""
        : `M${Math.round(x) + 0.5} ${ruler.y + ruler.height}V${bottom()}`,
    );
  }

  store.on(
    ["recording", "method", "folded", "hidden", "small", "paneHeight", "paneWidth", "comparison"],
    arrange,
  );
  store.on(["recording", "view", "layout", "plotWidth"], drawView);
  store.on(["comparison", "view", "layout", "plotWidth"], drawOther);
  store.on(["recording", "layout", "plotWidth", "whole"], drawWhole);
  store.on(["document", "layout", "plotWidth"], drawStrip);
  store.on(
    [
      "document",
      "view",
      "layout",
      "plotWidth",
      "selected",
      "hovered",
      "current",
      "drag",
      "range",
      "ghost",
      "folded",
    ],
    drawSegments,
  );
  store.on(["view", "layout", "plotWidth", "whole", "fine", "folded"], drawTracks);
  store.on(["document", "held", "logarithmic", "candidate"], drawLined);
  store.on(["clock", "view", "layout", "plotWidth", "recording"], drawPlayhead);
  store.on(["pointer", "clock", "fine", "whole"], readValues);
  store.on(["dark"], (state) => {
    for (const track of tracks.values()) track.recolor();
    drawTracks(state);
  });
  new ResizeObserver(() =>
    store.set({ paneWidth: pane.clientWidth, paneHeight: pane.clientHeight }),
  ).observe(pane);

  return {
    surface,
    scroller,
    scale,
    layout: () => layout,
    ...evidenceOnSurface(store, {
      track: () => tracks.get("evidence"),
      row: () => layout.rows.get("evidence"),
      scale,
      scroller,
    }),
    /** Height the timeline wants, all rows shown. */
    naturalHeight: () => layOut(store.state).height,
    /** The error at a height of the surface, and the height of the threshold's line. */
    errorAt: (y) =>
      tracks.get("error")?.errorAt(y - layout.rows.get("error").y + scroller.scrollTop),
    thresholdY() {
      const row = layout.rows.get("error");
      const threshold = store.state.document ? thresholdOf(store.state) : null;
      if (!row || row.folded || threshold === null) return null;
      return (
        Math.min(Math.max(tracks.get("error")?.y(threshold) ?? NaN, 2), row.height - 2) +
        row.y -
        scroller.scrollTop
      );
    },
  };
}

const isReady = ({ document: doc, view, plotWidth, layout }) =>
  Boolean(doc && view && plotWidth && layout);

function layer(name) {
  return svg("svg", { class: `layer ${name}` });
}

/** The hatch of dropped segments. */
function clipPaths() {
  const hatch = svg(
    "pattern",
    {
      id: "hatch",
      width: 6,
      height: 6,
      patternUnits: "userSpaceOnUse",
      patternTransform: "rotate(45)",
    },
    svg("rect", { width: 6, height: 6, style: { fill: "var(--hatch)" } }),
    svg("rect", { width: 2.2, height: 6, style: { fill: "var(--hatch-line)" } }),
  );
  return { clips: svg("defs", {}, hatch) };
}
