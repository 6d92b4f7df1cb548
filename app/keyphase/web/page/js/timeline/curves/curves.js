/**
 * One uPlot chart of a track: curves and grid lines only. Axis labels, marks and gestures are our
 * overlay's, so that all rows share one time axis and one look.
 */

import { cssColor } from "../../lib/colors.js";
import { columnsOf, samplesIn } from "./columns.js";
import { paintAbove, paintLine } from "./raster.js";

/** uPlot comes as a classic script, before the modules. */
const { uPlot } = /** @type {any} */ (window);

const PADDING_PX = { top: 7, bottom: 6 };
const FOLDED_PADDING_PX = { top: 3, bottom: 3 };
/** With more samples of a curve in view than so many, uPlot's lines cost more than pixels. */
const MOST_STROKED = 100;
const SHADE_OPACITY = 0.26;
const PALE_OPACITY = 0.28;

/**
 * @typedef {{color: string, width: number, dash?: number[]}} Pen  color: a CSS variable's name
 * @typedef {{low: number, high: number, ticks: number[], map: (value: number) => number}} Range
 *   `map` takes a value to where it is drawn (identity, or a logarithm); low and high are mapped.
 * @typedef {{series: import("../../model/types.js").Series, above: number, color: string}} Shade
 *   what of a curve stands above a value is filled; color: as CSS has it now
 * @typedef {{series: import("../../model/types.js").Series, color: string, width: number}} PaleLine
 */

/**
 * @param {HTMLElement} parent
 * @param {Pen[]} pens one per series
 * @param {{pale?: () => PaleLine[], shades?: () => Shade[]}} [under] what is painted under the curves
 */
export function createCurves(parent, pens, { pale = () => [], shades = () => [] } = {}) {
  /** @type {Range} */
  let range = { low: 0, high: 1, ticks: [], map: (value) => value };
  let view = { from: 0, to: 1 };
  let size = { width: 0, height: 0, folded: false };
  let chart = null;
  let data = [[], ...pens.map(() => [])];
  let shown = null;
  /** What uPlot was given to stroke. */
  let given = null;
  let stroked = true;
  const raster = createRaster();
  let penColors = pens.map((pen) => cssColor(pen.color));
  let gridColor = cssColor("--grid");

  const padding = () => (size.folded ? FOLDED_PADDING_PX : PADDING_PX);
  /** Pixels from the track's top to a value. */
  const y = (value) => {
    const { top, bottom } = padding();
    const share = (range.map(value) - range.low) / (range.high - range.low);
    return size.height - bottom - share * (size.height - top - bottom);
  };

  function paintGround(plot) {
    const ratio = devicePixelRatio;
    const { ctx, bbox } = plot;
    ctx.save();
    ctx.scale(ratio, ratio);
    ctx.strokeStyle = gridColor;
    ctx.lineWidth = 1;
    ctx.beginPath();
    for (const tick of size.folded ? [] : range.ticks) {
      const level = Math.round(y(tick)) + 0.5;
      ctx.moveTo(0, level);
      ctx.lineTo(bbox.width / ratio, level);
    }
    ctx.stroke();
    ctx.restore();
    paintPixels(plot);
  }

  /** What stands above a line, and the curves that uPlot was told to leave out. */
  function paintPixels({ ctx, bbox }) {
    const ratio = devicePixelRatio;
    const width = Math.round(bbox.width);
    const lines = stroked
      ? []
      : shown.map((series, k) => ({ series, pen: pens[k], color: penColors[k] }));
    const [filled, wide] = [shades(), pale()];
    if (!lines.length && !filled.length && !wide.length) return;
    const known = new Map();
    const columns = (series) => {
      if (!known.has(series))
        known.set(
          series,
          columnsOf(series, view, width, (value) => ratio * y(value)),
        );
      return known.get(series);
    };
    raster.paint(ctx, width, Math.round(ratio * size.height), (pixels, rgbOf) => {
      for (const { series, above, color } of filled)
        paintAbove(pixels, columns(series), ratio * y(above), rgbOf(color), SHADE_OPACITY);
      for (const { series, color, width: thick } of wide)
        paintLine(pixels, columns(series), {
          rgb: rgbOf(color),
          width: ratio * thick,
          opacity: PALE_OPACITY,
        });
      for (const { series, pen, color } of lines)
        paintLine(pixels, columns(series), {
          rgb: rgbOf(color),
          width: ratio * pen.width,
          dash: pen.dash?.map((one) => ratio * one),
        });
    });
  }

  function build() {
    const line = uPlot.paths.linear();
    const { top, bottom } = padding();
    chart = new uPlot(
      {
        width: size.width,
        height: size.height,
        padding: [top, 0, bottom, 0],
        pxAlign: 0,
        cursor: { show: false },
        legend: { show: false },
        select: { show: false },
        scales: {
          x: { time: false, auto: false, range: () => [view.from, view.to] },
          y: { auto: false, range: () => [range.low, range.high] },
        },
        axes: [{ show: false }, { show: false }],
        series: [
          {},
          ...pens.map((pen, k) => ({
            stroke: () => penColors[k],
            width: pen.width,
            dash: pen.dash,
            spanGaps: true,
            points: { show: false },
            paths: (...asked) => (stroked ? line(...asked) : null),
          })),
        ],
        hooks: { drawClear: [paintGround] },
      },
      data,
      parent,
    );
  }

  return {
    y,
    /** Where and how large; a change of padding needs a new chart. */
    resize(width, height, folded) {
      if (size.width === width && size.height === height && size.folded === folded) return;
      const rebuild = size.folded !== folded;
      size = { width, height, folded };
      if (chart && rebuild) {
        chart.destroy();
        chart = null;
      } else chart?.setSize({ width, height });
    },
    /**
     * @param {import("../../model/types.js").Series[]} series as many as pens
     * @param {Range} nextRange
     * @param {import("../../model/types.js").View} nextView
     */
    draw(series, nextRange, nextView) {
      if (size.width < 2 || size.height < 2) return;
      const sameRange =
        range.low === nextRange.low && range.high === nextRange.high && range.map === nextRange.map;
      range = nextRange;
      view = nextView;
      stroked = series.every((one) => samplesIn(one, view) <= MOST_STROKED);
      shown = series;
      if (stroked && (given !== series || !sameRange)) {
        data = alignedData(series, range.map);
        given = series;
        chart?.setData(data, false);
      }
      if (!chart) build();
      chart.batch(() => {
        chart.setScale("x", { min: view.from, max: view.to });
        chart.setScale("y", { min: range.low, max: range.high });
      });
    },
    /** Takes the chart away until it is drawn again: another one has its place. */
    hide() {
      chart?.destroy();
      chart = null;
    },
    recolor() {
      penColors = pens.map((pen) => cssColor(pen.color));
      gridColor = cssColor("--grid");
      chart?.redraw(false);
    },
  };
}

/**
 * uPlot wants all series on one set of times; ours are decimated one by one.
 * @param {import("../../model/types.js").Series[]} series
 * @param {(value: number) => number} map
 */
function alignedData(series, map) {
  const tables = series.map(({ times, values }) => [times, Array.from(values, map)]);
  if (tables.length === 1) return tables[0];
  const [{ times: first }] = series;
  const alike = series.every(
    ({ times }) => times.length === first.length && times.every((t, k) => t === first[k]),
  );
  return alike ? [first, ...tables.map(([, values]) => values)] : uPlot.join(tables);
}

/** @param {string|undefined} digits of a colour that has opacity, too, nothing */
const hex = (digits) => parseInt(digits ?? "80", 16);

/** Pixels that are painted, and laid on a canvas. */
function createRaster() {
  const canvas = document.createElement("canvas");
  const ground = canvas.getContext("2d");
  let pixels = null;
  /** @param {string} color any of CSS @returns {import("./raster.js").Rgb} */
  const rgbOf = (color) => {
    ground.fillStyle = color;
    const [, red, green, blue] = /^#(..)(..)(..)$/.exec(String(ground.fillStyle)) ?? [];
    return [hex(red), hex(green), hex(blue)];
  };
  return {
    /**
     * @param {CanvasRenderingContext2D} ctx
     * @param {(pixels: import("./raster.js").Pixels, rgbOf: (color: string) => import("./raster.js").Rgb) => void} draw
     */
    paint(ctx, width, height, draw) {
      if (width < 1 || height < 1) return;
      if (pixels?.width !== width || pixels.height !== height) {
        [canvas.width, canvas.height] = [width, height];
        pixels = ground.createImageData(width, height);
      }
      pixels.data.fill(0);
      draw(pixels, rgbOf);
      ground.putImageData(pixels, 0, 0);
      ctx.drawImage(canvas, 0, 0);
    },
  };
}
