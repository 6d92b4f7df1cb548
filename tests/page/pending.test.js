/** What a person did is drawn before the server has told it back. */

import assert from "node:assert/strict";
import { test } from "node:test";
import { stillPending, withPending } from "../../app/keyphase/web/page/js/model/pending.js";
import { boundary, documentOf } from "./documents.js";

const doc = documentOf(10, [boundary(3), boundary(6)], {
  plan: [
    { time_s: 1, segment: 0, repeat: 0, connect_mm: null },
    { time_s: 8, segment: 2, repeat: 0, connect_mm: 12 },
  ],
});
const shown = (...edits) =>
  withPending(
    doc,
    edits.map((edit, k) => ({ event: k, edit })),
  );
const times = ({ boundaries }) => boundaries.map(({ time_s: time }) => time);
const spans = ({ segments }) => segments.map(({ start_s, end_s }) => [start_s, end_s]);

test("a moved boundary is where it was left, and its segments with it", () => {
  const after = shown({ kind: "move", from_s: 3, to_s: 4 });
  assert.deepEqual(times(after), [4, 6]);
  assert.equal(after.boundaries[0].was_s, 3);
  assert.deepEqual(spans(after), [
    [0, 4],
    [4, 6],
    [6, 10],
  ]);
});

test("edits follow each other: a boundary moved twice is where it was left last", () => {
  const after = shown({ kind: "move", from_s: 3, to_s: 4 }, { kind: "move", from_s: 4, to_s: 5 });
  assert.deepEqual(times(after), [5, 6]);
  assert.equal(after.boundaries[0].was_s, 3);
});

test("a split segment is two of the same name", () => {
  const after = shown({ kind: "add", time_s: 4.5 });
  assert.deepEqual(times(after), [3, 4.5, 6]);
  assert.equal(after.segments[2].label, after.segments[1].label);
});

test("a removed boundary joins its segments under the first one's name", () => {
  const after = shown({ kind: "remove", time_s: 3 });
  assert.deepEqual(spans(after), [
    [0, 6],
    [6, 10],
  ]);
  assert.equal(after.segments[0].label, "Segment 1");
});

test("the plan goes with its segments when their numbers change", () => {
  const dropping = { ...doc, proposed_drops: [2] };
  const after = withPending(dropping, [{ event: 1, edit: { kind: "remove", time_s: 3 } }]);
  assert.deepEqual(
    after.plan.map(({ segment }) => segment),
    [0, 1],
  );
  assert.deepEqual(after.proposed_drops, [1]);
});

test("merging takes all boundaries strictly between", () => {
  const after = shown({ kind: "merge", from_s: 1.5, to_s: 8 });
  assert.deepEqual(spans(after), [[0, 10]]);
});

test("names, dropping, accepting and contact are seen at once", () => {
  const after = shown(
    { kind: "label", time_s: 1, label: "reach" },
    { kind: "keep", time_s: 4, kept: false },
    { kind: "accept", time_s: 3 },
    { kind: "contact", time_s: 6, contact_change: false },
  );
  assert.equal(after.segments[0].label, "reach");
  assert.equal(after.segments[1].kept, false);
  assert.equal(after.boundaries[0].accepted, true);
  assert.equal(after.boundaries[1].contact_change, false);
});

test("a new order of the plan counts repetitions and keeps what is known of each entry", () => {
  const { plan } = shown({ kind: "plan", order: [8, 1, 8] });
  assert.deepEqual(
    plan.map(({ segment, repeat }) => [segment, repeat]),
    [
      [2, 0],
      [0, 0],
      [2, 1],
    ],
  );
  assert.equal(plan[2].connect_mm, 12);
});

test("an edit that finds nothing, or of a kind unknown here, leaves the document as it is", () => {
  for (const edit of [
    { kind: "move", from_s: 3.5, to_s: 4 },
    { kind: "remove", time_s: 9 },
    { kind: "add", time_s: 3 },
    { kind: "merge", from_s: 0.5, to_s: 1 },
    { kind: "take_over", source: "x", edits: [] },
  ])
    assert.deepEqual(shown(edit), doc, edit.kind);
});

test("the document itself is never changed", () => {
  const before = structuredClone(doc);
  shown({ kind: "move", from_s: 3, to_s: 4 }, { kind: "drop_idle" }, { kind: "accept_labels" });
  assert.deepEqual(doc, before);
});

test("a document takes what it contains off the pending, and no more", () => {
  const pending = [3, 4, 5].map((event) => ({ event, edit: { kind: "drop_idle" } }));
  assert.deepEqual(
    stillPending(pending, 4).map(({ event }) => event),
    [5],
  );
});
