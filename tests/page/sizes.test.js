/** The page's functions stay short enough to be read at a glance. */

import assert from "node:assert/strict";
import { readdirSync, readFileSync } from "node:fs";
import { join } from "node:path";
import { test } from "node:test";
import { fileURLToPath } from "node:url";
import ts from "typescript";

const JS = fileURLToPath(new URL("../../app/keyphase/web/page/js", import.meta.url));
const MOST_LINES = 45;

/**
 * How many lines each function of a script has, without those of functions written inside it: one
 * that holds others is to them what a class is to its methods.
 * @param {string} text
 * @returns {{name: string, lines: number}[]}
 */
function functionsIn(text) {
  const source = ts.createSourceFile("script.js", text, ts.ScriptTarget.ES2023, true);
  const lineOf = (place) => source.getLineAndCharacterOfPosition(place).line;
  const span = (node) => lineOf(node.end) - lineOf(node.getStart(source)) + 1;
  /** @type {{name: string, lines: number}[]} */
  const found = [];
  /** Lines of the functions directly inside a node. */
  function visit(node) {
    let inside = 0;
    ts.forEachChild(node, (child) => {
      inside += visit(child);
    });
    if (!ts.isFunctionLike(node)) return inside;
    const name = node.name?.getText(source) ?? "a function";
    found.push({
      name: `${name} in line ${lineOf(node.getStart(source)) + 1}`,
      lines: span(node) - inside,
    });
    // What stands before it in its first line stays with the one around it.
    return span(node) - 1;
  }
  visit(source);
  return found;
}

test("no function has more lines of its own than can be read at a glance", () => {
  const scripts = readdirSync(JS, { recursive: true, encoding: "utf8" });
  const long = scripts
    .filter((name) => name.endsWith(".js"))
    .flatMap((name) =>
      functionsIn(readFileSync(join(JS, name), "utf8"))
        .filter(({ lines }) => lines > MOST_LINES)
        .map((one) => `${name}: ${one.name} has ${one.lines} lines`),
    );
  assert.deepEqual(long, []);
});

test("lines of a function inside are not counted for the one around it", () => {
  const inner = `  function inner() {\n${"    work();\n".repeat(40)}  }\n`;
  const text = `function outer() {\n${inner}${"  work();\n".repeat(10)}}\n`;
  assert.deepEqual(
    functionsIn(text).map(({ lines }) => lines),
    [42, 13],
  );
});
