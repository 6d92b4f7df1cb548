/**
 * The page's line icons on a 16 px grid: name to [tag, attributes] pairs, drawn with
 * `stroke: currentColor` unless they fill themselves.
 */

/** @typedef {[string, Object<string, string|number>]} Shape */

/** @param {string} d @returns {Shape} */
const line = (d) => ["path", { d }];
/** @param {string} d @returns {Shape} */
const solid = (d) => ["path", { d, class: "solid" }];
/** @param {number} cx @param {number} cy @param {number} r @returns {Shape} */
const ring = (cx, cy, r) => ["circle", { cx, cy, r }];
/** @param {number} cx @param {number} cy @param {number} r @returns {Shape} */
const dot = (cx, cy, r) => ["circle", { cx, cy, r, class: "solid" }];

/** @type {Object<string, Shape[]>} */
export const ICONS = {
  undo: [line("M6 3 3 6l3 3M3 6h6a4 4 0 0 1 0 8H7")],
  redo: [line("m10 3 3 3-3 3M13 6H7a4 4 0 0 0 0 8h2")],
  search: [ring(7, 7, 4), line("m10 10 3.5 3.5")],
  sun: [
    ring(8, 8, 3),
    line(
      "M8 1.5V3M8 13v1.5M1.5 8H3M13 8h1.5M3.4 3.4l1 1M11.6 11.6l1 1M12.6 3.4l-1 1M4.4 11.6l-1 1",
    ),
  ],
  moon: [line("M13 9.5A5.5 5.5 0 0 1 6.5 3a5.5 5.5 0 1 0 6.5 6.5z")],
  down: [line("m4 6 4 4 4-4")],
  up: [line("m4 10 4-4 4 4")],
  right: [line("m6 4 4 4-4 4")],
  left: [line("m10 4-4 4 4 4")],
  check: [line("m3 8.5 3.2 3.2L13 4.8")],
  split: [line("M8 2v12M5 5 2 8l3 3M11 5l3 3-3 3")],
  merge: [line("M8 2v12M2 5l3 3-3 3M14 5l-3 3 3 3")],
  drop: [line("M3 5h10M6.5 5V3.5h3V5M4.5 5l.6 8h5.8l.6-8")],
  label: [line("M2.5 8.5V3H8l5.5 5.5L8 14z"), dot(5.4, 5.8, 0.8)],
  snap: [line("M3.5 2.5h3V8a1.5 1.5 0 0 0 3 0V2.5h3V8a4.5 4.5 0 0 1-9 0zM3.5 5h3M9.5 5h3")],
  first: [line("M4 3v10M12.5 3.5 6.5 8l6 4.5z")],
  last: [line("M12 3v10M3.5 3.5l6 4.5-6 4.5z")],
  back: [line("m7 3.5-5 4.5 5 4.5zM14 3.5 9 8l5 4.5z")],
  forward: [line("m9 3.5 5 4.5-5 4.5zM2 3.5 7 8l-5 4.5z")],
  play: [solid("M5.5 3.5 12.5 8l-7 4.5z")],
  pause: [solid("M4.5 3.5h2.4v9H4.5zM9.1 3.5h2.4v9H9.1z")],
  stop: [solid("M4 4h8v8H4z")],
  step: [line("M4 3.5 9.5 8 4 12.5zM12 3.5v9")],
  hand: [
    line(
      "M5 8V4.2a1 1 0 0 1 2 0V7M7 7V3a1 1 0 0 1 2 0v4M9 7V3.8a1 1 0 0 1 2 0V9c0 3-1.2 4.5-3.4 4.5C5.4 13.5 4.5 12 3 9.5c-.5-.9.6-1.7 1.3-1z",
    ),
  ],
  loop: [line("M4 5h7a2.5 2.5 0 0 1 0 6H5M6 3 4 5l2 2M5 9l-2 2 2 2")],
  layers: [line("m8 2.5 6 3-6 3-6-3zM2 9l6 3 6-3")],
  folder: [line("M2 4.5h4.5L8 6h6v7H2z")],
  strips: [line("M2.5 3h5M9.5 3h4M2.5 8h3M7.5 8h6M2.5 13h7M11.5 13h2")],
  plus: [line("M8 4v8M4 8h8")],
  minus: [line("M4 8h8")],
  contact: [line("M2.5 13.5h11M8 2v7.5M5 7l3 3 3-3")],
  goal: [ring(8, 8, 5), dot(8, 8, 1.5)],
  grip: [
    dot(6, 4.5, 1),
    dot(10, 4.5, 1),
    dot(6, 8, 1),
    dot(10, 8, 1),
    dot(6, 11.5, 1),
    dot(10, 11.5, 1),
  ],
  file: [line("M4 2h5.5L13 5.5V14H4zM9 2v4h4M8.5 8v4M6.5 10.2 8.5 12l2-1.8")],
  warning: [line("M8 2.5 14.5 13.5h-13zM8 6.5v3.5M8 11.8v.2")],
  info: [ring(8, 8, 6), line("M8 7.5v3.5M8 5v.2")],
  panel: [line("M2.5 3h11v10h-11zM10 3v10")],
  robot: [line("M3 13.5h6M6 13.5V10l3.5-3L13 9.5M9.5 7 6.5 3"), dot(9.5, 7, 1)],
  camera: [line("M2 5h8.5v7H2zM10.5 7.5 14 5.5v6l-3.5-2")],
  close: [line("m4 4 8 8M12 4l-8 8")],
  queue: [line("M2.5 4h11M2.5 8h11M2.5 12h7")],
};
