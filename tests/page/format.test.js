/** Times as they are written, and as a person types them. */

import assert from "node:assert/strict";
import test from "node:test";

import { moment, seconds, time } from "../../app/keyphase/web/page/js/lib/format.js";

test("from ten minutes on a time has minutes, then hours, and no unit", () => {
  assert.equal(moment(4.204), "4.204 s");
  assert.equal(time(725.5), "12:05.500");
  assert.equal(time(3999, 0), "1:06:39");
});

test("what is written is understood when typed, with a comma or a unit, too", () => {
  for (const value of [0.25, 4.204, 725.5, 3999.125]) assert.equal(seconds(moment(value)), value);
  assert.equal(seconds("1,25 s"), 1.25);
});

test("what is no time is none", () => {
  for (const text of ["", "never", "1:2:3:4", "4.2.1", "1e3"])
    assert.ok(Number.isNaN(seconds(text)));
});
