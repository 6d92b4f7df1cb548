/** What a document looks like while a boundary is being dragged. */

import assert from "node:assert/strict";
import { test } from "node:test";
import { reachOf, withDrag } from "../../app/keyphase/web/page/js/model/drag.js";
import { boundary, documentOf } from "./documents.js";

const doc = documentOf(10, [boundary(3), boundary(6)]);

test("a dragged boundary takes the ends of its two segments with it", () => {
  const shown = withDrag(doc, { boundary: 0, time: 4, snapped: "" });
  assert.equal(shown.boundaries[0].time_s, 4);
  assert.equal(shown.boundaries[0].was_s, 3);
  assert.deepEqual(
    shown.segments.map(({ start_s, end_s }) => [start_s, end_s]),
    [
      [0, 4],
      [4, 6],
      [6, 10],
    ],
  );
});

test("dragging changes nothing of the document itself", () => {
  const before = structuredClone(doc);
  withDrag(doc, { boundary: 1, time: 7, snapped: "" });
  assert.deepEqual(doc, before);
});

test("of an hour only what is beside the hand is copied at each move", () => {
  const shown = withDrag(doc, { boundary: 0, time: 4, snapped: "" });
  assert.equal(shown.segments[2], doc.segments[2]);
  assert.equal(shown.boundaries[1], doc.boundaries[1]);
});

test("with all later boundaries the last segment begins later and ends where it did", () => {
  const shown = withDrag(doc, { boundary: 0, time: 4, snapped: "", ripples: true });
  assert.deepEqual(
    shown.segments.map(({ start_s, end_s }) => [start_s, end_s]),
    [
      [0, 4],
      [4, 7],
      [7, 10],
    ],
  );
});

test("without a drag, or of a boundary that has gone, the document is as it was", () => {
  assert.equal(withDrag(doc, null), doc);
  assert.equal(withDrag(doc, { boundary: 5, time: 7, snapped: "" }), doc);
});

test("a boundary stays two samples away from its neighbours and the ends", () => {
  assert.deepEqual(reachOf(doc, 0), [0.02, 6 - 0.02]);
  assert.deepEqual(reachOf(doc, 1), [3.02, 10 - 0.02]);
});
