/** The rows of a replay's timeline, in a pane of any height. */

import assert from "node:assert/strict";
import test from "node:test";

import { layOutReplay } from "../../app/keyphase/web/page/js/replay/rows.js";

test("in a low pane open tracks stay high enough to be read, and in a high one they fill it", () => {
  const state = { small: true, replayFolded: new Set(["torque"]) };
  const tracks = (room) => {
    const { rows, height } = layOutReplay(state, room);
    return { heights: ["force", "position", "off"].map((key) => rows.get(key).height), height };
  };
  assert.ok(Math.min(...tracks(150).heights) >= 40);
  assert.ok(tracks(800).height > 790 && tracks(800).height <= 800);
});
