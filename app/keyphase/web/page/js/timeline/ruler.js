/** The time axis: ticks at round times, and the playhead's flag on top of it. */

import { svg } from "../lib/dom.js";
import { time as timeText } from "../lib/format.js";
import { axisStep, multiples } from "../lib/scale.js";

const TICK_EVERY_PX = 110;
const FLAG_WIDTH = 50;

/**
 * @param {import("../lib/scale.js").Scale} scale
 * @param {import("../model/rows.js").Row} row
 */
export function drawRuler(scale, { y, height }) {
  const step = axisStep(scale.from, scale.to, scale.width / TICK_EVERY_PX);
  const digits = Math.max(1, Math.ceil(-Math.log10(step) - 1e-9));
  const bottom = y + height;
  const nodes = [];
  let minor = "";
  for (const at of multiples(scale.from, scale.to, step / 5)) {
    minor += `M${scale.x(at).toFixed(1)} ${bottom}v-3`;
  }
  let major = "";
  for (const at of multiples(scale.from, scale.to, step)) {
    const x = scale.x(at);
    major += `M${x.toFixed(1)} ${bottom}v-6`;
    const anchor = x < 14 ? "start" : x > scale.width - 14 ? "end" : "middle";
    nodes.push(
      svg("text", {
        x: anchor === "start" ? x + 2 : x,
        y: y + 10,
        class: "tick",
        "text-anchor": anchor,
        text: timeText(at, at >= 600 && step >= 1 ? 0 : digits),
      }),
    );
  }
  return [svg("path", { d: minor + major, class: "ticks" }), ...nodes];
}

/**
 * The playhead: a flag with the time, a line down over all tracks. Moved by transform only, so
 * that playing redraws nothing else.
 * @param {SVGElement} group
 */
export function createPlayhead(group) {
  const line = svg("path", { class: "playhead-line" });
  const flag = svg("path", { class: "playhead-flag" });
  const label = svg("text", { class: "playhead-time", "text-anchor": "middle" });
  group.append(line, flag, label);
  return {
    /** @param {import("../model/rows.js").Layout} layout @param {number} bottom */
    lay(layout, bottom) {
      const { y, height } = layout.rows.get("ruler");
      line.setAttribute("d", `M0 ${y + height - 2}V${bottom}`);
      const half = FLAG_WIDTH / 2;
      flag.setAttribute(
        "d",
        `M${3 - half} ${y + 1}h${FLAG_WIDTH - 6}a3 3 0 0 1 3 3v${height - 8}a3 3 0 0 1 -3 3h${5 - half + 3}l-5 5l-5 -5h${5 - half + 3}a3 3 0 0 1 -3 -3v${8 - height}a3 3 0 0 1 3 -3z`,
      );
      label.setAttribute("y", String(y + 12.5));
    },
    /**
     * @param {import("../lib/scale.js").Scale} scale
     * @param {number} seconds
     * @param {Iterable<Element>} ticks the ruler's texts; those under the flag give way
     */
    move(scale, seconds, ticks) {
      const x = scale.x(seconds);
      for (const tick of ticks) {
        tick.classList.toggle(
          "covered",
          Math.abs(Number(tick.getAttribute("x")) - x) < FLAG_WIDTH / 2 + 13,
        );
      }
      const seen = x >= -1 && x <= scale.width + 1;
      group.style.display = seen ? "" : "none";
      group.style.transform = `translateX(${x.toFixed(2)}px)`;
      label.textContent = timeText(seconds);
    },
  };
}
