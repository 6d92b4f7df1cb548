/** The address of a recording and a time in it. */

import assert from "node:assert/strict";
import { test } from "node:test";
import { addressIn, addressOf } from "../../app/keyphase/web/page/js/model/address.js";

test("a recording and a time stand in the address as a person would write them", () => {
  assert.equal(addressOf("S07", 16.82), "#S07@16.82");
  assert.equal(addressOf("S07", null), "#S07");
});

test("an address leads back to where it was made, whatever the name", () => {
  for (const name of ["S07", "take @ 3", "Versuch 03 äöü", "a/b#c", "100%", "x@12"])
    for (const time of [null, 0.5, 3999.996])
      assert.deepEqual(addressIn(addressOf(name, time)), { name, time });
});

test("what is no address names nothing", () => {
  for (const hash of ["", "#", "#%E0%A4%A"]) assert.equal(addressIn(hash), null);
});
