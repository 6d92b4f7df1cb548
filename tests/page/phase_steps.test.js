/** The list of phases is taken back step by step, and never over what another person did. */

import assert from "node:assert/strict";
import { test } from "node:test";
import {
  lastPhaseStep,
  withPhaseStep,
} from "../../app/keyphase/web/page/js/model/recordings/phase_steps.js";

/** @returns {import("../../app/keyphase/web/page/js/model/recordings/grid.js").Phase[]} */
const phases = (...names) =>
  names.map((name) => ({
    name,
    color: "#58A2F2",
    end: "configuration",
    optional: false,
    repeated: false,
  }));

test("the last change is taken back first", () => {
  const once = withPhaseStep([], phases("a"), phases("a", "b"));
  const twice = withPhaseStep(once, phases("a", "b"), phases("b", "a"));
  assert.deepEqual(lastPhaseStep(twice, phases("b", "a"))?.before, phases("a", "b"));
  assert.deepEqual(lastPhaseStep(twice.slice(0, -1), phases("a", "b"))?.before, phases("a"));
});

test("what another person has changed since is not taken back", () => {
  const once = withPhaseStep([], phases("a"), phases("a", "b"));
  assert.equal(lastPhaseStep(once, phases("a", "b", "theirs")), undefined);
  const later = withPhaseStep(once, phases("a", "b", "theirs"), phases("theirs"));
  assert.deepEqual(later, [{ before: phases("a", "b", "theirs"), after: phases("theirs") }]);
});

test("a colour written in the other case is no change", () => {
  const once = withPhaseStep([], phases("a"), phases("a", "b"));
  const told = phases("a", "b").map((one) => ({ ...one, color: one.color.toLowerCase() }));
  assert.ok(lastPhaseStep(once, told));
});
