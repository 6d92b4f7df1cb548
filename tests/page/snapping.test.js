/** A dragged boundary is caught by evidence near it. */

import assert from "node:assert/strict";
import { test } from "node:test";
import { nearestEvidence } from "../../app/keyphase/web/page/js/model/snapping.js";
import { boundary, documentOf, seriesOf } from "./documents.js";

/** A state with a speed curve that is slowest at 5 s. */
function stateOf(document) {
  const speed = { name: "speed", series: [seriesOf([9, 8, 7, 6, 5, 1, 5, 6, 7, 8, 9], 1)] };
  const whole = { from: 0, to: 10, tracks: new Map([["speed", speed]]) };
  return { document, view: { from: 0, to: 10 }, whole, fine: null, comparison: null };
}

const PEAK = { time_s: 2.0, bin_time_s: 2.1, height: 400, rejection: "" };

test("the onset of a force peak catches, and says what it is", () => {
  const state = stateOf(documentOf(10, [], { peaks: [PEAK] }));
  assert.deepEqual(nearestEvidence(state, 1.96, 0.1), { time: 2.0, name: "force onset" });
  assert.equal(nearestEvidence(state, 2.09, 0.1).name, "error peak");
});

test("a peak below the threshold does not catch", () => {
  const low = { ...PEAK, rejection: "below threshold" };
  assert.equal(nearestEvidence(stateOf(documentOf(10, [], { peaks: [low] })), 1.96, 0.1), null);
});

test("where the tool is slowest catches, but not the edge of the window", () => {
  const state = stateOf(documentOf(10, []));
  assert.deepEqual(nearestEvidence(state, 5.4, 1.5), { time: 5, name: "speed minimum" });
  assert.equal(nearestEvidence(state, 2.0, 1.5), null);
});

test("a boundary moved by hand finds its automatic place again", () => {
  const moved = boundary(3, { origin: "user", was_s: 2.5 });
  const state = stateOf(documentOf(10, [moved]));
  assert.equal(nearestEvidence(state, 2.55, 0.1, 0).name, "automatic place");
  assert.equal(nearestEvidence(state, 2.55, 0.1), null);
});

test("the nearest of several catches", () => {
  const other = { ...PEAK, time_s: 2.2, bin_time_s: 2.3 };
  const state = stateOf(documentOf(10, [], { peaks: [PEAK, other] }));
  assert.equal(nearestEvidence(state, 2.17, 0.2).time, 2.2);
});
