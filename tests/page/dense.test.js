/** Many samples, drawn as one stroke per column of pixels. */

import assert from "node:assert/strict";
import { test } from "node:test";
import { eachColumn } from "../../app/keyphase/web/page/js/timeline/curves/columns.js";
import { seriesOf } from "./documents.js";

const columnsOf = (series, view, width) => {
  const seen = [];
  eachColumn(
    series,
    view,
    width,
    (value) => value,
    (column, top, bottom) => seen.push({ column, top, bottom }),
  );
  return seen;
};

test("the least and the greatest value of a column are seen", () => {
  const values = Array.from({ length: 1000 }, () => 0);
  values[523] = 50;
  values[527] = -20;
  const seen = columnsOf(seriesOf(values, 0.01), { from: 0, to: 10 }, 10);
  const { top, bottom } = seen.find(({ column }) => column === 5);
  assert.deepEqual([top, bottom], [-20, 50]);
});

test("columns come once each, from left to right, none outside", () => {
  const values = Array.from({ length: 5000 }, (_, k) => Math.sin(k));
  const columns = columnsOf(seriesOf(values, 0.01), { from: 10, to: 20 }, 100).map(
    ({ column }) => column,
  );
  assert.deepEqual(
    columns,
    [...new Set(columns)].sort((a, b) => a - b),
  );
  assert.ok(columns[0] >= -1 && columns.at(-1) < 100);
});

test("a jump between columns leaves no gap", () => {
  const seen = columnsOf(seriesOf([0, 0, 100, 100], 1), { from: 0, to: 4 }, 4);
  assert.equal(seen[2].top, 0);
  assert.equal(seen[2].bottom, 100);
});
