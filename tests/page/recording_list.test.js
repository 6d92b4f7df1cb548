/** The list of recordings: its order, names that can be told apart, where one goes next. */

import assert from "node:assert/strict";
import { test } from "node:test";
import {
  byFolder,
  commonBeginning,
  cutName,
  nameApart,
  nextUndone,
  recordingBeside,
  shownRecordings,
} from "../../app/keyphase/web/page/js/model/recordings/recording_list.js";

const item = (name, confidence, given = {}) => ({
  id: name,
  name,
  confidence,
  state: "automatic",
  error: null,
  ...given,
});
const stateOf = (items, given = {}) => ({
  recordings: { items },
  recording: items[0].id,
  leastCertainFirst: false,
  filter: "",
  ...given,
});
const items = [item("S02", 0.9), item("S03", 0.4), item("S04", 0.6), item("S05", null)];
const names = (state) => shownRecordings(state).map(({ name }) => name);

test("least certain first, those without a confidence last", () => {
  assert.deepEqual(names(stateOf(items, { leastCertainFirst: true })), [
    "S03",
    "S04",
    "S02",
    "S05",
  ]);
});

test("a filter finds names and folders, whatever their case", () => {
  const filed = [item("a", 1, { folder: "Monday" }), item("b", 1, { folder: "Tuesday" })];
  assert.deepEqual(names(stateOf(filed, { filter: "tues" })), ["b"]);
});

test("a filter finds what a person thinks of a recording, every word of it", () => {
  const said = (outcome, quality, note = "") => ({ assessment: { outcome, quality, note } });
  const marked = [
    item("S02", 0.9, said("success", 4)),
    item("S03", 0.4, said("failure", 2, "Peg dropped")),
    item("S04", 0.6, { ...said(null, null), state: "done" }),
  ];
  const found = (filter) => names(stateOf(marked, { filter }));
  assert.deepEqual(found("is:failure"), ["S03"]);
  assert.deepEqual(found("is:unmarked"), ["S04"]);
  assert.deepEqual(found("is:done"), ["S04"]);
  assert.deepEqual(found("quality:2"), ["S02", "S03"]);
  assert.deepEqual(found("quality:2 dropped"), ["S03"]);
});

test("a filter finds recordings by what is said of their segments", () => {
  const marked = [
    item("S02", 0.9, { marked: [{ outcome: "failure", quality: null, note: "Slipped" }] }),
    item("S03", 0.4, { marked: [{ outcome: null, quality: 2, note: "" }] }),
    item("S04", 0.6),
  ];
  const found = (filter) => names(stateOf(marked, { filter }));
  assert.deepEqual(found("segment:failure"), ["S02"]);
  assert.deepEqual(found("segment:marked"), ["S02", "S03"]);
  assert.deepEqual(found("slipped"), ["S02"]);
});

test("the next recording is the one below it as shown", () => {
  const state = stateOf(items, { leastCertainFirst: true, recording: "S03" });
  assert.equal(recordingBeside(state, 1).name, "S04");
  assert.equal(recordingBeside(state, -1), undefined);
});

test("the next undone one is found in the order shown, past the end, not past all", () => {
  const some = [item("a", 1), item("b", 1, { state: "done" }), item("c", 1)];
  assert.equal(nextUndone(stateOf(some)).name, "c");
  assert.equal(nextUndone(stateOf(some, { recording: "c" })).name, "a");
  const done = some.map((one) => ({ ...one, state: "done" }));
  assert.equal(nextUndone(stateOf(done)), undefined);
});

test("names lose the middle of what all share, at a place where a word begins", () => {
  const long = ["session_2026-11-03_take_01", "session_2026-11-03_take_02"];
  const common = commonBeginning(long);
  assert.equal(common, "session_2026-11-03_take_".length);
  assert.equal(cutName(long[1], common), "ses…take_02");
  assert.equal(cutName("pickplace#episode_7", "pickplace#episode_".length), "pic…episode_7");
  assert.equal(cutName("kitchen_demonstration_7", "kitchen_demonstration_".length), "kit…_7");
});

test("a name stands in one line, and its end splits no letter", () => {
  assert.deepEqual(nameApart("first\nsecond\t3", 7), ["first s", "econd 3"]);
  assert.deepEqual(nameApart("gripper 🤖run_02", 7), ["gripper ", "🤖run_02"]);
  assert.deepEqual(nameApart("S02", 7), ["", "S02"]);
});

test("short names and single ones stay whole", () => {
  assert.equal(commonBeginning(["S02", "S03"]), 0);
  assert.equal(commonBeginning(["session_2026-11-03_take_01"]), 0);
  assert.equal(cutName("S02", 0), "S02");
});

test("recordings stand by folder, in the order of the folders", () => {
  const filed = [
    item("a", 1, { folder: "x" }),
    item("b", 1, { folder: "y" }),
    item("c", 1, { folder: "x" }),
  ];
  assert.deepEqual(
    byFolder(filed).map((one) => [one.folder, one.items.map(({ name }) => name)]),
    [
      ["x", ["a", "c"]],
      ["y", ["b"]],
    ],
  );
});
