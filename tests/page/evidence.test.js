/** The lines over the evidence: where a probability is drawn, what a line let go there becomes. */

import assert from "node:assert/strict";
import { test } from "node:test";
import {
  apart,
  foundText,
  heightOf,
  linesOf,
  lineValue,
  probabilityAt,
} from "../../app/keyphase/web/page/js/model/evidence.js";
import { documentOf } from "./documents.js";

const doc = (variant, given = {}) =>
  documentOf(10, [], {
    parameters: { variant, force_threshold: null, motion_threshold: null },
    threshold: 0.2,
    automatic_threshold: 0.2,
    motion_threshold: 0.35,
    automatic_motion_threshold: 0.35,
    ...given,
  });

test("an even chance is drawn in the middle, and near certainty has as much room as near doubt", () => {
  assert.ok(Math.abs(heightOf(0.5) - 0.5) < 1e-9);
  assert.ok(Math.abs(heightOf(0.9) - heightOf(0.5) - (heightOf(0.5) - heightOf(0.1))) < 1e-9);
  assert.equal(heightOf(0), 0);
  assert.equal(heightOf(1), 1);
});

test("a probability comes back from its height", () => {
  for (const probability of [0.00015, 0.2, 0.35, 0.5, 0.97, 0.99985])
    assert.ok(Math.abs(probabilityAt(heightOf(probability)) - probability) < 1e-3);
});

test("a line dragged out of the track stays a probability that the server takes", () => {
  assert.equal(probabilityAt(-3), 0.00015);
  assert.equal(probabilityAt(4), 0.99985);
});

test("a line let go within a few pixels of its automatic value becomes automatic", () => {
  const automatic = heightOf(0.2);
  assert.equal(lineValue(automatic + 4 / 100, 0.2, 100), null);
  assert.equal(lineValue(automatic - 4 / 100, 0.2, 100), null);
  const away = lineValue(automatic + 7 / 100, 0.2, 100);
  assert.ok(away > 0.2 && away < 0.5, String(away));
});

test("a line without an automatic value never becomes automatic", () => {
  assert.equal(lineValue(heightOf(0.5), null, 100), 0.5);
});

test("there are two lines, one without force, none in the published way", () => {
  const names = (document) => linesOf({ document, held: {} }).map(({ parameter }) => parameter);
  assert.deepEqual(names(doc("evidence")), ["force_threshold", "motion_threshold"]);
  assert.deepEqual(names(doc("evidence", { threshold: null })), ["motion_threshold"]);
  assert.deepEqual(names(doc("paper")), []);
});

test("a line lies where it is held, and at its automatic value when held there", () => {
  const valueOf = (held) => linesOf({ document: doc("evidence"), held })[0].value;
  assert.equal(valueOf({}), 0.2);
  assert.equal(valueOf({ force_threshold: 0.7 }), 0.7);
  assert.equal(valueOf({ force_threshold: null }), 0.2);
});

test("tags never lie over each other nor outside the track", () => {
  assert.deepEqual(apart([30, 60], 17, [9, 91]), [30, 60]);
  assert.deepEqual(apart([40, 40], 17, [9, 91]), [40, 57]);
  assert.deepEqual(apart([90, 88], 17, [9, 91]), [91, 74]);
  assert.deepEqual(apart([0], 17, [9, 91]), [9]);
});

test("a line tells how far it can go, and where nothing more comes of lowering it", () => {
  const counts = /** @type {any} */ ({ steps: [0.0008, 0.6], counts: [5, 4, 2] });
  assert.equal(foundText(counts, 0.3), "4 found, the same from .0008 to 0.60");
  assert.equal(foundText(counts, 0.0004), "5 found, no more below; the same up to .0008");
  const never = /** @type {any} */ ({ steps: [], counts: [4] });
  assert.equal(foundText(never, 0.3), "4 found wherever the line lies");
});
