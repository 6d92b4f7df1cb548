/** Curves as columns of pixels, and the pixels. */

import assert from "node:assert/strict";
import { test } from "node:test";
import { columnsOf } from "../../app/keyphase/web/page/js/timeline/curves/columns.js";
import { paintAbove, paintLine } from "../../app/keyphase/web/page/js/timeline/curves/raster.js";
import { seriesOf } from "./documents.js";

const RED = /** @type {import("../../app/keyphase/web/page/js/timeline/curves/raster.js").Rgb} */ ([
  255, 0, 0,
]);
const seen = (series, view, width) => columnsOf(series, view, width, (value) => value);

function blank(width, height) {
  return { data: new Uint8ClampedArray(4 * width * height), width, height };
}

/** The opacities of a column, from the top. */
const opacities = ({ data, width, height }, column) =>
  Array.from({ length: height }, (_, row) => data[4 * (row * width + column) + 3] / 255);

test("the least and the greatest value of a column are seen", () => {
  const values = Array.from({ length: 1000 }, () => 0);
  values[523] = 50;
  values[527] = -20;
  const { top, bottom } = seen(seriesOf(values, 0.01), { from: 0, to: 10 }, 10);
  assert.deepEqual([top[5], bottom[5]], [-20, 50]);
  assert.deepEqual([top[4], bottom[4]], [0, 0]);
});

test("a jump between columns leaves no gap", () => {
  const { top, bottom } = seen(seriesOf([0, 0, 100, 100], 1), { from: 0, to: 4 }, 4);
  assert.deepEqual([top[1], bottom[1]], [0, 100]);
});

test("between two samples every column has its part of the straight line", () => {
  const { top, bottom } = seen(seriesOf([0, 100], 1), { from: 0, to: 1 }, 10);
  assert.deepEqual([...top].map(Math.round), [0, 10, 20, 30, 40, 50, 60, 70, 80, 90]);
  assert.deepEqual([...bottom].map(Math.round)[9], 100);
});

test("where nothing was recorded nothing is drawn", () => {
  const { top } = seen(seriesOf([1, 1, NaN, 1, 1], 1), { from: 0, to: 5 }, 5);
  assert.deepEqual([...top], [1, 1, Infinity, 1, 1]);
});

test("a level line is as thick as its pen, wherever it lies between pixels", () => {
  for (const level of [5, 5.25, 5.5, 5.9]) {
    const pixels = blank(3, 12);
    paintLine(pixels, seen(seriesOf([level, level], 3), { from: 0, to: 3 }, 3), {
      rgb: RED,
      width: 1.5,
    });
    const drawn = opacities(pixels, 1).reduce((sum, one) => sum + one, 0);
    assert.ok(Math.abs(drawn - 1.5) < 0.02, `${drawn} at ${level}`);
  }
});

test("a dash leaves out columns", () => {
  const pixels = blank(9, 4);
  const columns = seen(seriesOf([2, 2], 9), { from: 0, to: 9 }, 9);
  paintLine(pixels, columns, { rgb: RED, width: 1, dash: [1, 2] });
  const drawn = Array.from({ length: 9 }, (_, column) => opacities(pixels, column).some(Boolean));
  assert.deepEqual(drawn, [true, false, false, true, false, false, true, false, false]);
});

test("what stands above a line is filled down to it, and nothing else", () => {
  const pixels = blank(2, 10);
  paintAbove(pixels, { top: Float64Array.of(3, 8), bottom: Float64Array.of(9, 9) }, 6, RED, 0.5);
  const half = opacities(pixels, 0).map((one) => Math.round(2 * one));
  assert.deepEqual(half, [0, 0, 0, 1, 1, 1, 0, 0, 0, 0]);
  assert.ok(opacities(pixels, 1).every((one) => one === 0));
});

test("nothing is painted outside", () => {
  const pixels = blank(2, 4);
  const columns = { top: Float64Array.of(-50, 90), bottom: Float64Array.of(50, 99) };
  paintLine(pixels, columns, { rgb: RED, width: 2 });
  assert.ok(opacities(pixels, 0).every((one) => one === 1));
  assert.ok(opacities(pixels, 1).every((one) => one === 0));
});
