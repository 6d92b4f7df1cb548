import assert from "node:assert/strict";
import { test } from "node:test";

import { fitted } from "../../app/keyphase/web/page/js/panels/describing/fitted.js";

test("a path keeps its proportions and lies in the middle of its box", () => {
  const points = fitted(
    [
      [0, 0],
      [2, 1],
    ],
    110,
    110,
    true,
  );
  assert.deepEqual(points, [
    [5, 80],
    [105, 30],
  ]);
});

test("a curve fills its box", () => {
  assert.deepEqual(
    fitted(
      [
        [0, 0],
        [10, 4],
      ],
      110,
      60,
      false,
    ),
    [
      [5, 55],
      [105, 5],
    ],
  );
});

test("a point that never moves is drawn all the same", () => {
  for (const value of fitted(
    [
      [1, 1],
      [1, 1],
    ],
    100,
    50,
    true,
  ).flat())
    assert.ok(Number.isFinite(value));
});
