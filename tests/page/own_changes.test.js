/** What a hand moved stays as it was left until the server's document contains it, or refuses it. */

import assert from "node:assert/strict";
import { test } from "node:test";
import { createOwnChanges } from "../../app/keyphase/web/page/js/model/own_changes.js";
import { boundary, documentOf } from "./documents.js";

/** A store without frames: what was set is there. */
function plainStore() {
  const state = { pending: [], held: {}, document: null };
  return { state, set: (patch) => Object.assign(state, patch) };
}

const MOVE = { kind: "move", from_s: 3, to_s: 4 };
const before = documentOf(10, [boundary(3)]);
const after = documentOf(10, [boundary(4)]);
const timeIn = ({ document }) => document.boundaries[0].time_s;

test("an older document does not put a moved boundary back", () => {
  const store = plainStore();
  const own = createOwnChanges(store);
  own.arrived(before, null);
  own.edited(7, MOVE);
  own.arrived({ ...before, revision: 2 }, null);
  own.arrived({ ...before, revision: 3 }, 6);
  assert.equal(timeIn(store.state), 4);
  own.arrived(after, 7);
  assert.equal(timeIn(store.state), 4);
  assert.deepEqual(store.state.pending, []);
});

test("a refusal puts it back, and leaves what else is pending", () => {
  const store = plainStore();
  const own = createOwnChanges(store);
  own.arrived(before, null);
  own.edited(7, MOVE);
  own.edited(8, { kind: "label", time_s: 1, label: "reach" });
  own.refused(7);
  assert.equal(timeIn(store.state), 3);
  assert.equal(store.state.document.segments[0].label, "reach");
});

test("a slider keeps its value while held, and until the document that has it", () => {
  const store = plainStore();
  const own = createOwnChanges(store);
  own.arrived(before, null);
  own.moved(1, "force_ratio", 5, true);
  own.moved(2, "force_ratio", 6, true);
  own.arrived(before, 2);
  assert.deepEqual(store.state.held, { force_ratio: 6 });
  own.moved(3, "force_ratio", 6.5, false);
  own.arrived(before, 2);
  assert.deepEqual(store.state.held, { force_ratio: 6.5 });
  own.arrived(before, 3);
  assert.deepEqual(store.state.held, {});
});

test("another recording has nothing pending", () => {
  const store = plainStore();
  const own = createOwnChanges(store);
  own.arrived(before, null);
  own.edited(1, MOVE);
  own.moved(2, "force_ratio", 5, false);
  own.arrived({ ...before, id: "b" }, null);
  assert.equal(timeIn(store.state), 3);
  assert.deepEqual(store.state.held, {});
});

test("what was selected before something else does not come back with its answer", () => {
  const store = plainStore();
  const own = createOwnChanges(store);
  store.state.selected = 5;
  own.selecting(4);
  own.selecting(5);
  assert.equal(own.selectedNow(4), 5);
  assert.equal(own.selectedNow(5), 5);
  assert.equal(own.selectedNow(2), 2, "a click in the scene, or another page that is followed");
});
