/** The tracks below the head: made when they are first shown, placed, drawn, read. */

import { el, svg } from "../../lib/dom.js";
import { fold, tracksOf } from "../../model/rows.js";
import { createErrorTrack } from "../error_track.js";
import { createEvidenceTrack } from "../evidence/evidence_track.js";
import { createGutter } from "../gutter.js";
import { createTrack } from "../tracks.js";

/** @type {Object<string, (parts: any, store: any, actions: any) => any>} tracks with lines that one can drag */
const LINED = { error: createErrorTrack, evidence: createEvidenceTrack };

/**
 * @param {HTMLElement} content what holds the rows
 * @param {import("../../lib/store.js").Store} store
 * @param {any} actions
 */
export function createTrackRows(content, store, actions) {
  /** @type {Map<string, any>} */
  const tracks = new Map();

  /** Creates a track the first time it is shown; hidden ones keep their chart. */
  function trackOf(definition) {
    const known = tracks.get(definition.key);
    if (known) return known;
    const track = makeTrack(definition, store, actions);
    content.append(track.row);
    tracks.set(definition.key, track);
    return track;
  }

  /**
   * @param {string[]} keys
   * @param {import("../../lib/store.js").State} state
   * @param {import("../../lib/scale.js").Scale} scale
   */
  function draw(keys, state, scale) {
    for (const key of keys) {
      const row = state.layout?.rows.get(key);
      if (row) tracks.get(key)?.draw(state, scale, row);
    }
  }

  return {
    /** @param {string} key */
    get: (key) => tracks.get(key),
    /**
     * @param {import("../../lib/store.js").State} state
     * @param {import("../../model/rows.js").Layout} layout
     */
    place(state, layout) {
      for (const track of tracks.values()) track.row.hidden = true;
      for (const definition of tracksOf(state))
        placeTrack(trackOf(definition), layout.rows.get(definition.key), layout.headHeight);
    },
    /** @type {(state: import("../../lib/store.js").State, scale: import("../../lib/scale.js").Scale) => void} */
    drawAll: (state, scale) =>
      draw(
        tracksOf(state).map(({ key }) => key),
        state,
        scale,
      ),
    /** Those whose lines a person drags. @type {(state: import("../../lib/store.js").State, scale: import("../../lib/scale.js").Scale) => void} */
    drawLined: (state, scale) => draw(Object.keys(LINED), state, scale),
    /** The values at a time into the gutters. @param {import("../../lib/store.js").State} state @param {number} time */
    read(state, time) {
      for (const { key } of tracksOf(state)) tracks.get(key)?.read(state, time);
    },
    recolor() {
      for (const track of tracks.values()) track.recolor();
    },
  };
}

/**
 * @param {{key: string, title: string, unit: string}} definition
 * @param {import("../../lib/store.js").Store} store
 * @param {any} actions
 */
function makeTrack({ key, title, unit }, store, actions) {
  const gutter = createGutter({ key, title, unit }, (name) => fold(store, name));
  const plot = el("div", { class: "plot", data: { track: key } });
  const marks = svg("g", { data: { marks: key } });
  const holder = svg("svg", { class: "marks" }, marks);
  const row = el("div", { class: "track", data: { key } }, gutter.node, plot, holder);
  const parts = { plot, marks, gutter: gutter.body, texts: gutter.texts };
  return {
    ...(LINED[key]?.(parts, store, actions) ?? createTrack(key, parts)),
    row,
    gutter,
    holder,
  };
}

/** @param {any} track @param {import("../../model/rows.js").Row} row @param {number} head px above */
function placeTrack(track, row, head) {
  track.row.hidden = false;
  track.row.classList.toggle("short", row.height < 66);
  track.row.style.setProperty("top", `${row.y - head}px`);
  track.row.style.setProperty("height", `${row.height}px`);
  track.gutter.place({ ...row, y: 0 });
}
