/** What the timeline shows while a take is recorded. */

import assert from "node:assert/strict";
import { test } from "node:test";
import { curvesIn, takeWith } from "../../app/keyphase/web/page/js/model/recordings/take.js";

const told = (recorded_s, newest) => /** @type {any} */ ({ recorded_s, newest });

test("a take grows by what is told, from where it began, and ends with it", () => {
  const first = takeWith(null, told(0.1, [0.5, 0, 0.2, 0, 0, 1]));
  const second = takeWith(first, told(0.2, [0.51, 0, 0.2, 0, 0, 2]));
  assert.deepEqual(second.times, [0.1, 0.2]);
  assert.ok(Math.abs(second.position[1][0] - 10) < 1e-9);
  assert.deepEqual(
    second.force.map((row) => row[2]),
    [1, 2],
  );
  assert.deepEqual(takeWith(second, told(0.05, [0, 0, 0, 0, 0, 0])).times, [0.05]);
  assert.equal(takeWith(second, told(null, null)), null);
});

test("a long take keeps its ends and few samples", () => {
  let take = null;
  for (let k = 0; k < 5000; k++) take = takeWith(take, told(k, [0, 0, 0, 0, 0, 0]));
  assert.ok(take.times.length <= 2001);
  assert.equal(take.times[0], 0);
  assert.equal(take.times.at(-1), 4999);
});

test("curves fill the box from top to bottom", () => {
  const rows = [
    [0, 0, 40],
    [0, 0, 0],
  ];
  const [, , z] = curvesIn([0, 20], rows, { width: 100, height: 50, least: 10 });
  assert.equal(z, "0.0,0.0 100.0,50.0");
});
