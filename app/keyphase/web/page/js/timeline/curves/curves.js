/**
 * One uPlot chart of a track: curves and grid lines only. Axis labels, marks and gestures are our
 * overlay's, so that all rows share one time axis and one look.
 */

import { cssColor } from "../../lib/colors.js";
import { eachColumn, isDense } from "./columns.js";
import { eachSample } from "./series.js";

/** uPlot comes as a classic script, before the modules. */
const { uPlot } = /** @type {any} */ (window);

const PADDING_PX = { top: 7, bottom: 6 };
const FOLDED_PADDING_PX = { top: 3, bottom: 3 };

/**
 * @typedef {{color: string, width: number, dash?: number[]}} Pen  color: a CSS variable's name
 * @typedef {{low: number, high: number, ticks: number[], map: (value: number) => number}} Range
 *   `map` takes a value to where it is drawn (identity, or a logarithm); low and high are mapped.
 */

/**
 * @param {HTMLElement} parent
 * @param {Pen[]} pens one per series
 * @param {(chart: any, box: Box) => void} [drawBelow] paints under the curves
 * @typedef {{left: number, top: number, width: number, height: number, y: (value: number) => number}} Box
 */
export function createCurves(parent, pens, drawBelow) {
  /** @type {Range} */
  let range = { low: 0, high: 1, ticks: [], map: (value) => value };
  let view = { from: 0, to: 1 };
  let size = { width: 0, height: 0, folded: false };
  let chart = null;
  let data = [[], ...pens.map(() => [])];
  let shown = null;
  /** What uPlot was given; dense curves it is not. */
  let given = null;
  let dense = false;
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
    drawBelow?.(plot, { left: 0, top: 0, width: size.width, height: size.height, y });
    ctx.restore();
  }

  /** Dense curves, which uPlot was told to leave out. */
  function paintBars({ ctx, bbox }) {
    if (!dense) return;
    const ratio = devicePixelRatio;
    shown.forEach((series, k) => {
      ctx.fillStyle = penColors[k];
      eachColumn(
        series,
        view,
        bbox.width,
        (value) => ratio * y(value),
        (column, top, bottom) =>
          ctx.fillRect(column, Math.floor(top), 1, Math.max(1, Math.round(bottom - top))),
      );
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
            paths: (...asked) => (dense ? null : line(...asked)),
          })),
        ],
        hooks: { drawClear: [paintGround], draw: [paintBars] },
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
      dense = isDense(series, view, size.width);
      shown = series;
      if (!dense && (given !== series || !sameRange)) {
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
    /** Draws the same curves again: the threshold below them moved. */
    repaint() {
      chart?.redraw(false);
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

/** Fills what of the curve stands above the threshold. */
export function fillAbove({ ctx }, { width, y }, { threshold, series, view, color }) {
  if (threshold === null || !series) return;
  const level = y(threshold);
  const perSecond = width / (view.to - view.from);
  ctx.save();
  ctx.globalAlpha = 0.26;
  ctx.fillStyle = color;
  if (isDense([series], view, width)) {
    eachColumn(series, view, width, y, (column, top) => {
      if (top < level) ctx.fillRect(column, Math.floor(top), 1, level - Math.floor(top));
    });
    ctx.restore();
    return;
  }
  ctx.beginPath();
  ctx.rect(0, 0, width, Math.max(0, level));
  ctx.clip();
  ctx.beginPath();
  ctx.moveTo(0, level);
  eachSample(series, view.from, view.to, (time, value) =>
    ctx.lineTo((time - view.from) * perSecond, y(value)),
  );
  ctx.lineTo(width, level);
  ctx.fill();
  ctx.restore();
}
