/**
 * The normalized error: the curve, the line of ratio times running median, the threshold one can
 * drag, and what became of every peak above it.
 */

import { cssColor } from "../lib/colors.js";
import { el, svg } from "../lib/dom.js";
import { height as heightText } from "../lib/format.js";
import { valueInForce } from "../model/parameters.js";
import { curvesOf, valueAt } from "../model/signals.js";
import { createCurves } from "./curves/curves.js";
import { extent } from "./curves/series.js";
import { glyph } from "./glyphs.js";
import { textWidth } from "../lib/text_width.js";
import { tickLabels } from "./tracks.js";
import { multiples, tickStep } from "../lib/scale.js";

const FLOOR = 0.3;
/** Beyond so many peaks in view they lose their texts. */
const MOST_PEAKS = 150;
const REASONS = {
  "below ratio": "below the ratio",
  "does not stay": "the force does not stay",
  "too close": "too close to a higher one",
  "at an end": "at an end of the recording",
};
const identity = (value) => value;
const NOTHING = { key: "median", times: [], values: [] };
const logarithms = new Map();

/** log10 clipped at a floor; one function per floor, so that curves can tell ranges apart. */
function logarithm(floor) {
  if (!logarithms.has(floor)) logarithms.set(floor, (value) => Math.log10(Math.max(value, floor)));
  return logarithms.get(floor);
}

/**
 * @param {import("./gutter.js").TrackParts} parts
 * @param {import("../lib/store.js").Store} store
 */
export function createErrorTrack({ plot, marks, gutter, texts }, store) {
  const pens = [
    { color: "--origin-force", width: 1, dash: [1.5, 3] },
    { color: "--curve", width: 1.2 },
  ];
  let shades = [];
  let color = cssColor("--origin-force");
  const curves = createCurves(plot, pens, { shades: () => shades });
  const folded = createCurves(plot, [{ color: "--text-3", width: 1 }]);
  const legend = createLegend(gutter, store);
  let scaled = { source: null, ratio: 0, series: null };
  let range = null;

  return {
    /** Pixels from the track's top to an error, and back. */
    y: (value) => curves.y(value),
    errorAt: (y) => invert(range, curves.y, y),
    draw(state, scale, row) {
      const series = curvesOf(state, "error")?.series;
      plot.classList.toggle("folded", row.folded);
      (row.folded ? curves : folded).hide();
      legend.show(state, row);
      if (!series?.length) return marks.replaceChildren();
      const { document: doc, logarithmic } = state;
      const ratio = decides(doc) ? (doc.parameters.force_ratio ?? 1) : 0;
      if (scaled.source !== series || scaled.ratio !== ratio) {
        scaled = {
          source: series,
          ratio,
          series: [ratio ? timesRatio(series[1] ?? series[0], ratio) : NOTHING, series[0]],
        };
      }
      const whole = curvesOf({ ...state, fine: null }, "error")?.series ?? series;
      range = rangeOf(whole[0], thresholdOf(state), logarithmic, row.height, state.small);
      if (row.folded) {
        folded.resize(scale.width, row.height, true);
        folded.draw([series[0]], range, state.view);
        return marks.replaceChildren();
      }
      const above = thresholdOf(state);
      shades = above === null ? [] : [{ series: series[0], above, color }];
      curves.resize(scale.width, row.height, false);
      curves.draw(scaled.series, range, state.view);
      return marks.replaceChildren(
        ...tickLabels(range, curves.y, texts()),
        ...drawPeaks(state, scale, curves.y),
        ...drawThreshold(state, scale, curves.y, row.height),
      );
    },
    read(state, time) {
      const series = curvesOf(state, "error")?.series;
      legend.value(series ? valueAt(series[0], time) : NaN);
    },
    recolor() {
      color = cssColor("--origin-force");
      shades = shades.map((shade) => ({ ...shade, color }));
      curves.recolor();
      folded.recolor();
    },
  };
}

/** The threshold as the person sees it: under the finger while dragging, else what is set. */
export function thresholdOf({ document: doc, held }) {
  return decides(doc) ? valueInForce(doc, held, "force_threshold") : null;
}

/** Whether the error makes boundaries; beside the evidence it is only shown. */
function decides(doc) {
  return doc.parameters.variant === "paper";
}

function timesRatio({ times, values }, ratio) {
  return { key: "median", times, values: values.map((value) => value * ratio) };
}

function rangeOf(series, threshold, logarithmic, height, small) {
  const { high } = extent([series]);
  const top = Math.max(high, (threshold ?? 0) * 1.5, 1);
  if (!logarithmic) {
    const step = tickStep(1.08 * top, height / 26);
    return {
      low: -0.02 * top,
      high: 1.08 * top,
      ticks: multiples(0, 1.08 * top, step),
      map: identity,
    };
  }
  const floor = Math.min(FLOOR, (threshold ?? 3) / 10);
  const map = logarithm(floor);
  const low = Math.log10(floor);
  const most = Math.log10(2.2 * top);
  const step = Math.max(1, Math.ceil((most - low) / ((height - 13) / (small ? 15 : 18))));
  const decades = multiples(Math.ceil(low), most, step);
  return {
    low,
    high: most,
    ticks: decades.map((decade) => Number((10 ** decade).toPrecision(3))),
    map,
  };
}

/** The error at a height in the track. */
function invert(range, y, level) {
  if (!range) return NaN;
  const bottom = range.map === identity ? range.low : 10 ** range.low;
  const top = range.map === identity ? range.high : 10 ** range.high;
  const share = (level - y(bottom)) / (y(top) - y(bottom));
  const mapped = range.low + share * (range.high - range.low);
  return range.map === identity ? Math.max(mapped, 0) : 10 ** mapped;
}

/**
 * @param {import("../lib/store.js").State} state
 * @param {import("../lib/scale.js").Scale} scale
 */
function drawPeaks(state, scale, y) {
  const { document: doc } = state;
  const threshold = thresholdOf(state);
  const nodes = [];
  const peaks = doc.peaks.filter(
    (peak) => peak.height >= threshold && peak.rejection !== "below threshold",
  );
  const inView = peaks.filter(({ bin_time_s: time }) => time >= scale.from && time <= scale.to);
  // Used ones first, then by height: where texts would overlap, the lower peak goes without.
  inView.sort(
    (a, b) => Number(a.rejection !== "") - Number(b.rejection !== "") || b.height - a.height,
  );
  if (inView.length > MOST_PEAKS) return [manyPeaks(inView, scale, y)];
  const taken = inView.map((peak) => ({
    left: scale.x(peak.bin_time_s) - 6,
    right: scale.x(peak.bin_time_s) + 6,
    y: y(peak.height) + 3,
  }));
  for (const peak of inView) {
    const x = scale.x(peak.bin_time_s);
    const level = y(peak.height);
    nodes.push(
      peak.rejection ? hollow(x, level) : glyph("force", { x, y: level, r: 4.2, filled: true }),
    );
    const text = peakText(peak, x, level, scale.width, state.small, taken);
    if (text) nodes.push(text);
  }
  return nodes;
}

/**
 * Used peaks only, small and without their heights.
 * @param {import("../lib/scale.js").Scale} scale
 */
function manyPeaks(peaks, scale, y) {
  const used = peaks.filter(({ rejection }) => !rejection);
  const d = used
    .map(
      (peak) =>
        `M${scale.x(peak.bin_time_s).toFixed(1)} ${(y(peak.height) - 3).toFixed(1)}l3 3-3 3-3-3z`,
    )
    .join("");
  return svg("path", { d, class: "many-peaks" });
}

function hollow(x, y) {
  return svg("path", { d: `M${x} ${y - 4.8}l4.8 4.8-4.8 4.8-4.8-4.8z`, class: "peak-rejected" });
}

/** The height, and for a rejected peak why, wherever there is room for it. */
function peakText({ height, rejection }, x, level, width, small, taken) {
  const number = heightText(height);
  const reason = REASONS[rejection] ?? rejection;
  const forms = rejection && !small ? [`${number}, ${reason}`, number] : [number];
  const y = level + (rejection ? -1 : 3);
  for (const text of forms) {
    const wide = textWidth(text, rejection ? "11px" : "600 11px");
    const sides = rejection ? [x + 9, x - 9 - wide] : [x - 9 - wide, x + 9];
    for (const left of sides) {
      const box = { left: left - 3, right: left + wide + 3, y };
      const clear = taken.every(
        (other) => box.right <= other.left || box.left >= other.right || Math.abs(other.y - y) > 11,
      );
      if (left < 2 || left + wide > width - 2 || !clear) continue;
      taken.push(box);
      return svg("text", { x: left, y, class: rejection ? "peak-reason" : "peak-height", text });
    }
  }
  return null;
}

/**
 * The line over the curve and its tag in the margin; both can be dragged.
 * @param {import("../lib/store.js").State} state
 * @param {import("../lib/scale.js").Scale} scale
 */
function drawThreshold(state, scale, y, height) {
  const threshold = thresholdOf(state);
  if (threshold === null) return [];
  const level = Math.round(Math.min(Math.max(y(threshold), 2), height - 2)) + 0.5;
  const tagY = Math.min(Math.max(level, 9), height - 9);
  const wide = state.small ? 28 : 32;
  const left = scale.width + 2;
  return [
    svg("path", { d: `M0 ${level}H${scale.width}`, class: "threshold-line" }),
    svg(
      "g",
      { class: "threshold-tag", data: { threshold: heightText(threshold) } },
      svg("path", {
        d: `M${left} ${tagY}l6-8h${wide - 1}a2 2 0 0 1 2 2v12a2 2 0 0 1-2 2h${1 - wide}z`,
      }),
      svg("text", { x: left + 8, y: tagY + 3.6, text: heightText(threshold) }),
    ),
  ];
}

/**
 * What the gutter says of the error: channels, linear or logarithmic, the dotted line.
 * @param {import("../lib/store.js").Store} store
 */
function createLegend(gutter, store) {
  const channels = el("div", { class: "gutter-note" });
  const linear = el("button", {
    type: "button",
    text: "Linear",
    on: { click: () => store.set({ logarithmic: false }) },
  });
  const log = el("button", {
    type: "button",
    text: "Log",
    on: { click: () => store.set({ logarithmic: true }) },
  });
  const median = el("div", { class: "gutter-note dotted" });
  const now = el("span", { class: "error-now" });
  gutter.append(
    channels,
    el("div", { class: "switch", role: "group", "aria-label": "Scale of the error" }, linear, log),
    median,
  );
  return {
    /** @param {import("../lib/store.js").State} state @param {import("../model/rows.js").Row} row */
    show({ document: doc, logarithmic, small }, { height }) {
      linear.textContent = small ? "Lin" : "Linear";
      linear.classList.toggle("on", !logarithmic);
      log.classList.toggle("on", logarithmic);
      linear.setAttribute("aria-pressed", String(!logarithmic));
      log.setAttribute("aria-pressed", String(logarithmic));
      channels.textContent = `${doc.force_channels} ${doc.force_channels > 3 ? "wrench" : "force"} channels`;
      channels.hidden = small || height < 60;
      median.textContent = `${doc.parameters.force_ratio} × running median`;
      median.hidden = small || height < 90 || !decides(doc);
    },
    value(error) {
      now.textContent = Number.isNaN(error) ? "" : heightText(error);
    },
  };
}
