/**
 * The band of segments: colour, number, label, how long, and how sure of its name. Labels give
 * way to shorter ones where they do not fit; the number stays longest.
 */

import { segmentFill } from "../lib/colors.js";
import { svg } from "../lib/dom.js";
import { chosenStretch } from "../model/segments.js";
import { duration } from "../lib/format.js";
import { formsOf } from "../model/label_forms.js";
import { runsOf, runText } from "./runs.js";
import { denseSegments, isCrowded, segmentsInView } from "./dense.js";
import { textWidth } from "../lib/text_width.js";

/**
 * The longest of the label and its short forms that fits, else "".
 * @param {import("../model/types.js").Segment|import("../model/types.js").Skill} segment
 * @param {number} room px
 * @param {string} font
 */
export function fittingLabel(segment, room, font) {
  return formsOf(segment).find((form) => textWidth(form, font) <= room) ?? "";
}

/**
 * @param {import("../lib/store.js").State} state
 * @param {import("../lib/scale.js").Scale} scale
 * @param {import("../model/rows.js").Row} row
 */
export function drawBand(state, scale, row) {
  const { document: doc, range } = state;
  const [first, last] = chosenStretch(state) ?? [-1, -2];
  const isChosen = (index) => index >= first && index <= last;
  const box = { top: row.y + 3, height: row.height - 6 };
  const nodes = [
    svg("rect", { y: row.y, width: scale.width, height: row.height, class: "band-ground" }),
  ];
  const rings = [];
  const dense = isCrowded(segmentsInView(doc.segments, scale).length, scale);
  if (dense) nodes.push(...denseSegments(doc.segments, scale, box.top, box.height));
  doc.segments.forEach((segment, index) => {
    if (segment.end_s < scale.from || segment.start_s > scale.to || (dense && !isChosen(index)))
      return;
    const left = Math.max(scale.x(segment.start_s), 0) + 1;
    const right = Math.min(scale.x(segment.end_s), scale.width) - 1;
    if (right - left < 0.5) return;
    const place = { ...box, left, width: Math.max(right - left, 1) };
    nodes.push(drawSegment(segment, index, place));
    if (isChosen(index)) rings.push(drawRing(place));
    if (isMarked(segment)) rings.push(...drawMark(segment, place));
  });
  nodes.push(...rings);
  if (range) nodes.push(drawRange(doc, range, scale, box));
  return nodes;
}

const NUMBER = "700 12px";
const PLATE_NUMBER = "11.5px";
const RUN = "11px";

/** Whether a segment has room for its own number. */
function hasNumber({ kept }, index, { width }) {
  const number = String(index + 1);
  return kept
    ? width >= textWidth(number, NUMBER) + 4
    : width >= textWidth(number, PLATE_NUMBER) + 8;
}

/**
 * Which segments those are that have no room for their numbers; over the boundaries between them.
 * @param {import("../lib/store.js").State} state
 * @param {import("../lib/scale.js").Scale} scale
 * @param {import("../model/rows.js").Row} row
 */
export function drawRuns({ document: doc }, scale, row) {
  const box = { top: row.y + 3, height: row.height - 6 };
  const seen = segmentsInView(doc.segments, scale);
  if (row.folded || isCrowded(seen.length, scale)) return [];
  const first = doc.segments.indexOf(seen[0]);
  const narrow = seen.map((segment, k) => {
    const left = Math.max(scale.x(segment.start_s), 0) + 1;
    const right = Math.min(scale.x(segment.end_s), scale.width) - 1;
    const fits = hasNumber(segment, first + k, { width: right - left });
    return { number: first + k + 1, left, right, fits };
  });
  return platesOf(narrow, box);
}

/** @param {import("./runs.js").Narrow[]} narrow @param {{top: number, height: number}} box */
function platesOf(narrow, { top, height }) {
  const widthOf = (first, last) => textWidth(runText(first, last), RUN) + 10;
  return runsOf(narrow, widthOf).map(({ first, last, left, right }) => {
    const width = widthOf(first, last) - 2;
    const middle = (left + right) / 2;
    const plate = { x: middle - width / 2, y: top + height / 2 - 8, width, height: 16, rx: 3 };
    return svg(
      "g",
      { class: "segment-run" },
      svg("rect", { ...plate, class: "segment-plate" }),
      svg("text", {
        x: middle,
        y: top + height / 2 + 4,
        "text-anchor": "middle",
        text: runText(first, last),
      }),
    );
  });
}

function drawSegment(segment, index, place) {
  const { left, top, width, height } = place;
  const dropped = !segment.kept;
  const fill = dropped ? "url(#hatch)" : segmentFill(segment);
  const group = svg("g", {
    class: `segment ${dropped ? "dropped" : "kept"}`,
    data: { segment: index },
  });
  group.append(svg("rect", { x: left, y: top, width, height, rx: 3, style: { fill } }));
  group.append(...(dropped ? droppedText(segment, index, place) : keptText(segment, index, place)));
  return group;
}

/** Number and label, below it (where there is room) how long and by whom it was named. */
function keptText(segment, index, { left, top, width, height }) {
  const number = String(index + 1);
  const numberWidth = textWidth(number, NUMBER);
  if (width < numberWidth + 4) return [];
  const textLeft = left + 9 + numberWidth + 7;
  const room = left + width - textLeft - 6 - markWidth(segment);
  const label = fittingLabel(segment, room, "600 12px");
  const two = height >= 30 && width > 70 && label !== "";
  const base = two ? top + 15 : top + height / 2 + 4;
  const numberX = label ? left + 9 : left + Math.min(9, (width - numberWidth) / 2);
  const nodes = [svg("text", { x: numberX, y: base, class: "segment-number", text: number })];
  if (!label) return nodes;
  nodes.push(svg("text", { x: textLeft, y: base, class: "segment-label", text: label }));
  if (segment.proposed) {
    const under = Math.min(textWidth(label, "600 12px"), room);
    nodes.push(
      svg("path", { d: `M${textLeft} ${base + 3.5}h${under}`, class: "segment-proposed" }),
    );
  }
  if (two) nodes.push(...secondLine(segment, textLeft, top + 29, room));
  return nodes;
}

function secondLine(segment, x, y, room) {
  const long = duration(segment.end_s - segment.start_s);
  const full = segment.proposed ? `${long} · proposed, Enter accepts` : `${long} · named by you`;
  const text = [full, long].find((form) => textWidth(form, "11px") <= room);
  return text ? [svg("text", { x, y, class: "segment-second", text })] : [];
}

/** Hatched, with the name on a plate so that it stays readable. */
function droppedText(segment, index, { left, top, width, height }) {
  const number = String(index + 1);
  const middle = top + height / 2;
  const numberWidth = textWidth(number, PLATE_NUMBER);
  if (width < numberWidth + 8) return [];
  const room = width - numberWidth - 38 - markWidth(segment);
  const label = fittingLabel(segment, room, "11.5px");
  const plate = label
    ? numberWidth + textWidth(label, "11.5px") + 24
    : Math.min(numberWidth + 12, width - 2);
  const at = left + Math.min(6, (width - plate) / 2);
  const nodes = [
    svg("rect", { x: at, y: middle - 9, width: plate, height: 18, rx: 3, class: "segment-plate" }),
    svg("text", {
      x: label ? at + 7 : at + (plate - numberWidth) / 2,
      y: middle + 4,
      class: "segment-plate-number",
      text: number,
    }),
  ];
  if (label)
    nodes.push(
      svg("text", {
        x: at + 14 + numberWidth,
        y: middle + 4,
        class: "segment-plate-label",
        text: label,
      }),
    );
  if (height >= 30 && width > plate + 70 && !isMarked(segment)) {
    const text = duration(segment.end_s - segment.start_s);
    nodes.push(
      svg("text", {
        x: left + width - 8,
        y: middle + 4,
        class: "segment-plate-second",
        "text-anchor": "end",
        text,
      }),
    );
  }
  return nodes;
}

/** @param {import("../model/types.js").Segment} segment */
const isMarked = ({ assessment: { outcome, quality, note } }) =>
  Boolean(outcome || quality || note);

/** What a person thinks of a segment, in a sign and a figure. */
const markText = ({ assessment: { outcome, quality } }) =>
  `${outcome ? { success: "✓", failure: "✗" }[outcome] : ""}${quality ?? ""}` || "…";

/** Room that the mark of a segment takes [px]. */
const markWidth = (segment) =>
  isMarked(segment) ? textWidth(markText(segment), "700 11px") + 10 : 0;

/** A narrower segment keeps its number, and its mark is a dot. */
const LEAST_BESIDE_MARK_PX = 26;

/** What a person thinks of it, in its upper right corner. */
function drawMark(segment, { left, top, width }) {
  const { outcome, quality, note } = segment.assessment;
  const told = [outcome, quality && `quality ${quality} of 5`, note].filter(Boolean).join(", ");
  const wide = markWidth(segment) - 2;
  const right = left + width - 2;
  const isDot = width < wide + LEAST_BESIDE_MARK_PX;
  const shape = isDot
    ? [svg("circle", { cx: right - 3, cy: top + 5, r: 3 })]
    : [
        svg("rect", { x: right - wide, y: top + 2, width: wide, height: 14, rx: 3 }),
        svg("text", {
          x: right - wide / 2,
          y: top + 13,
          "text-anchor": "middle",
          text: markText(segment),
        }),
      ];
  const look = `segment-mark ${outcome ?? ""}`;
  return [svg("g", { class: look }, svg("title", { text: told }), ...shape)];
}

/** The stretch that is being named by a key held down. @param {import("../lib/store.js").State} state */
export function drawNaming({ naming, clock }, scale, { y, height }) {
  if (!naming) return [];
  const [left, right] = [naming.from_s, clock].sort((a, b) => a - b).map((time) => scale.x(time));
  return [
    svg("rect", {
      x: left,
      y: y + 3,
      width: Math.max(1, right - left),
      height: height - 6,
      rx: 3,
      class: "naming-stretch",
    }),
    svg("text", { x: left + 8, y: y + height / 2 + 4, class: "naming", text: naming.label }),
  ];
}

/** The ring around a segment that is chosen, or a skill that runs. */
export function drawRing({ left, top, width, height }) {
  return svg(
    "g",
    { class: "segment-ring" },
    svg("rect", {
      x: left - 0.5,
      y: top - 0.5,
      width: width + 1,
      height: height + 1,
      rx: 4,
      class: "ring-gap",
    }),
    svg("rect", {
      x: left - 1,
      y: top - 1,
      width: width + 2,
      height: height + 2,
      rx: 4,
      class: "ring",
    }),
  );
}

/**
 * The segments dragged over, about to become one.
 * @param {import("../model/types.js").Doc} doc
 * @param {[number, number]} range
 * @param {import("../lib/scale.js").Scale} scale
 * @param {{top: number, height: number}} box
 */
function drawRange(doc, [first, last], scale, { top, height }) {
  const left = Math.max(scale.x(doc.segments[first].start_s), 0);
  const right = Math.min(scale.x(doc.segments[last].end_s), scale.width);
  return svg("rect", {
    x: left + 1,
    y: top,
    width: Math.max(1, right - left - 2),
    height,
    rx: 3,
    class: "band-range",
  });
}
