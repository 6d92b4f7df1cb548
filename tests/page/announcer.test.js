/** What a reader of the screen hears of a change. */

import assert from "node:assert/strict";
import { test } from "node:test";

import { changeText } from "../../app/keyphase/web/page/js/panels/announcer.js";

/** @returns {any} */
const doc = (change) => ({
  id: "a",
  name: "S02",
  segments: [{}, {}],
  edits: 1,
  undo: "Drop segment 1",
  redo: null,
  ...change,
});

test("a recording that opens is named, and not what was last done to it", () => {
  assert.equal(changeText(null, doc()), "S02 is open. 2 segments.");
  assert.equal(changeText(doc({ id: "b" }), doc()), "S02 is open. 2 segments.");
});

test("an edit is told, also one like the one before it", () => {
  assert.equal(changeText(doc({ edits: 0, undo: null }), doc()), "Drop segment 1. 2 segments.");
  assert.equal(changeText(doc(), doc({ edits: 2 })), "Drop segment 1. 2 segments.");
  assert.equal(changeText(doc(), doc()), "");
});

test("what is taken back is said to be undone", () => {
  const undone = doc({ edits: 0, undo: null, redo: "Drop segment 1", segments: [{}] });
  assert.equal(changeText(doc(), undone), "Undone: Drop segment 1. 1 segment.");
  const second = doc({ edits: 1, undo: "Label segment 2", redo: "Drop segment 1" });
  assert.equal(changeText(doc({ edits: 2 }), second), "Undone: Drop segment 1. 2 segments.");
});
