import assert from "node:assert/strict";
import test from "node:test";

import { shownColumns } from "../../app/keyphase/web/page/js/panels/describing/channels.js";
import { withPart } from "../../app/keyphase/web/page/js/panels/describing/parts.js";

const NAMES = ["t", "pose[0]", "pose[1]", "pose[2]", "pose[3]", "ft[0]"];
const NONE = NAMES.map(() => "ignore");

test("the rest of a vector follows its first column", () => {
  assert.deepEqual(withPart(NONE, NAMES, 1, "x").slice(1, 5), ["x", "y", "z", "ignore"]);
});

test("a vector ends with its array, and takes no column that is read already", () => {
  assert.deepEqual(withPart(NONE, NAMES, 3, "fx").slice(3), ["fx", "fy", "ignore"]);
  const read = withPart(NONE, NAMES, 2, "gripper");
  assert.deepEqual(withPart(read, NAMES, 1, "x").slice(1, 4), ["x", "gripper", "ignore"]);
});

test("columns that are read come first, and a word narrows all of them", () => {
  const table = { names: NAMES, evidence: NAMES.map(() => ""), answers: { parts: [...NONE] } };
  table.answers.parts[5] = "fx";
  assert.deepEqual(shownColumns(table, ""), [5, 0, 1, 2, 3, 4]);
  assert.deepEqual(shownColumns(table, "POSE"), [1, 2, 3, 4]);
});
