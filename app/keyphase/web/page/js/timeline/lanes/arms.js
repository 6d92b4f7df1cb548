/** What the other tools of this recording did meanwhile: a faint lane each, below the segments. */

import { segmentFill } from "../../lib/colors.js";
import { el, svg } from "../../lib/dom.js";
import { textWidth } from "../../lib/text_width.js";

/** @typedef {import("../../messages/comparison_messages").LaneMessage} Lane */

/**
 * @param {Lane[]} lanes
 * @param {import("../../lib/scale.js").Scale} scale
 * @param {import("../../model/rows.js").Row} row
 */
export function drawLanes(lanes, scale, { y, height }) {
  const each = height / lanes.length;
  const ground = svg("rect", { y, width: scale.width, height, class: "band-ground" });
  const segments = lanes.flatMap(({ segments }, k) =>
    segments.flatMap((segment) => drawSegment(segment, scale, y + k * each + 2, each - 4)),
  );
  return [ground, ...segments];
}

/**
 * @param {Lane["segments"][number]} segment
 * @param {import("../../lib/scale.js").Scale} scale
 * @param {number} top
 * @param {number} height
 */
function drawSegment({ start_s: from, end_s: to, label, color }, scale, top, height) {
  const left = Math.max(scale.x(from), 0) + 1;
  const right = Math.min(scale.x(to), scale.width) - 1;
  if (right - left < 1) return [];
  const fill = color === null ? "var(--idle)" : segmentFill({ color });
  const place = { x: left, y: top, width: right - left, height, rx: 3 };
  const box = svg("rect", { ...place, class: "lane-segment", style: { fill } });
  if (textWidth(label, "10.5px") > right - left - 10) return [box];
  return [
    box,
    svg("text", { x: left + 5, y: top + height / 2 + 3.6, class: "lane-words", text: label }),
  ];
}

/**
 * The names left of the lanes; pressing one opens that tool.
 * @param {{body: HTMLElement}} gutter
 * @param {{open: (id: string) => void}} actions
 */
export function createLaneNames({ body }, actions) {
  /** @type {Lane[]|null} */
  let told = null;
  /** @param {Lane[]} lanes */
  return (lanes) => {
    if (told === lanes) return;
    told = lanes;
    body.replaceChildren(
      ...lanes.map(({ id, name }) =>
        el("button", {
          type: "button",
          class: "lane-name",
          title: `Open ${name}, recorded at the same time`,
          text: name,
          on: { click: () => actions.open(id) },
        }),
      ),
    );
  };
}
