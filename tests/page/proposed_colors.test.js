import assert from "node:assert/strict";
import { test } from "node:test";
import { fillOf } from "../../app/keyphase/web/page/js/timeline/lanes/comparison.js";
import { documentOf } from "./documents.js";

const DOC = documentOf(10, []);
const LABEL = DOC.segments[0].label;
const KNOWN = [{ name: LABEL, color: "#123456" }];

test("a proposed name has the colour it will have once it is taken over", () => {
  const own = fillOf(LABEL, DOC, /** @type {any} */ (KNOWN), false);
  const proposed = fillOf(LABEL, DOC, /** @type {any} */ (KNOWN), true);
  assert.notEqual(own, "#123456");
  assert.equal(proposed, "#123456");
});
