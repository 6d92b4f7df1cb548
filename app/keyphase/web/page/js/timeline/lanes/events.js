/** What the log says in words, and what its buttons did: a mark each, its words where there is room. */

import { svg } from "../../lib/dom.js";
import { fitted } from "../../lib/text_width.js";

const MARK_PX = 3.5;
const CLEAR_PX = 8;

/**
 * @param {import("../../model/types.js").Doc} doc
 * @param {import("../../lib/scale.js").Scale} scale
 * @param {import("../../model/rows.js").Row} row
 */
export function drawEvents({ events }, scale, { y, height }) {
  const middle = y + height / 2;
  const ground = svg("rect", { y, width: scale.width, height, class: "band-ground" });
  const marks = events.flatMap(({ time_s: time, text }, k) => {
    const x = scale.x(time);
    if (x < -MARK_PX || x > scale.width + MARK_PX) return [];
    const next = events[k + 1] ? scale.x(events[k + 1].time_s) : scale.width;
    return [mark(x, middle, text), ...words(text, x, Math.min(next, scale.width), middle)];
  });
  return [ground, ...marks];
}

/** @param {number} x @param {number} middle @param {string} text */
function mark(x, middle, text) {
  const d = `M${x} ${middle - MARK_PX}l${MARK_PX} ${MARK_PX}l${-MARK_PX} ${MARK_PX}l${-MARK_PX} ${-MARK_PX}z`;
  return svg("path", { d, class: "event-mark", data: { event: text } });
}

/** The words right of the mark, cut where the next one begins; none where little would be left. */
function words(text, x, until, middle) {
  const room = until - x - MARK_PX - CLEAR_PX;
  const shown = fitted(text, "10.5px", room);
  if (!shown) return [];
  return [svg("text", { x: x + MARK_PX + 3, y: middle + 3.6, class: "event-words", text: shown })];
}

/**
 * What is written at a mark under the pointer, else nothing.
 * @param {import("../../model/types.js").Doc} doc
 * @param {number} x px
 * @param {import("../../lib/scale.js").Scale} scale
 */
export function eventAt({ events }, x, scale) {
  const there = events.filter(({ time_s: time }) => Math.abs(scale.x(time) - x) <= 2 * MARK_PX);
  return there.map(({ time_s: time, text }) => `${time.toFixed(3)} s: ${text}`).join("\n");
}
