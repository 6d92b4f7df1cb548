/** The recordings of a folder as strips: their order, where segments lie, what a change would do. */

import assert from "node:assert/strict";
import { test } from "node:test";
import {
  AT_START,
  atPhase,
  calledAfter,
  changed,
  colorOf,
  effectOf,
  EQUAL,
  inOrder,
  laidOut,
  phaseNames,
  shifted,
  summary,
  usualNames,
  withGrid,
} from "../../app/keyphase/web/page/js/model/recordings/grid.js";

/** A row of segments one after another, each `[name, seconds]`; a name in brackets is dropped. */
const row = (id, parts, given = {}) => {
  let end = 10;
  const stretches = parts.map(([name, lasts]) => {
    const start_s = end;
    end += lasts;
    const dropped = name.startsWith("(");
    return { start_s, end_s: end, label: name, color: dropped ? null : 0, proposed: false };
  });
  return {
    id,
    name: id,
    state: "touched",
    standing: "touched",
    stretches,
    unsure: 0,
    proposed_from: [],
    error: null,
    ...given,
  };
};
const gridOf = (rows, phases = []) => ({ folder: "f", rows, task: "t", phases, undo: null });
const one = row("one", [
  ["reach", 2],
  ["(idle)", 1],
  ["press", 1],
]);
const two = row("two", [
  ["(idle)", 3],
  ["reach", 1],
  ["press", 4],
]);
const lies = (pieces) => pieces.map(({ from, width }) => [from, width]);

test("outliers first, then what differs or is unsure, then by name as people count", () => {
  const rows = [
    row("take_10", []),
    row("take_9", []),
    row("z", [], { standing: "unsure" }),
    row("x", [], { standing: "differs" }),
    row("y", [], { standing: "outlier" }),
  ];
  assert.deepEqual(
    inOrder(rows).map(({ id }) => id),
    ["y", "x", "z", "take_9", "take_10"],
  );
});

test("how many stand how is said in the same order, without those that wait", () => {
  const stand = ["unsure", "waiting", "differs", "unsure", "differs", "outlier"];
  const rows = stand.map((standing, number) => row(`${number}`, [], { standing }));
  assert.equal(summary(rows), "1 outlier, 2 differ, 2 unsure");
});

test("a message tells only what has changed, and what is gone goes", () => {
  const message = { type: "grid", folder: "f", task: "t", phases: [], undo: null };
  const before = withGrid(null, { ...message, ids: ["one", "two"], rows: [one, two] });
  const later = row("two", [["lift", 1]]);
  const after = withGrid(before, { ...message, ids: ["two"], rows: [later] });
  assert.deepEqual(after.rows, [later]);
});

test("from the start all are on one scale, the longest as wide as there is room", () => {
  const places = laidOut(gridOf([one, two]), AT_START);
  assert.deepEqual(lies(places.get("one")), [
    [0, 0.25],
    [0.25, 0.125],
    [0.375, 0.125],
  ]);
  assert.equal(places.get("two").at(-1).from, 0.5);
});

test("aligned at a phase all begin it at the same place, and who lacks it has none", () => {
  const three = row("three", [["lift", 1]]);
  const places = laidOut(gridOf([one, two, three]), atPhase("press"));
  assert.equal(places.get("one")[2].from, places.get("two")[2].from);
  assert.equal(places.get("three"), null);
});

test("every phase equally long: what comes again shares its column, what is astray is told", () => {
  const again = row("again", [
    ["press", 1],
    ["reach", 1],
    ["press", 2],
  ]);
  const phases = ["reach", "press"].map((name) => ({ name, color: "#58A2F2", end: "contact" }));
  const places = laidOut(gridOf([one, again], phases), EQUAL);
  assert.deepEqual(lies(places.get("one")), [
    [0, 0.5],
    [0.5, 0.5],
  ]);
  assert.deepEqual(lies(places.get("again")), [
    [0.5, 0.25],
    [0, 0.5],
    [0.75, 0.25],
  ]);
  assert.deepEqual(
    places.get("again").map(({ astray }) => astray),
    [false, true, false],
  );
});

test("names stand in the order of the task, others as they come in the recordings", () => {
  const phases = [{ name: "press", color: "#58A2F2", end: "contact" }];
  const rows = [
    row("a", [
      ["lift", 1],
      ["reach", 1],
      ["press", 1],
    ]),
    one,
  ];
  assert.deepEqual(phaseNames(gridOf(rows, phases)), ["press", "lift", "reach"]);
});

test("a change leaves done ones unless they are meant, and never what is only proposed", () => {
  const done = row("done", [["reach", 1]], { state: "done", standing: "done" });
  const proposed = row("p", [["reach", 1]], { proposed_from: ["done"] });
  const grid = gridOf([one, done, proposed]);
  const change = { label: "reach", to: "approach" };
  const ids = (rows) => rows.map(({ id }) => id);
  assert.deepEqual(ids(effectOf(grid, change, false).changing), ["one"]);
  assert.deepEqual(ids(effectOf(grid, change, true).changing), ["one", "done"]);
  assert.equal(effectOf(grid, change, true).following, 1);
  assert.equal(changed(one.stretches[0], change).label, "approach");
  assert.equal(changed(one.stretches[0], { label: "reach", to: null }).color, null);
  assert.equal(changed(one.stretches[2], change), one.stretches[2]);
});

test("a phase goes earlier or later, and stays at the ends", () => {
  assert.deepEqual(shifted(["a", "b", "c"], 2, -1), ["a", "c", "b"]);
  assert.deepEqual(shifted(["a", "b", "c"], 0, -1), ["a", "b", "c"]);
});

test("what only outliers have is nothing to align at", () => {
  const other = row("other", [["rotate", 2]], { standing: "outlier" });
  assert.deepEqual(usualNames(gridOf([one, other])), ["reach", "press"]);
  assert.deepEqual(phaseNames(gridOf([one, other])), ["reach", "press", "rotate"]);
});

test("a new name is shown in the colour of the old one before it is given", () => {
  const grid = gridOf(
    [one],
    [
      { name: "reach", color: "#111111" },
      { name: "press", color: "#222222" },
    ],
  );
  const after = (to) => {
    const change = { label: "press", to };
    const called = calledAfter(grid, phaseNames(grid), change);
    return colorOf(called.grid, changed(one.stretches[2], change), called.names);
  };
  assert.equal(after("push"), "#222222");
  assert.equal(after("reach"), "#111111");
  assert.equal(after(null), null);
});
