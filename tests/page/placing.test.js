import assert from "node:assert/strict";
import { test } from "node:test";
import { placed } from "../../app/keyphase/web/page/js/scene/placing.js";

const CANVAS = { width: 900, height: 300 };
const LOW = [
  { anchor: { x: 300, y: 100 }, width: 100 },
  { anchor: { x: 500, y: 230 }, width: 200 },
];

test("a name keeps clear of what covers the lower right corner", () => {
  const [, free] = placed(LOW, CANVAS, { width: 0, height: 0 });
  const [, above] = placed(LOW, CANVAS, { width: 220, height: 120 });
  assert.equal(free.y, 230);
  assert.ok(above.y + 13 <= 300 - 120, String(above.y));
});

test("a name that ends beside that corner stays where it is", () => {
  const [, place] = placed(LOW, CANVAS, { width: 100, height: 120 });
  assert.equal(place.y, 230);
});
