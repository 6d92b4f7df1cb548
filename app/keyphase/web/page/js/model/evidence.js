/**
 * The evidence for boundaries: probabilities over time and the two lines that choose among them.
 * A height in the track is a share of the way of the panel's sliders, so both run alike.
 *
 * @typedef {"contact"|"motion"} Kind
 * @typedef {{kind: Kind, parameter: "force_threshold"|"motion_threshold",
 *   origin: import("./types.js").Origin, title: string}} Line
 */

import { automaticValue, PROBABILITY, shareOf, valueAtShare, valueInForce } from "./parameters.js";

/** @type {Line[]} */
export const LINES = [
  { kind: "contact", parameter: "force_threshold", origin: "force", title: "Force threshold" },
  { kind: "motion", parameter: "motion_threshold", origin: "position", title: "Motion threshold" },
];

/** So near its automatic value a line falls back to it. */
const CATCHES_PX = 5;

/** Where a probability is drawn, from 0 (unlikely) to 1. @param {number} probability */
export const heightOf = (probability) => shareOf(PROBABILITY, probability);

/** The probability drawn at a height. @param {number} height */
export const probabilityAt = (height) =>
  valueAtShare(PROBABILITY, Math.min(Math.max(height, 0), 1));

/**
 * The lines of a recording, each with the value in force and its automatic value; none in the
 * published way.
 * @param {{document: import("./types.js").Doc, held: Object<string, *>}} state
 */
export function linesOf({ document: doc, held }) {
  if (doc.parameters.variant !== "evidence") return [];
  return LINES.map((line) => ({
    ...line,
    value: valueInForce(doc, held, line.parameter),
    automatic: automaticValue(doc, {}, line.parameter),
  })).filter(({ value }) => value !== null);
}

/**
 * What a line let go at a height becomes: null, the automatic value, where it is near that.
 * @param {number} height
 * @param {number|null} automatic
 * @param {number} pixels that the whole way is high
 * @returns {number|null}
 */
export function lineValue(height, automatic, pixels) {
  const away = automatic === null ? Infinity : Math.abs(height - heightOf(automatic)) * pixels;
  return away <= CATCHES_PX ? null : probabilityAt(height);
}

/**
 * @typedef {ReturnType<typeof linesOf>[number]} LineInForce
 * @typedef {import("../messages/document_messages").LineCounts} Counts
 *
 * How many boundaries come of each place of a line, where that is known.
 * @param {import("./types.js").Doc|null} doc
 * @param {string} parameter
 * @returns {Counts|undefined}
 */
export const countsOf = (doc, parameter) =>
  doc?.line_counts?.find((one) => one.parameter === parameter);

/** How many are found with the line here. @param {Counts} counts @param {number} line */
export const countAt = ({ steps, counts }, line) => counts[stepsBelow(steps, line)];

/** From where to where the number stays the same. @param {Counts} counts @param {number} line */
export function stretchAt({ steps }, line) {
  const below = stepsBelow(steps, line);
  return [steps[below - 1] ?? PROBABILITY.low, steps[below] ?? PROBABILITY.high];
}

/** Two digits, and near the ends of the way four: "0.35", ".0007". @param {number} value */
export const probabilityText = (value) =>
  value < 0.01 || value > 0.99 ? value.toFixed(4).slice(1) : value.toFixed(2);

/**
 * How many are found with the line here, and how far it could go for that; where nothing more would
 * come of it further down, that is said.
 * @param {Counts} counts
 * @param {number} line
 */
export function foundText(counts, line) {
  const found = `${countAt(counts, line)} found`;
  const [low, high] = stretchAt(counts, line).map(probabilityText);
  if (!counts.steps.length) return `${found} wherever the line lies`;
  if (stepsBelow(counts.steps, line)) return `${found}, the same from ${low} to ${high}`;
  return `${found}, no more below; the same up to ${high}`;
}

const stepsBelow = (steps, line) => steps.filter((step) => step < line).length;

/** What else holds boundaries back, in words. @type {Object<string, string>} */
export const FILTERS = { least_step_N: "the least step", turns: "turns" };

/**
 * Heights of tags that would overlap, moved apart within a track.
 * @param {number[]} wanted px
 * @param {number} apart px
 * @param {[number, number]} room lowest and highest px
 */
export function apart(wanted, apart, [top, bottom]) {
  const order = wanted.map((_, k) => k).sort((a, b) => wanted[a] - wanted[b]);
  const levels = [...wanted];
  order.forEach((k, n) => {
    levels[k] = Math.max(levels[k], n ? levels[order[n - 1]] + apart : top);
  });
  [...order].reverse().forEach((k, n, back) => {
    levels[k] = Math.min(levels[k], n ? levels[back[n - 1]] - apart : bottom);
  });
  return levels;
}
