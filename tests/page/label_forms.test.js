/** Labels where room is short. */

import assert from "node:assert/strict";
import test from "node:test";

import { formsOf, measureless, shorter } from "../../app/keyphase/web/page/js/model/label_forms.js";
import { documentOf } from "./documents.js";

const DOWN = {
  ...documentOf(1, []).segments[0],
  label: "Move down 86 mm until contact",
  short: ["Move down 86 mm until contact", "Move until contact", "Move…"],
};

test("a proposed name loses its measure, its verb, its direction, its end, and at last all but a word", () => {
  assert.deepEqual(formsOf({ ...DOWN, proposed: true }), [
    "Move down 86 mm until contact",
    "Move down until contact",
    "Down until contact",
    "Move until contact",
    "Down",
    "Move…",
  ]);
});

test("what a person wrote is cut, and never put in other words", () => {
  const forms = formsOf({ ...DOWN, proposed: false });
  assert.deepEqual(forms, ["Move down 86 mm until contact", "Move…"]);
});

test("a person's name keeps its measure, its verb and its first letter", () => {
  for (const label of ["reach", "slide left, 12 mm", "Move to the box"]) {
    const named = { label, proposed: false };
    assert.deepEqual([measureless(named), shorter(named)], [label, label]);
  }
  const proposed = { ...DOWN, proposed: true };
  assert.equal(measureless(proposed), "Move down until contact");
  assert.equal(shorter(proposed), "Down until contact");
});
