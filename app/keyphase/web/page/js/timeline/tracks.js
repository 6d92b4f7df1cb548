/** The plain tracks: position, speed, gripper, force, torque, orientation. The error has its own file. */

import { svg } from "../lib/dom.js";
import { plain, signed } from "../lib/format.js";
import { curvesOf, valueAt } from "../model/signals.js";
import { createCurves } from "./curves/curves.js";
import { extent, normOf } from "./curves/series.js";
import { createReadout } from "./gutter.js";
import { textWidth } from "../lib/text_width.js";
import { axisStep, multiples } from "../lib/scale.js";

const AXES = [
  { key: "x", color: "--axis-x" },
  { key: "y", color: "--axis-y" },
  { key: "z", color: "--axis-z" },
];
const PENS = {
  position: { curves: AXES, width: 1.6, digits: 1 },
  speed: { curves: [{ key: "speed", color: "--curve" }], width: 1.2, digits: 1 },
  gripper: { curves: [{ key: "gripper", color: "--origin-gripper" }], width: 1.4, digits: 3 },
  force: { curves: AXES, width: 1.1, digits: 2 },
  torque: { curves: AXES, width: 1.1, digits: 3 },
  orientation: { curves: AXES, width: 1.4, digits: 1 },
};
const TICK_EVERY_PX = 21;
const TICK_PX = 7;
/** Between a tick and what is written beside it. */
const CLEAR_PX = 4;
const identity = (value) => value;

/** What a further channel is drawn with. */
const NAMED = { curves: [{ key: "value", color: "--curve" }], width: 1.1, digits: 3 };
/** @param {string} key */
const pensOf = (key) => PENS[key] ?? NAMED;

/** Decimals a track's values are written with. @param {string} key */
export const digitsOf = (key) => PENS[key]?.digits ?? 1;

/**
 * @param {string} key
 * @param {import("./gutter.js").TrackParts} parts
 */
export function createTrack(key, { plot, marks, gutter, texts }) {
  const { curves, width, digits } = pensOf(key);
  const open = createCurves(
    plot,
    curves.map(({ color }) => ({ color, width })),
  );
  const folded = createCurves(plot, [{ color: "--text-3", width: 1 }]);
  const readout = createReadout(gutter, curves);
  const cache = createCache();

  return {
    /** @param {import("../lib/store.js").State} state @param {import("../model/rows.js").Row} row */
    draw(state, scale, row) {
      const series = curvesOf(state, key)?.series;
      plot.classList.toggle("folded", row.folded);
      if (!series?.length) return marks.replaceChildren();
      const whole = curvesOf({ ...state, fine: null }, key)?.series ?? series;
      const active = row.folded ? folded : open;
      (row.folded ? open : folded).hide();
      const shown = row.folded ? cache("norm", series, () => [normOf(series)]) : series;
      const wholeShown = row.folded ? cache("wholeNorm", whole, () => [normOf(whole)]) : whole;
      const range = cache(`range ${row.height} ${row.folded}`, wholeShown, () =>
        rangeOf(wholeShown, row.height),
      );
      active.resize(scale.width, row.height, row.folded);
      active.draw(shown, range, state.view);
      marks.replaceChildren(
        ...(row.folded
          ? []
          : [
              ...tickLabels(range, active.y, texts()),
              ...endLetters(series, curves, scale, active.y, row.height),
            ]),
      );
    },
    /** @param {import("../lib/store.js").State} state @param {number} time */
    read(state, time) {
      const series = curvesOf(state, key)?.series ?? [];
      readout.show(curves.map((_, k) => valueText(series[k], time, digits)));
    },
    recolor() {
      open.recolor();
      folded.recolor();
    },
  };
}

/** A value with its sign, or a dash where nothing was recorded. */
export function valueText(series, time, digits) {
  const value = series ? valueAt(series, time) : NaN;
  return Number.isNaN(value) ? "–" : signed(value, digits);
}

/** Keeps what was computed from an object until another object comes. */
function createCache() {
  const kept = new Map();
  return (name, source, compute) => {
    const known = kept.get(name);
    if (known && known.source === source) return known.value;
    const value = compute();
    kept.set(name, { source, value });
    return value;
  };
}

/** Above and below a curve that stays where it is, as a share of its value; of one at zero, one. */
const LEVEL_AIR = 0.2;
/** Whether a curve stays where it is: ticks as near as its rounding would all read the same. */
const isLevel = (low, high) => high - low <= 1e-5 * Math.max(Math.abs(low), Math.abs(high));

/** A range with air above and below and ticks at round values. */
function rangeOf(series, height) {
  const { low, high } = extent(series);
  const air = isLevel(low, high) ? LEVEL_AIR * Math.abs(high) || 1 : 0.06 * (high - low);
  const bottom = low - air;
  const top = high + air;
  const ticks = multiples(bottom, top, axisStep(bottom, top, height / TICK_EVERY_PX));
  return { low: bottom, high: top, ticks, map: identity };
}

/**
 * Tick labels stand in the gutter, at the right, where nothing else is written.
 * @param {{ticks: number[]}} range
 * @param {(value: number) => number} y px from the track's top
 * @param {import("./gutter.js").TextBox[]} texts
 */
export function tickLabels({ ticks }, y, texts) {
  return ticks
    .map((tick) => ({ text: plain(tick), level: y(tick) }))
    .filter(({ text, level }) => {
      const left = -TICK_PX - textWidth(text, "11px") - CLEAR_PX;
      return texts.every(
        ({ top, bottom, right }) => right < left || level + 4 < top || level - 4 > bottom,
      );
    })
    .map(({ text, level }) =>
      svg("text", { x: -TICK_PX, y: level + 3.5, class: "tick", "text-anchor": "end", text }),
    );
}

const LETTER_PX = 12;

/**
 * Every curve ends in its letter, so that colour never stands alone.
 * @param {import("../lib/scale.js").Scale} scale
 */
function endLetters(series, curves, scale, y, height) {
  if (curves.length < 2) return [];
  const letters = curves
    .map(({ key, color }, k) => {
      const last = series[k]?.times.at(-1);
      const value = series[k] ? valueAt(series[k], Math.min(scale.to, last)) : NaN;
      return { key, color, level: y(value) + 3.5 };
    })
    .filter(({ level }) => Number.isFinite(level))
    .sort((a, b) => a.level - b.level);
  spread(letters, 9, height - 2);
  return letters.map(({ key, color, level }) =>
    svg("text", {
      x: scale.width + 6,
      y: level,
      class: "end-letter",
      style: { fill: `var(${color})` },
      text: key,
    }),
  );
}

/** Moves letters that would overlap apart, within the track. */
function spread(letters, top, bottom) {
  letters.forEach((letter, k) => {
    const least = k ? letters[k - 1].level + LETTER_PX : top;
    letter.level = Math.max(letter.level, least);
  });
  for (let k = letters.length - 1; k >= 0; k--) {
    const most = k === letters.length - 1 ? bottom : letters[k + 1].level - LETTER_PX;
    letters[k].level = Math.min(letters[k].level, most);
  }
}
