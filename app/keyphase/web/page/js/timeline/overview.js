/** The whole recording in one line: error curve, segments, the part in view, the playhead. */

import { segmentFill } from "../lib/colors.js";
import { svg } from "../lib/dom.js";
import { curvesOf } from "../model/signals.js";
import { denseSegments, MOST_IN_DETAIL } from "./dense.js";
import { createScale } from "../lib/scale.js";

const LOWEST = 0.3;

const wholeScale = ({ document: doc }, width) =>
  createScale({ from: doc.start_s, to: doc.end_s }, width);

/**
 * The segments in small.
 * @param {import("../lib/store.js").State} state
 */
export function drawOverviewStrip(state, { y, height }, width) {
  const scale = wholeScale(state, width);
  const { segments } = state.document;
  if (segments.length > MOST_IN_DETAIL) return denseSegments(segments, scale, y + height - 7, 4);
  return segments.map((segment) => {
    const x = scale.x(segment.start_s);
    const wide = Math.max(1, scale.x(segment.end_s) - x - 1);
    return svg("rect", {
      x: x + 0.5,
      y: y + height - 7,
      width: wide,
      height: 4,
      rx: 1,
      style: { fill: segment.kept ? segmentFill(segment) : "var(--hatch-line)" },
    });
  });
}

/**
 * The part in view, with a handle at either end.
 * @param {import("../lib/store.js").State} state
 */
export function drawWindow(state, { y, height }, width) {
  const scale = wholeScale(state, width);
  const from = scale.x(state.view.from);
  const to = scale.x(state.view.to);
  return [
    svg("rect", { y, width: Math.max(0, from), height, class: "overview-outside" }),
    svg("rect", { x: to, y, width: Math.max(0, width - to), height, class: "overview-outside" }),
    svg("rect", {
      x: from,
      y: y + 1.5,
      width: Math.max(2, to - from),
      height: height - 3,
      rx: 3,
      class: "overview-window",
    }),
    ...[from, to].map((x) =>
      svg("rect", {
        x: x - 3,
        y: y + height / 2 - 6,
        width: 6,
        height: 12,
        rx: 2,
        class: "overview-handle",
      }),
    ),
  ];
}

/**
 * The ground of the row, and the curve of the whole recording on it.
 * @param {import("../lib/store.js").State} state
 */
export function drawOverviewCurve(state, { y, height }, width) {
  const ground = svg("rect", { y, width, height, class: "overview-ground" });
  const curve = drawCurve(state, wholeScale(state, width), y, height);
  return curve ? [ground, curve] : [ground];
}

/**
 * The error over the whole recording, or the speed where no force was recorded.
 * @param {import("../lib/store.js").State} state
 * @param {import("../lib/scale.js").Scale} scale
 */
function drawCurve(state, scale, y, height) {
  const whole = { ...state, fine: null };
  const error = curvesOf(whole, "error")?.series[0];
  const series = error ?? curvesOf(whole, "speed")?.series[0];
  if (!series) return null;
  const { times, values } = series;
  const top = values.reduce((most, value) => Math.max(most, value), 1e-9);
  const share = error
    ? (value) =>
        Math.log10(Math.max(value, LOWEST) / LOWEST) / Math.log10(Math.max(top, 3) / LOWEST)
    : (value) => value / top;
  let d = "";
  for (let k = 0; k < times.length; k++) {
    const level = y + height - 9 - share(values[k]) * (height - 13);
    d += `${k ? "L" : "M"}${scale.x(times[k]).toFixed(1)} ${level.toFixed(1)}`;
  }
  return svg("path", { d, class: "overview-curve" });
}
