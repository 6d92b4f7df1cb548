/**
 * How many boundaries are found wherever a line lies: a curve on its side at the end of the track,
 * on the track's own scale, shown while the line is held or under the pointer. Where it stands
 * straight the line can go with nothing changing.
 */

import { originColor } from "../../lib/colors.js";
import { svg } from "../../lib/dom.js";
import { countAt, countsOf, foundText, stretchAt } from "../../model/evidence.js";

const WIDE_PX = 110;
const AIR_PX = 8;
/** The text stands above the line unless that is nearer than this to the track's top. */
const TEXT_PX = 18;
const LETTER_PX = 5.6;

/**
 * @param {import("../../model/evidence.js").LineInForce[]} lines
 * @param {import("../../lib/store.js").State} state
 * @param {import("../../lib/scale.js").Scale} scale
 * @param {(probability: number) => number} y
 */
export function drawProfile(lines, state, scale, y) {
  const line = lines.find(
    ({ parameter }) => parameter in state.held || state.lineOver === parameter,
  );
  const counts = line && countsOf(state.document, line.parameter);
  if (!line || !counts) return [];
  const most = Math.max(...counts.counts, 1);
  const right = scale.width - AIR_PX;
  const x = (count) => right - ((WIDE_PX - 2 * AIR_PX) * count) / most;
  const color = originColor(line.origin);
  const now = countAt(counts, line.value);
  const [low, high] = stretchAt(counts, line.value);
  const level = y(line.value);
  return [
    svg(
      "g",
      { class: "evidence-profile", data: { profile: line.parameter, count: now } },
      svg("rect", {
        class: "profile-ground",
        x: scale.width - WIDE_PX,
        y: y(1),
        width: WIDE_PX,
        height: y(0) - y(1),
      }),
      svg("path", {
        class: "profile-area",
        d: areaOf(counts, x, y, right),
        style: { fill: color },
      }),
      svg("path", {
        class: "profile-plateau",
        d: `M${x(now)} ${y(low)}V${y(high)}`,
        style: { stroke: color },
      }),
      svg("circle", { cx: x(now), cy: level, r: 3.5, style: { fill: color } }),
      ...told(
        foundText(counts, line.value),
        scale.width - WIDE_PX - 8,
        level - y(1) > TEXT_PX ? level - 6 : level + 15,
      ),
    ),
  ];
}

/** From the least probability at the bottom to the greatest at the top, a step at each change. */
function areaOf({ steps, counts }, x, y, right) {
  const levels = [0, ...steps, 1].map(y);
  const edges = counts.map((count, k) => `H${x(count)}V${levels[k + 1]}`);
  return `M${right} ${levels[0]}${edges.join("")}H${right}Z`;
}

/** A line of text that ends at `x`, on a plate. */
function told(text, x, y) {
  const width = LETTER_PX * text.length + 8;
  const plate = { class: "profile-ground", x: x - width + 4, y: y - 11, width, height: 15, rx: 3 };
  return [svg("rect", plate), svg("text", { x, y, text })];
}
