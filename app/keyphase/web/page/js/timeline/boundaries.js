/** Boundaries: glyphs and times in their row, lines and uncertainty intervals over all tracks. */

import { chosenStretch } from "../model/segments.js";
import { originColor } from "../lib/colors.js";
import { svg } from "../lib/dom.js";
import { time as timeText } from "../lib/format.js";
import { denseBoundaries, isCrowded } from "./dense.js";
import { glyph } from "./glyphs.js";
import { textWidth } from "../lib/text_width.js";

/** Where boundaries stand closer than this on average, their lines step back. */
const DENSE_PX = 45;

/**
 * Shaded bands where boundaries may lie, and the stretch of the selected segment; drawn below
 * the curves.
 * @param {import("../lib/store.js").State} state
 * @param {import("../lib/scale.js").Scale} scale
 * @param {import("../model/rows.js").Layout} layout
 */
export function drawIntervals(state, scale, layout, bottom) {
  const { document: doc } = state;
  const top = layout.rows.get("boundaries").y;
  const bandBottom = layout.headHeight;
  const nodes = [];
  const crowded = isCrowded(countInView(doc, scale), scale);
  doc.boundaries.forEach((boundary) => {
    const [low, high] = boundary.interval_s;
    if (crowded || high < scale.from || low > scale.to) return;
    const left = Math.max(scale.x(low), 0);
    const right = Math.min(Math.max(scale.x(high), left + 3), scale.width);
    nodes.push(
      svg("rect", {
        x: left,
        y: top,
        width: Math.max(0, right - left),
        height: bottom - top,
        class: `interval ${boundary.origin}`,
        style: { fill: originColor(boundary.origin) },
      }),
    );
  });
  const [first, last] = (chosenStretch(state) ?? []).map((index) => doc.segments[index]);
  if (first && last) {
    const left = Math.max(scale.x(first.start_s), 0);
    const right = Math.min(scale.x(last.end_s), scale.width);
    if (right > left)
      nodes.push(
        svg("rect", {
          x: left,
          y: bandBottom,
          width: right - left,
          height: bottom - bandBottom,
          class: "selected-stretch",
        }),
      );
  }
  return nodes;
}

function countInView({ boundaries }, { from, to }) {
  return boundaries.filter(({ time_s: time }) => time >= from && time <= to).length;
}

/**
 * Lines over all tracks, ticks in the band, glyphs and times in the boundaries' own row.
 * @param {import("../lib/store.js").State} state
 * @param {import("../lib/scale.js").Scale} scale
 * @param {import("../model/rows.js").Layout} layout
 */
export function drawBoundaries(state, scale, layout, bottom) {
  const { document: doc, hovered, current, drag, folded } = state;
  const row = layout.rows.get("boundaries");
  const band = layout.rows.get("segments");
  const lineBottom = folded.has("boundaries") ? layout.headHeight : bottom;
  const texts = createTextRow(scale.width);
  const nodes = [];
  const seen = countInView(doc, scale);
  const dense = seen > scale.width / DENSE_PX ? "dense" : "";
  const crowded = isCrowded(seen, scale);
  if (crowded) nodes.push(...denseBoundaries(doc.boundaries, scale, row));
  doc.boundaries.forEach((boundary, index) => {
    if (crowded && index !== hovered && index !== current) return;
    const time = drag?.boundary === index ? drag.time : boundary.time_s;
    if (boundary.was_s !== null || drag?.boundary === index) {
      const was = drag?.boundary === index ? boundary.time_s : boundary.was_s;
      nodes.push(...drawWas(scale, was, row, lineBottom));
    }
    const x = scale.x(time);
    if (x < -6 || x > scale.width + 6) return;
    const strong = index === hovered || index === current;
    const color = originColor(boundary.origin);
    const middle = row.y + row.height / 2;
    const group = svg("g", {
      class: `boundary ${strong ? "strong" : dense}`,
      data: { boundary: index, origin: boundary.origin },
    });
    group.append(
      svg("path", {
        d: `M${x} ${middle}V${lineBottom}`,
        class: "boundary-line",
        style: { stroke: color },
      }),
      svg("rect", {
        x: x - 1.5,
        y: band.y + 4,
        width: 3,
        height: band.height - 8,
        style: { fill: color },
      }),
      strong
        ? svg("circle", { cx: x, cy: middle, r: 9, class: "halo", style: { fill: color } })
        : "",
      glyph(boundary.origin, { x, y: middle, filled: boundary.contact_change }),
    );
    nodes.push(group);
    texts.add(boundary, time, x, middle + 3.6, strong);
  });
  return [...nodes, ...texts.draw()];
}

/**
 * Where it was before a hand moved it.
 * @param {import("../lib/scale.js").Scale} scale
 */
function drawWas(scale, was, row, bottom) {
  const x = scale.x(was);
  if (x < 0 || x > scale.width) return [];
  return [
    svg("path", { d: `M${x} ${row.y + 4}V${bottom}`, class: "was-line" }),
    svg("circle", { cx: x, cy: row.y + row.height / 2, r: 3, class: "was-mark" }),
  ];
}

/**
 * The times beside the glyphs. One that would run into its neighbour moves to the other side or
 * is left out; strong and unsure ones come first.
 */
function createTextRow(width) {
  /** @type {{left: number, right: number}[]} */
  const taken = [];
  const wanted = [];
  return {
    add(boundary, time, x, y, strong) {
      taken.push({ left: x - 7, right: x + 7 });
      wanted.push({ boundary, time, x, y, strong });
    },
    draw() {
      const rank = ({ boundary, strong }) => (strong ? 0 : boundary.unsure ? 1 : 2);
      const nodes = [];
      for (const text of wanted.sort((a, b) => rank(a) - rank(b))) {
        const node = placeText(text, taken, width);
        if (node) nodes.push(node);
      }
      return nodes;
    },
  };
}

function placeText({ boundary, time, x, y, strong }, taken, width) {
  const main = timeText(time);
  const doubt = boundary.unsure ? ` ${boundary.confidence.toFixed(2)}` : "";
  const wide =
    textWidth(main, strong ? "700 11px" : "500 11px") + (doubt ? textWidth(doubt, "700 11px") : 0);
  const sides = [
    { left: x + 11, right: x + 11 + wide, anchor: "start", at: x + 11 },
    { left: x - 10 - wide, right: x - 10, anchor: "end", at: x - 10 },
  ];
  if (boundary.was_s !== null && boundary.was_s > time) sides.reverse();
  const free = sides.find(
    ({ left, right }) =>
      left >= 0 &&
      right <= width &&
      taken.every((other) => right < other.left || left > other.right || isOwn(other, x)),
  );
  if (!free) return null;
  taken.push({ left: free.left - 4, right: free.right + 4 });
  const text = svg("text", {
    x: free.at,
    y,
    "text-anchor": free.anchor,
    class: `boundary-time ${strong ? "strong" : ""}`,
    text: main,
  });
  if (doubt) text.append(svg("tspan", { class: "unsure", text: doubt }));
  return text;
}

const isOwn = ({ left, right }, x) => right - left === 14 && Math.abs(left + 7 - x) < 1e-6;

/**
 * Boundaries that would come or go if the held slider were let go now.
 * @param {import("../lib/store.js").State} state
 * @param {import("../lib/scale.js").Scale} scale
 * @param {import("../model/rows.js").Layout} layout
 */
export function drawGhosts(state, scale, layout, bottom) {
  const row = layout.rows.get("boundaries");
  const nodes = [];
  for (const { time_s: time, origin, fate } of state.ghost) {
    const x = scale.x(time);
    if (x < 0 || x > scale.width) continue;
    const color = originColor(origin);
    nodes.push(
      svg(
        "g",
        { class: `ghost ${fate}`, data: { fate } },
        svg("path", { d: `M${x} ${row.y + row.height / 2}V${bottom}`, style: { stroke: color } }),
        svg("g", {}, glyph(origin, { x, y: row.y + row.height / 2, filled: false })),
        svg("text", {
          x: x + 9,
          y: row.y + row.height / 2 + 3.6,
          class: "ghost-text",
          style: { fill: color },
          text: fate === "comes" ? "+" : "−",
        }),
      ),
    );
  }
  return nodes;
}
