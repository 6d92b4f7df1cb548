/** How far a replay is, in words. */

import assert from "node:assert/strict";
import test from "node:test";

import { placeText } from "../../app/keyphase/web/page/js/replay/schedule.js";

const skill = (outcome, segment = 0) => ({ segment, outcome });
const over = (...skills) => placeText({ skills, current: null, phase: "over" });

test("a skill that was stopped has not ended", () => {
  const ended = [skill("reached", null), skill("reached"), skill("timeout")];
  assert.equal(over(...ended, skill("stopped")), "2 of 3 skills ended");
  assert.equal(over(...ended, skill("contact")), "3 of 3 skills ended");
});
