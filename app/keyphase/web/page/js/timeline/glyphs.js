/** The mark of a boundary: its shape says the origin, filled says the contact changed there. */

import { originColor } from "../lib/colors.js";
import { svg } from "../lib/dom.js";

/** @type {Object<string, (x: number, y: number, r: number) => [string, Object]>} */
const SHAPES = {
  position: (x, y, r) => ["circle", { cx: x, cy: y, r: 0.86 * r }],
  force: (x, y, r) => [
    "path",
    {
      d: `M${x} ${y - 1.15 * r}l${1.15 * r} ${1.15 * r} ${-1.15 * r} ${1.15 * r} ${-1.15 * r} ${-1.15 * r}z`,
    },
  ],
  both: (x, y, r) => ["rect", { x: x - r, y: y - 0.9 * r, width: 2 * r, height: 1.8 * r }],
  gripper: (x, y, r) => [
    "path",
    {
      d: `M${x - r} ${y - r}h${0.7 * r}v${1.3 * r}h${0.6 * r}v${-1.3 * r}h${0.7 * r}v${2 * r}h${-2 * r}z`,
    },
  ],
  user: (x, y, r) => ["path", { d: `M${x} ${y + r}L${x - 1.1 * r} ${y - 0.85 * r}h${2.2 * r}z` }],
};

/**
 * @param {import("../model/types.js").Origin} origin
 * @param {{x: number, y: number, r?: number, filled: boolean}} place
 */
export function glyph(origin, { x, y, r = 4.6, filled }) {
  const [tag, shape] = SHAPES[origin](x, y, r);
  const color = originColor(origin);
  const fill = filled || origin === "user" ? color : "var(--pane)";
  return svg(tag, { ...shape, class: "glyph", style: { fill, stroke: color } });
}

/** A glyph on its own, for legends and popovers. */
export function glyphIcon(origin, filled) {
  return svg(
    "svg",
    { width: 12, height: 12, viewBox: "0 0 12 12", "aria-hidden": "true" },
    glyph(origin, { x: 6, y: 6, r: 4, filled }),
  );
}
