/** What is proposed for the open recording stands beside it as Shift Enter would take it over. */

import assert from "node:assert/strict";
import { test } from "node:test";
import { followed } from "../../app/keyphase/web/page/js/actions/proposals.js";

const NOTHING = { recording: null, what: "" };
const looking = (from, comparison = null, given = {}) =>
  /** @type {any} */ ({
    recording: "b",
    recordings: {
      items: [
        { id: "b", state: "automatic", proposed_from: from, proposed_confidence: 0.8, ...given },
      ],
    },
    comparison,
  });

test("what is proposed is shown once there is something, and again when it has become another", () => {
  const none = followed(NOTHING, looking([]));
  assert.deepEqual(none, { shown: NOTHING, ask: false });
  const first = followed(none.shown, looking(["a"]));
  assert.equal(first.ask, true);
  const same = followed(first.shown, looking(["a"], { with: "proposed" }));
  assert.equal(same.ask, false);
  const other = followed(same.shown, looking(["c"], { with: "proposed" }));
  assert.equal(other.ask, true);
  const surer = looking(["c"], { with: "proposed" }, { proposed_confidence: 0.9 });
  assert.equal(followed(other.shown, surer).ask, true);
});

test("what a person closed, or compares with instead, stays until the recording is open again", () => {
  const { shown } = followed(NOTHING, looking(["a"]));
  const closed = followed(shown, looking(["c"], { with: null }));
  assert.equal(closed.ask, false);
  assert.equal(followed(closed.shown, looking(["d"], { with: "automatic" })).ask, false);
  assert.equal(followed({ recording: "a", what: "" }, looking(["d"], { with: null })).ask, true);
});

test("a proposal that was taken over comes back where that is undone", () => {
  const { shown } = followed(NOTHING, looking(["a"]));
  const taken = followed(shown, looking([], { with: null }, { state: "touched" }));
  assert.equal(followed(taken.shown, looking(["a"], { with: null })).ask, true);
});
