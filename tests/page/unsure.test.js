/** The time that is left, and where the playhead is that plays around a doubt. */

import assert from "node:assert/strict";
import { test } from "node:test";
import { runningClock } from "../../app/keyphase/web/page/js/model/playback.js";
import { timeLeft } from "../../app/keyphase/web/page/js/model/unsure.js";

test("what is left is told in minutes once the pace is known", () => {
  assert.equal(timeLeft(52, null), "");
  assert.equal(timeLeft(52, 4), "about 3 min left");
  assert.equal(timeLeft(3, 4), "less than a minute left");
});

test("the clock stays around a doubt, and at an end where there is none", () => {
  const whole = { start_s: 0, end_s: 9 };
  const around = { time_s: 0, playing: true, speed: 1, loop: false, between_s: [2, 3] };
  assert.equal(runningClock(3.25, around, whole), 2.25);
  assert.equal(runningClock(1.75, around, whole), 2.75);
  assert.equal(runningClock(9.5, { ...around, between_s: null }, whole), 9);
  assert.equal(runningClock(-1, { ...around, between_s: null }, whole), 0);
});
