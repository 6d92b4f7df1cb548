/** From seconds to pixels, and how the view is moved, zoomed and ticked. */

import assert from "node:assert/strict";
import { test } from "node:test";
import {
  clampView,
  createScale,
  axisStep,
  multiples,
  tickStep,
  zoomView,
} from "../../app/keyphase/web/page/js/lib/scale.js";
import { documentOf } from "./documents.js";

const TEN_SECONDS = documentOf(10, []);
const near = (a, b) => assert.ok(Math.abs(a - b) < 1e-9, `${a} is not ${b}`);

test("a time comes back from its pixel", () => {
  const scale = createScale({ from: 2, to: 7 }, 1000);
  assert.equal(scale.x(2), 0);
  assert.equal(scale.x(7), 1000);
  for (const time of [2, 3.25, 6.999]) near(scale.time(scale.x(time)), time);
});

test("a view keeps its length at the recording's ends", () => {
  assert.deepEqual(clampView(-3, 1, TEN_SECONDS), { from: 0, to: 4 });
  assert.deepEqual(clampView(8, 13, TEN_SECONDS), { from: 5, to: 10 });
});

test("a view is never longer than the recording nor shorter than four samples", () => {
  assert.deepEqual(clampView(-50, 50, TEN_SECONDS), { from: 0, to: 10 });
  const { from, to } = clampView(5, 5, TEN_SECONDS);
  near(to - from, 0.04);
});

test("zooming keeps the time under the pointer where it is", () => {
  const view = { from: 2, to: 6 };
  const zoomed = zoomView(view, 2, 3, TEN_SECONDS);
  near((3 - zoomed.from) / (zoomed.to - zoomed.from), (3 - view.from) / (view.to - view.from));
  near(zoomed.to - zoomed.from, 2);
});

test("ticks are 1, 2 or 5 times a power of ten and not too many", () => {
  for (const span of [0.013, 0.8, 7.6, 90, 3999]) {
    const step = tickStep(span, 8);
    const mantissa = step / 10 ** Math.floor(Math.log10(step) + 1e-9);
    assert.ok(
      [1, 2, 5].some((one) => Math.abs(one - mantissa) < 1e-6),
      `${step} for ${span}`,
    );
    assert.ok(span / step <= 8 + 1e-9);
  }
});

test("multiples of a step have no rounding tails", () => {
  assert.deepEqual(multiples(-0.1, 0.3, 0.1), [-0.1, 0, 0.1, 0.2, 0.3]);
});

test("an axis has two ticks at least, however low it is", () => {
  for (const [low, high] of [
    [-470, 380],
    [0, 12.3],
    [0.95, 1.04],
    [-0.4, 0.9],
  ]) {
    const step = axisStep(low, high, 1.5);
    assert.ok(multiples(low, high, step).length > 1);
  }
});
