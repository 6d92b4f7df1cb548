/** Marks that have no room for their numbers say together which they are. */

import assert from "node:assert/strict";
import { test } from "node:test";

import { isCrowded } from "../../app/keyphase/web/page/js/timeline/dense.js";
import { runsOf, runText } from "../../app/keyphase/web/page/js/timeline/runs.js";

const marks = (widths) => {
  let left = 0;
  return widths.map((width, k) => {
    const mark = { number: k + 1, left, right: left + width, fits: width >= 20 };
    left += width;
    return mark;
  });
};
const runs = (widths) =>
  runsOf(marks(widths), () => 25).map(({ first, last }) => runText(first, last));

test("as many are told together as the words need room for", () => {
  assert.deepEqual(runs([10, 10, 10, 10, 10, 10]), ["1–3", "4–6"]);
  assert.deepEqual(runs([15, 15, 40, 15, 15]), ["1–2", "4–5"]);
});

test("what has its own number is in none, and what has no room is not told", () => {
  assert.deepEqual(runs([40, 30, 25]), []);
  assert.deepEqual(runs([40, 5, 40]), []);
});

test("where each would have no room, a narrow timeline shows colours only", () => {
  const crowded = (count, width) => isCrowded(count, { width });
  assert.deepEqual([crowded(74, 1100), crowded(74, 220)], [false, true]);
  assert.deepEqual([crowded(20, 50), crowded(301, 1700)], [false, true]);
});
