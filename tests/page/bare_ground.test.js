/** The ground of the scene is not seen before its picture is there. */

import assert from "node:assert/strict";
import { test } from "node:test";
import { hideBareGround } from "../../app/keyphase/web/page/js/scene/viser_client.js";

/** viser's window with such a ground, and the mesh it is drawn as. */
function windowWith(map) {
  const mesh = { isMesh: true, visible: true, material: { map } };
  const ground = { visible: true, traverse: (each) => [{ visible: true }, mesh].forEach(each) };
  const nodeRefFromName = { "/grid/ground": ground };
  return { mesh, ground, inside: { __viserMutable: { camera: {}, canvas: {}, nodeRefFromName } } };
}

test("a ground whose picture has not come is not drawn white", () => {
  const { mesh, ground, inside } = windowWith(null);
  hideBareGround(inside);
  assert.deepEqual([mesh.visible, ground.visible], [false, true]);
  mesh.material.map = { picture: true };
  hideBareGround(inside);
  assert.equal(mesh.visible, true);
});

test("before viser has started, and without a ground, nothing happens", () => {
  hideBareGround({});
  hideBareGround({ __viserMutable: { camera: {}, canvas: {}, nodeRefFromName: {} } });
});
