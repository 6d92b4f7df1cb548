/** What a person holds while another document comes is still there, or is let go. */

import assert from "node:assert/strict";
import { test } from "node:test";
import {
  boundaryStands,
  followed,
  planStands,
  segmentsStand,
} from "../../app/keyphase/web/page/js/model/held.js";
import { boundary, documentOf } from "./documents.js";

const before = documentOf(10, [boundary(3), boundary(6)]);
const state = (given = {}) => ({ document: before, renaming: null, ...given });

test("a boundary stands where the one of its number is at its time, in its recording", () => {
  const stands = boundaryStands(before, 1);
  assert.ok(stands(documentOf(10, [boundary(2), boundary(6)])));
  assert.ok(!stands(documentOf(10, [boundary(6)])));
  assert.ok(!stands(documentOf(10, [boundary(3), boundary(6.1)])));
  assert.ok(!stands({ ...before, id: "b" }));
  assert.ok(!stands(null));
});

test("segments stand where all are cut as before", () => {
  assert.ok(segmentsStand(before)({ ...before, revision: 9 }));
  assert.ok(!segmentsStand(before)(documentOf(10, [boundary(3)])));
});

test("a plan stands while it has the same entries in the same order", () => {
  const plan = [{ time_s: 1 }, { time_s: 5 }];
  const stands = planStands({ ...before, plan });
  assert.ok(stands({ ...before, plan: [...plan] }));
  assert.ok(!stands({ ...before, plan: plan.toReversed() }));
  assert.ok(!stands({ ...before, plan: plan.slice(1) }));
});

test("who is naming a segment goes on with the one at the same time", () => {
  const cut = documentOf(10, [boundary(1), boundary(3), boundary(6)]);
  assert.equal(followed(state({ renaming: 1 }), cut).renaming, 2);
  assert.equal(followed(state(), cut).renaming, null);
});

test("numbers of boundaries are forgotten where there are others, and kept where one moved", () => {
  assert.equal(followed(state(), documentOf(10, [boundary(3)])).current, null);
  assert.ok(!("current" in followed(state(), documentOf(10, [boundary(3), boundary(7)]))));
});
