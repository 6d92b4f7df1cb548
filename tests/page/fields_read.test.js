/** Nothing travels for nobody: every field of every message is read by one of the page's scripts. */

import assert from "node:assert/strict";
import { readdirSync, readFileSync } from "node:fs";
import { join } from "node:path";
import { test } from "node:test";
import { fileURLToPath } from "node:url";
import ts from "typescript";

const JS = fileURLToPath(new URL("../../app/keyphase/web/page/js", import.meta.url));
const MESSAGES = join(JS, "messages");

/** Fields that no script names, each with who reads it. */
const READ_ELSEWHERE = new Map([
  ["ReplaySettingsMessage.part_height_m", "a slider of the Replay tab, by its name"],
  ["ReplaySettingsMessage.part_aside_m", "a slider of the Replay tab, by its name"],
  ["ReplaySettingsMessage.friction", "a slider of the Replay tab, by its name"],
  ["ReplaySettingsMessage.sensor_noise", "a slider of the Replay tab, by its name"],
  ...["threshold_N", "offset_m", "position_tolerance_m", "rotation_tolerance_rad", "timeout_s"].map(
    (name) =>
      /** @type {const} */ ([
        `EndConditionMessage.${name}`,
        "a figure of the Segment tab, by its name",
      ]),
  ),
  ["Refused.request", "whoever asks without an event, as the tests of the server do"],
]);

/** Asks TypeScript where a field is named. */
function languageService() {
  const files = readdirSync(JS, { recursive: true, encoding: "utf8" })
    .filter((name) => /\.(js|d\.ts)$/.test(name))
    .map((name) => join(JS, name));
  const options = {
    allowJs: true,
    checkJs: true,
    noEmit: true,
    target: ts.ScriptTarget.ES2023,
    module: ts.ModuleKind.ES2022,
    moduleResolution: ts.ModuleResolutionKind.Bundler,
    types: [],
  };
  const text = (name) => ts.ScriptSnapshot.fromString(readFileSync(name, "utf8"));
  return ts.createLanguageService({
    getScriptFileNames: () => files,
    getScriptVersion: () => "1",
    getScriptSnapshot: (name) => (ts.sys.fileExists(name) ? text(name) : undefined),
    getCurrentDirectory: () => JS,
    getCompilationSettings: () => options,
    getDefaultLibFileName: ts.getDefaultLibFilePath,
    fileExists: ts.sys.fileExists,
    readFile: ts.sys.readFile,
    directoryExists: ts.sys.directoryExists,
    getDirectories: ts.sys.getDirectories,
  });
}

/** The fields of what the server says: [name, place in its file]. */
function* fieldsOf(source) {
  for (const statement of source.statements) {
    if (!ts.isInterfaceDeclaration(statement)) continue;
    for (const member of statement.members)
      if (ts.isPropertySignature(member))
        yield [
          `${statement.name.text}.${member.name.getText(source)}`,
          member.name.getStart(source),
        ];
  }
}

function unread() {
  const service = languageService();
  const found = [];
  for (const file of readdirSync(MESSAGES).filter((name) => !/requests|edits/.test(name))) {
    const path = join(MESSAGES, file);
    for (const [name, place] of fieldsOf(service.getProgram().getSourceFile(path))) {
      if (name.endsWith(".type") || READ_ELSEWHERE.has(name)) continue;
      const uses = service.getReferencesAtPosition(path, place) ?? [];
      if (uses.every((use) => use.fileName.startsWith(MESSAGES))) found.push(name);
    }
  }
  return found;
}

test("every field of every message is read", () => {
  assert.deepEqual(unread(), []);
});
