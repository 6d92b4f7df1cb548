/** The strips of the grid: one row for each recording, with its segments and how it stands. */

import { el } from "../../lib/dom.js";
import { plural, time as timeText } from "../../lib/format.js";
import {
  calledAfter,
  changed,
  colorOf,
  effectOf,
  EQUAL,
  inOrder,
  laidOut,
  phaseNames,
} from "../../model/recordings/grid.js";
import { namesOf } from "../../model/recordings/recording_list.js";
import { nameInTwo } from "../name_in_two.js";
import { stateMark } from "../queue_row.js";

/**
 * @typedef {import("../../model/recordings/grid.js").Grid} Grid
 * @typedef {import("../../model/recordings/grid.js").Line} Line
 * @typedef {import("../../model/recordings/grid.js").Piece} Piece
 * @typedef {import("../../model/recordings/grid.js").Change} Change
 * @typedef {{align: string, change: Change|null, includeDone: boolean, current: string|null,
 *   open: (id: string, time_s: number) => void}} How
 */

/** A name in less than this is not read. */
const LEAST_NAME_PX = 30;

export const rowId = (id) => `grid-${id}`;

/**
 * @param {Grid} grid
 * @param {How} how
 * @param {number} width of a strip, in px
 */
export function drawRows(grid, how, width) {
  const names = phaseNames(grid);
  const places = laidOut(grid, how.align);
  const changing = how.change ? effectOf(grid, how.change, how.includeDone).changing : [];
  const given = { grid, names, how, width };
  return inOrder(grid.rows).map((row) =>
    drawRow(row, places.get(row.id) ?? null, changing.includes(row), given),
  );
}

/**
 * @param {Line} row
 * @param {Piece[]|null} pieces
 * @param {boolean} changes
 * @param {{grid: Grid, names: string[], how: How, width: number}} given
 */
function drawRow(row, pieces, changes, given) {
  const { change, current, open } = given.how;
  const after = changes && change && pieces;
  return el(
    "div",
    {
      id: rowId(row.id),
      class: `grid-row ${change && !changes ? "same" : ""} ${row.id === current ? "on" : ""}`,
      role: "option",
      "aria-selected": String(row.id === current),
      title: row.error ?? row.name,
      data: { recording: row.id },
      on: { click: () => open(row.id, row.stretches[0]?.start_s ?? 0) },
    },
    el("span", { class: "unseen", text: spoken(row, changes ? change : null) }),
    el("span", { "aria-hidden": "true" }, stateMark(row.state)),
    el("span", { class: "grid-name", dir: "auto", "aria-hidden": "true" }, ...nameInTwo(row.name)),
    standing(row),
    el(
      "div",
      { class: `grid-strips ${after ? "two" : ""}`, "aria-hidden": "true" },
      drawStrip(row, pieces, given, after ? "before" : ""),
      after &&
        drawStrip(
          row,
          pieces.map((piece) => ({ ...piece, stretch: changed(piece.stretch, change) })),
          { ...given, ...calledAfter(given.grid, given.names, change) },
          "after",
        ),
    ),
  );
}

/**
 * @param {Line} row
 * @param {Piece[]|null} pieces
 * @param {{grid: Grid, names: string[], how: How, width: number}} given
 * @param {string} when
 */
function drawStrip(row, pieces, given, when) {
  const { align } = given.how;
  const told = row.error
    ? "cannot be read"
    : pieces === null
      ? missing(align)
      : row.stretches.length
        ? null
        : "not looked at yet";
  if (told) return el("div", { class: "grid-strip told", text: told });
  return el(
    "div",
    { class: `grid-strip ${when} ${row.proposed_from.length ? "proposed" : ""}` },
    ...(pieces ?? []).map((piece) => drawPiece(row, piece, given)),
  );
}

/** @param {string} align */
const missing = (align) => (align === EQUAL ? "none of these phases" : `no “${align.slice(3)}”`);

/**
 * @param {Line} row
 * @param {Piece} piece
 * @param {{grid: Grid, names: string[], how: How, width: number}} given
 */
function drawPiece(row, { stretch, from, width, astray }, { grid, names, how, width: whole }) {
  const color = colorOf(grid, stretch, names);
  const { label, start_s, end_s } = stretch;
  const fits = color !== null && width * whole >= LEAST_NAME_PX;
  return el("i", {
    class: `${color === null ? "dropped" : ""} ${astray ? "astray" : ""}`,
    style: {
      left: `${100 * from}%`,
      width: `${100 * width}%`,
      ...(color === null ? {} : { background: color }),
    },
    text: fits ? label : "",
    title: `${label || "no name"}, ${timeText(start_s, 2)} to ${timeText(end_s, 2)} s${color === null ? ", dropped" : ""}${astray ? ", in another order" : ""}`,
    data: { start: start_s },
    on: {
      click(event) {
        event.stopPropagation();
        how.open(row.id, start_s);
      },
    },
  });
}

/** How it stands, in a word. @param {Line} row */
function standing({ standing: stands, unsure, proposed_from: from, differs }) {
  const [text, title] = {
    outlier: [
      "outlier",
      "It fits none of the recordings that are done; nothing is proposed for it",
    ],
    differs: ["differs", `Proposed from ${namesOf(from)}, but ${differs?.told}`],
    unsure: from.length
      ? ["unsure", `Proposed from ${namesOf(from)}, and not sure of all of it`]
      : [`${unsure} unsure`, `${plural(unsure, "boundary", "boundaries")} to look at`],
    proposed: ["proposed", `Proposed from ${namesOf(from)}`],
    waiting: ["…", "Not looked at yet"],
    broken: ["broken", "It cannot be read"],
  }[stands] ?? [stands, ""];
  return el("span", {
    class: `grid-standing ${stands}`,
    text,
    title,
    "aria-hidden": "true",
  });
}

/** What a reader of the screen says of a row. @param {Line} row @param {Change|null} change */
function spoken(row, change) {
  const named = (stretches) =>
    stretches
      .filter(({ color }) => color !== null)
      .map(({ label, start_s }) => `${label || "no name"} at ${timeText(start_s, 1)} s`)
      .join(", ");
  const stands = row.standing === row.state ? row.state : `${row.state}, ${row.standing}`;
  const after = change
    ? `; after the change: ${named(row.stretches.map((one) => changed(one, change)))}`
    : "";
  return `${row.name}, ${stands}: ${named(row.stretches) || "no segments"}${after}`;
}
