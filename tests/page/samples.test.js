/** What was measured in a replay, as it arrives in pieces. */

import assert from "node:assert/strict";
import { test } from "node:test";
import { indexAt, liveSeries, withRows } from "../../app/keyphase/web/page/js/replay/samples.js";

const row = (time) => [time, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10];
const piece = (first, times, given = {}) => ({
  run: 1,
  first,
  factor: 1,
  rows: times.map(row),
  demonstrated: null,
  ...given,
});

test("pieces join in order", () => {
  const samples = withRows(withRows(null, piece(0, [0, 1])), piece(2, [2]));
  assert.equal(samples.count, 3);
  assert.deepEqual([...liveSeries(samples, "force")[1].times], [0, 1, 2]);
  assert.deepEqual([...liveSeries(samples, "force")[1].values], [5, 5, 5]);
});

test("a piece that leaves a gap is not taken", () => {
  const before = withRows(null, piece(0, [0, 1]));
  assert.equal(withRows(before, piece(5, [5])), before);
});

test("another run begins anew and keeps nothing of the one before", () => {
  const before = withRows(null, piece(0, [0, 1, 2], { demonstrated: [{ z: [1] }] }));
  const after = withRows(before, piece(0, [0], { run: 2 }));
  assert.equal(after.count, 1);
  assert.deepEqual(after.demonstrated, []);
});

test("more samples than there was room for lose none", () => {
  let samples = null;
  for (let k = 0; k < 10; k++)
    samples = withRows(
      samples,
      piece(
        1000 * k,
        Array.from({ length: 1000 }, (_, i) => 1000 * k + i),
      ),
    );
  assert.equal(samples.count, 10000);
  assert.ok([0, 4095, 4096, 9999].every((k) => samples.time[k] === k));
});

test("a sample is found by its time", () => {
  const samples = withRows(null, piece(0, [0, 1, 2, 3]));
  assert.equal(indexAt(samples, 1.5), 2);
  assert.equal(indexAt(samples, 2), 2);
  assert.equal(indexAt(samples, 9), 4);
});
