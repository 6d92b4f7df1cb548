/**
 * The timeline: rows on one time axis. This file lays them out and says what is drawn anew when;
 * every kind of row draws itself in a file of its own.
 */

import { thresholdOf } from "./error_track.js";
import { evidenceOnSurface } from "./evidence/on_surface.js";
import { createHeadGutters } from "./head_gutters.js";
import { createFilmStrip } from "./film_strip.js";
import { layOut } from "../model/rows.js";
import { createPlayhead } from "./ruler.js";
import { createScale } from "../lib/scale.js";
import * as head from "./stage/head_rows.js";
import { createLayers } from "./stage/layers.js";
import { createTrackRows } from "./stage/track_rows.js";

const MARGIN_PX = { large: 42, small: 40 };
const GUTTER_PX = { large: 172, small: 132 };

/**
 * @param {HTMLElement} pane
 * @param {import("../lib/store.js").Store} store
 * @param {any} actions
 */
export function createTimeline(pane, store, actions) {
  const { groups, scroller, content, surface } = createLayers(pane);
  const scale = () => createScale(store.state.view, store.state.plotWidth);
  const stage = {
    groups,
    gutters: createHeadGutters(pane, store, actions),
    playhead: createPlayhead(groups.playhead),
    film: createFilmStrip(store, groups.cameras, scale),
    scale,
    bottom: () => store.state.paneHeight,
  };
  const tracks = createTrackRows(content, store, actions);
  arrangeOn(pane, content, store, stage, tracks);
  drawOn(store, stage, tracks);
  new ResizeObserver(() =>
    store.set({ paneWidth: pane.clientWidth, paneHeight: pane.clientHeight }),
  ).observe(pane);
  return {
    surface,
    scroller,
    scale,
    layout: () => store.state.layout ?? layOut(store.state),
    ...evidenceOnSurface(store, {
      track: () => tracks.get("evidence"),
      row: () => store.state.layout?.rows.get("evidence"),
      scale,
      scroller,
    }),
    ...errorOnSurface(store, tracks, scroller),
    /** Height the timeline wants, all rows shown. */
    naturalHeight: () => layOut(store.state).height,
  };
}

/**
 * Gives every row its place, whenever rows come, go or change their height.
 * @param {HTMLElement} pane
 * @param {HTMLElement} content
 * @param {import("../lib/store.js").Store} store
 * @param {head.Stage} stage
 * @param {ReturnType<typeof createTrackRows>} tracks
 */
function arrangeOn(pane, content, store, stage, tracks) {
  store.on(
    [
      "recording",
      "method",
      "folded",
      "hidden",
      "small",
      "paneHeight",
      "paneWidth",
      "comparison",
      "cameras",
      "camerasShown",
      "lanes",
    ],
    (state) => {
      if (!state.document) return;
      const size = state.small ? "small" : "large";
      pane.style.setProperty("--gutter", `${GUTTER_PX[size]}px`);
      pane.style.setProperty("--margin", `${MARGIN_PX[size]}px`);
      store.set({
        plotWidth: Math.max(50, pane.clientWidth - GUTTER_PX[size] - MARGIN_PX[size]),
      });
      const layout = layOut(state, state.paneHeight);
      pane.style.setProperty("--head", `${layout.headHeight}px`);
      content.style.setProperty("height", `${layout.height - layout.headHeight}px`);
      for (const [key, gutterOf] of stage.gutters) {
        const row = layout.rows.get(key);
        gutterOf.node.hidden = !row;
        if (row) gutterOf.place(row);
      }
      tracks.place(state, layout);
      stage.playhead.lay(layout, stage.bottom());
      store.set({ layout });
    },
  );
}

/** What the segments and boundaries are drawn from. */
const SEGMENTS = [
  "document",
  "selected",
  "selectedTo",
  "hovered",
  "current",
  "drag",
  "range",
  "ghost",
  "folded",
  "others",
];
const PLACE = ["view", "layout", "plotWidth"];

/**
 * Draws every layer when what it shows has changed.
 * @param {import("../lib/store.js").Store} store
 * @param {head.Stage} stage
 * @param {ReturnType<typeof createTrackRows>} tracks
 */
function drawOn(store, stage, tracks) {
  /** @param {string[]} names @param {(state: import("../lib/store.js").State) => void} draw */
  const on = (names, draw) => store.on(names, (state) => isReady(state) && draw(state));
  const read = (state) => {
    tracks.read(state, state.pointer ?? state.clock);
    head.drawPointer(stage, state);
  };
  const drawTracks = (state) => {
    tracks.drawAll(state, stage.scale());
    read(state);
  };
  on(["recording", ...PLACE], (state) => head.drawView(stage, state));
  on(["recording", ...PLACE], (state) => head.drawLogged(stage, state));
  on(["lanes", ...PLACE], (state) => head.drawArms(stage, state));
  on(["comparison", ...PLACE], (state) => head.drawOther(stage, state));
  on(["document", "cameras", "camerasShown", "camerasChosen", ...PLACE], stage.film);
  on(["recording", "layout", "plotWidth", "whole"], (state) => head.drawWhole(stage, state));
  on(["document", "layout", "plotWidth"], (state) => head.drawStrip(stage, state));
  on([...SEGMENTS, ...PLACE], (state) => head.drawSegments(stage, state));
  on([...PLACE, "whole", "fine", "folded"], drawTracks);
  on(["document", "held", "logarithmic", "candidate", "lineOver"], (state) =>
    tracks.drawLined(state, stage.scale()),
  );
  on(["clock", "recording", ...PLACE], (state) => head.drawPlayhead(stage, state));
  on(["naming"], (state) => head.drawHeldLabel(stage, state));
  on(["clock"], (state) => state.naming && head.drawHeldLabel(stage, state));
  on(["pointer", "clock", "fine", "whole"], read);
  store.on(["dark"], (state) => {
    tracks.recolor();
    if (isReady(state)) drawTracks(state);
  });
}

/**
 * The error track as the pointer meets it on the surface over all rows.
 * @param {import("../lib/store.js").Store} store
 * @param {ReturnType<typeof createTrackRows>} tracks
 * @param {HTMLElement} scroller
 */
function errorOnSurface({ state }, tracks, scroller) {
  const rowNow = () => state.layout?.rows.get("error");
  return {
    /** The error at a height of the surface. @param {number} y */
    errorAt: (y) => tracks.get("error")?.errorAt(y - rowNow().y + scroller.scrollTop),
    /** The height of the threshold's line. */
    thresholdY() {
      const row = rowNow();
      const threshold = state.document ? thresholdOf(state) : null;
      if (!row || row.folded || threshold === null) return null;
      const inside = tracks.get("error")?.y(threshold) ?? NaN;
      return Math.min(Math.max(inside, 2), row.height - 2) + row.y - scroller.scrollTop;
    },
  };
}

/** @param {import("../lib/store.js").State} state */
const isReady = ({ document: doc, view, plotWidth, layout }) =>
  Boolean(doc && view && plotWidth && layout);
