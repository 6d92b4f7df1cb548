/** Where the other pages at this recording are: a small plate with a page's name on its segment. */

import { segmentFill } from "../lib/colors.js";
import { svg } from "../lib/dom.js";
import { textWidth } from "../lib/text_width.js";

const FONT = "700 10.5px";
const HEIGHT = 13;
/** In a band as low as this the segments' names reach down to its foot. */
const LOW_BAND_PX = 36;
/** Of a name that has no room its number is left, which the list has, too. */
const shortName = (name) => name.split(" ").at(-1) ?? name;

/**
 * @param {import("../lib/store.js").State} state
 * @param {import("../lib/scale.js").Scale} scale
 * @param {import("../model/rows.js").Row} row
 */
export function drawOthers({ others, document: doc }, scale, row) {
  /** @type {Map<number, number>} */
  const taken = new Map();
  return others.flatMap((other) => {
    const segment = doc.segments[other.segment];
    if (!segment || segment.end_s < scale.from || segment.start_s > scale.to) return [];
    const left = Math.max(scale.x(segment.start_s), 0) + 1;
    const right = Math.min(scale.x(segment.end_s), scale.width) - 1;
    const used = taken.get(other.segment) ?? 0;
    const foot = row.y + row.height - 3;
    const below = row.height < LOW_BAND_PX ? HEIGHT - 1 : 0;
    const mark = drawMark(other, { left, right: right - used, foot, y: foot + below });
    taken.set(other.segment, used + mark.width + 2);
    return [mark.node];
  });
}

/**
 * A line in the page's colour along the foot of the segment, and its name at the right end.
 * @param {import("../messages/document_messages").OtherSelected} other
 * @param {{left: number, right: number, foot: number, y: number}} place `y`: where the name ends
 */
function drawMark({ name, color }, { left, right, foot, y }) {
  const room = right - left;
  const text = textWidth(name, FONT) + 8 <= room ? name : shortName(name);
  const width = textWidth(text, FONT) + 8;
  const fill = segmentFill({ color });
  const node = svg(
    "g",
    { class: "segment-other" },
    svg("title", { text: `${name} has this segment selected` }),
    svg("rect", { x: left, y: foot - 3, width: Math.max(1, room), height: 3, style: { fill } }),
    svg("rect", { x: right - width, y: y - HEIGHT, width, height: HEIGHT, rx: 3, style: { fill } }),
    svg("text", { x: right - width / 2, y: y - 3, "text-anchor": "middle", text }),
  );
  return { node, width };
}
