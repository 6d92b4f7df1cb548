/** Frames of a video and times of the recording: there and back without a frame lost. */

import assert from "node:assert/strict";
import { test } from "node:test";
import {
  chosenCameras,
  frameAt,
  frameShown,
  isFilmed,
  seekTime,
  timeOfFrame,
} from "../../app/keyphase/web/page/js/model/footage/frames.js";
import { thumbnailsOf } from "../../app/keyphase/web/page/js/model/footage/thumbnails.js";
import { createScale } from "../../app/keyphase/web/page/js/lib/scale.js";

const camera = (given = {}) => ({
  id: "a",
  name: "front",
  fps: 30,
  frames: 90,
  from_s: 1234.5,
  begins_s: 2,
  width: 640,
  height: 360,
  ...given,
});

test("every frame comes back from its middle, at every rate and offset", () => {
  for (const fps of [10, 24000 / 1001, 30, 59.94, 240])
    for (const offset of [0, 0.04, -1.3])
      for (let frame = 0; frame < 90; frame++) {
        const one = camera({ fps });
        assert.equal(frameAt(one, offset, timeOfFrame(one, offset, frame)), frame);
        assert.equal(frameShown(one, one.from_s + frame / fps), frame);
        assert.equal(Math.floor((seekTime(one, frame) - one.from_s) * fps), frame);
      }
});

test("a time at which a frame begins, rounded on its way, is of that frame", () => {
  const one = camera({ begins_s: 0, from_s: 0 });
  for (let frame = 0; frame < 90; frame++)
    assert.equal(frameAt(one, 0, Math.fround(frame / 30)), frame);
});

test("before and after the video its ends are seen, and told to be no pictures of that time", () => {
  const one = camera();
  assert.deepEqual([frameAt(one, 0, 0), frameAt(one, 0, 99)], [0, 89]);
  assert.deepEqual(
    [1.9, 2, 4.9, 5.1].map((time) => isFilmed(one, 0, time)),
    [false, true, true, false],
  );
});

test("one camera is always chosen where there is any", () => {
  const cameras = { cameras: [camera(), camera({ id: "b", name: "wrist" })] };
  const names = (camerasChosen) =>
    chosenCameras({ cameras, camerasChosen }).map(({ name }) => name);
  assert.deepEqual(names([]), ["front"]);
  assert.deepEqual(names(["gone"]), ["front"]);
  assert.deepEqual(names(["wrist", "front"]), ["front", "wrist"]);
});

test("small pictures fill each segment, a part of one where it is narrow, none where not filmed", () => {
  const one = camera({ begins_s: 0, from_s: 0 });
  const scale = createScale({ from: 0, to: 4 }, 400);
  const segments = [
    { start_s: 0, end_s: 1.5 },
    { start_s: 1.5, end_s: 1.8 },
    { start_s: 1.8, end_s: 1.85 },
    { start_s: 3.2, end_s: 4 },
  ];
  const places = thumbnailsOf(segments, one, 0, scale, 70);
  assert.deepEqual(
    places.map(({ x, frame }) => [Math.round(x), frame]),
    [
      [0, 11],
      [75, 33],
      [150, 49],
    ],
  );
});
