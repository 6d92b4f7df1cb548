/** Another segmentation of the same recording, below the band: what both have, what only one. */

import { svg } from "../dom.js";
import { textWidth } from "./text_width.js";

const GLYPH_PX = 4;

/**
 * @param {import("../store.js").State} state
 * @param {import("./scale.js").Scale} scale
 * @param {import("./rows.js").Row} row
 */
export function drawComparison({ document: doc, comparison }, scale, { y, height }) {
  const { boundaries_s: boundaries, labels, shared, only_first_s: onlyFirst } = comparison;
  const edges = [doc.start_s, ...boundaries, doc.end_s];
  const isShared = (time) => shared.some(([, second]) => second === time);
  const nodes = labels.flatMap((label, k) => drawOther(label, edges[k], edges[k + 1], scale, y + 3, height - 6));
  for (const time of boundaries) nodes.push(tick(scale, time, y, height, isShared(time) ? "shared" : "only-second"));
  for (const time of onlyFirst) nodes.push(missing(scale, time, y + height / 2));
  return nodes;
}

/** How well the two agree, for the gutter. */
export function describeComparison({ f1, same_label: same }) {
  return `F1 ${f1.toFixed(2)}, labels ${Math.round(100 * same)} %`;
}

function drawOther(label, from, to, scale, top, height) {
  const left = Math.max(scale.x(from), 0) + 1;
  const right = Math.min(scale.x(to), scale.width) - 1;
  if (right - left < 1) return [];
  const box = svg("rect", { x: left, y: top, width: right - left, height, rx: 3, class: "other-segment" });
  if (textWidth(label, "10.5px") > right - left - 12) return [box];
  return [box, svg("text", { x: left + 6, y: top + height / 2 + 3.6, class: "other-label", text: label })];
}

function tick(scale, time, y, height, name) {
  const x = scale.x(time);
  return svg("path", { d: `M${x} ${y + 1}v${height - 2}`, class: `other-boundary ${name}` });
}

/** A boundary only the shown segmentation has: a gap's mark in the other's row. */
function missing(scale, time, y) {
  const x = scale.x(time);
  return svg("path", { d: `M${x - GLYPH_PX} ${y - GLYPH_PX}l${2 * GLYPH_PX} ${2 * GLYPH_PX}m0 ${-2 * GLYPH_PX}l${-2 * GLYPH_PX} ${2 * GLYPH_PX}`, class: "only-first" });
}
