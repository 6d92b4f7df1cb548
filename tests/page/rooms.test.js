/** The page's scripts in their rooms: no circles, nothing imports upwards, no room is crowded. */

import assert from "node:assert/strict";
import { readdirSync, readFileSync } from "node:fs";
import { dirname, join, normalize, relative } from "node:path";
import { test } from "node:test";
import { fileURLToPath } from "node:url";

const ROOT = fileURLToPath(new URL("../../app/keyphase/web/page/js", import.meta.url));

/** Which rooms each room may import from, besides itself. */
const BELOW = {
  lib: [],
  model: ["lib"],
  timeline: ["lib", "model"],
  actions: ["lib", "model"],
  scene: ["lib", "model", "timeline"],
  replay: ["lib", "model", "timeline", "actions", "scene"],
  panels: ["lib", "model", "timeline", "actions", "scene", "replay"],
};

const MOST_MODULES = 20;
const MOST_LINES = 300;

const modules = readdirSync(ROOT, { recursive: true, encoding: "utf8" }).filter((name) =>
  name.endsWith(".js"),
);
const textOf = (module) => readFileSync(join(ROOT, module), "utf8");
const roomOf = (module) => (module.includes("/") ? module.split("/")[0] : "");

/** The modules that a module imports, as paths below the root. */
function importsOf(module) {
  const found = textOf(module).matchAll(/^(?:import|export)[^;]*?from "(\.[^"]+)"/gm);
  return [...found].map(([, path]) => normalize(join(dirname(module), path)));
}

const graph = new Map(modules.map((module) => [module, importsOf(module)]));

/** A circle of imports through these modules, or null. */
function circleFrom(module, path, finished) {
  if (path.includes(module)) return [...path.slice(path.indexOf(module)), module];
  if (finished.has(module)) return null;
  for (const next of graph.get(module) ?? []) {
    const circle = circleFrom(next, [...path, module], finished);
    if (circle) return circle;
  }
  finished.add(module);
  return null;
}

test("every import names a module that is there", () => {
  for (const [module, imports] of graph)
    for (const other of imports) assert.ok(graph.has(other), `${module} imports ${other}`);
});

test("imports never run in a circle", () => {
  const finished = new Set();
  for (const module of modules) assert.equal(circleFrom(module, [], finished), null);
});

test("rooms import only from the rooms below them", () => {
  for (const [module, imports] of graph) {
    const room = roomOf(module);
    if (!room) continue;
    for (const other of imports) {
      const allowed = roomOf(other) === room || BELOW[room]?.includes(roomOf(other));
      assert.ok(allowed, `${module} imports ${other}`);
    }
  }
});

test("no folder is crowded and no file is long", () => {
  const counts = Map.groupBy ? Map.groupBy(modules, dirname) : groupedBy(modules, dirname);
  for (const [folder, inside] of counts)
    assert.ok(inside.length <= MOST_MODULES, `${folder} holds ${inside.length} modules`);
  for (const module of modules) {
    const lines = textOf(module).split("\n").length - 1;
    assert.ok(lines <= MOST_LINES, `${module} has ${lines} lines`);
  }
});

test("no style sheet is long, and each is linked once", () => {
  const folder = join(ROOT, "..", "css");
  const sheets = readdirSync(folder);
  const page = readFileSync(join(ROOT, "..", "index.html"), "utf8");
  assert.ok(sheets.length <= MOST_MODULES, `${sheets.length} style sheets`);
  for (const sheet of sheets) {
    const lines = readFileSync(join(folder, sheet), "utf8").split("\n").length - 1;
    assert.ok(lines <= MOST_LINES, `${sheet} has ${lines} lines`);
    assert.equal(page.split(`/css/${sheet}"`).length, 2, sheet);
  }
});

function groupedBy(items, keyOf) {
  const groups = new Map();
  for (const item of items) groups.set(keyOf(item), [...(groups.get(keyOf(item)) ?? []), item]);
  return groups;
}

test("one file knows viser's client", () => {
  const knowing = modules.filter((module) => textOf(module).includes("__viser"));
  assert.deepEqual(knowing, [relative(".", "scene/viser_client.js")]);
});
