/** Stretches in which nothing was demonstrated: hatched over all tracks, in words on hovering. */

import { svg } from "../lib/dom.js";
import { textWidth } from "../lib/text_width.js";

const LEAST_PX = 3;
const WORDS = "no data";

/**
 * @param {import("../lib/store.js").State} state
 * @param {import("../lib/scale.js").Scale} scale
 * @param {import("../model/rows.js").Layout} layout
 * @param {number} bottom
 */
export function drawBreaks({ document: doc }, scale, layout, bottom) {
  const { y, height } = layout.rows.get("ruler");
  const band = layout.rows.get("segments");
  return doc.breaks.flatMap((one) => {
    if (one.end_s < scale.from || one.start_s > scale.to) return [];
    const [left, right] = ends(one, scale);
    const width = Math.min(right, scale.width) - Math.max(left, 0);
    if (width <= 0) return [];
    const x = Math.max(left, 0);
    const place = { x, y: y + height, width, height: bottom - y - height };
    const nodes = [svg("rect", { ...place, class: "break", data: { break: one.text } })];
    if (band && !band.folded && width > textWidth(WORDS, "10.5px") + 8)
      nodes.push(
        svg("text", {
          x: x + width / 2,
          y: band.y + 12,
          class: "break-words",
          "text-anchor": "middle",
          text: WORDS,
        }),
      );
    return nodes;
  });
}

/**
 * What is said of a time that lies in one of them, else nothing.
 * @param {import("../model/types.js").Doc} doc
 * @param {number} x px
 * @param {import("../lib/scale.js").Scale} scale
 */
export function breakAt(doc, x, scale) {
  const found = doc.breaks.find((one) => {
    const [left, right] = ends(one, scale);
    return x >= left && x <= right;
  });
  return found?.text ?? "";
}

/** Wide enough to be seen and met. */
function ends({ start_s: start, end_s: end }, scale) {
  const [left, right] = [scale.x(start), scale.x(end)];
  const more = Math.max(0, LEAST_PX - (right - left)) / 2;
  return [left - more, right + more];
}

/** The hatches of dropped segments, and of stretches without data. */
export function hatches() {
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
  const breakHatch = svg(
    "pattern",
    {
      id: "break-hatch",
      width: 5,
      height: 5,
      patternUnits: "userSpaceOnUse",
      patternTransform: "rotate(-45)",
    },
    svg("rect", { width: 1.4, height: 5, class: "break-line" }),
  );
  return svg("defs", {}, hatch, breakHatch);
}
