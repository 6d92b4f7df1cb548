/** How far a replay is, in words. */

import assert from "node:assert/strict";
import test from "node:test";

import { endText, placeText } from "../../app/keyphase/web/page/js/replay/schedule.js";

const skill = (outcome, segment = 0) => ({ segment, outcome });
const over = (...skills) => placeText({ skills, current: null, phase: "over" });

test("a skill that was stopped has not ended", () => {
  const ended = [skill("reached", null), skill("reached"), skill("timeout")];
  assert.equal(over(...ended, skill("stopped")), "2 of 3 skills ended");
  assert.equal(over(...ended, skill("contact")), "3 of 3 skills ended");
});

test("a replay that is over says how it ended", () => {
  assert.equal(endText({ succeeded: true, outcome: "success" }), "succeeded");
  const stopped = "stopped by you in “Slide”; seated: no";
  assert.equal(endText({ succeeded: false, outcome: stopped }), "stopped by you");
  assert.equal(endText({ succeeded: false, outcome: "failed, not seated: timeout" }), "failed");
  assert.equal(endText({ succeeded: null, outcome: null }), "stopped before it moved");
});
