/**
 * What the page knows of viser's client. It shows its camera, its nodes and its renderer to tests
 * under two names of its window; its version is fixed, and a browser test fails if they are gone.
 * No other file reads them.
 *
 * @typedef {{elements: number[]}} Matrix  4x4, column by column
 * @typedef {{canvas: HTMLCanvasElement|null, camera: {updateMatrixWorld: () => void,
 *   projectionMatrix: Matrix, matrixWorldInverse: Matrix}|null, cameraControl: any,
 *   nodeRefFromName: Object<string, ?{visible: boolean, matrixWorld: Matrix,
 *   traverse?: (each: (node: any) => void) => void}>}} Viser
 */

import { byId } from "../lib/dom.js";

/** What stands in the frame, once its client has started. @returns {Viser|undefined} */
export function viserIn(inside) {
  const viser = /** @type {any} */ (inside)?.__viserMutable;
  return viser?.camera && viser.canvas ? viser : undefined;
}

/** Whether the scene has the light and the colours of this page: before, it is white. */
export function isDressed(inside) {
  return Boolean(viserIn(inside)?.nodeRefFromName["/lights/sun"]);
}

/** Whether all of a recording is drawn, or cannot be (`web/scene/standing_mark.py`). */
export const isStanding = (inside, recording) =>
  Boolean(viserIn(inside)?.nodeRefFromName[`/standing/${recording}`]);

/**
 * Shows the picture of the ground once it is there: a picture that is still being decoded is drawn
 * white, which in the dark blinds for as long as the scene takes to draw its next frame.
 */
export function hideBareGround(inside) {
  viserIn(inside)?.nodeRefFromName["/grid/ground"]?.traverse?.((node) => {
    if (node.isMesh) node.visible = Boolean(node.material.map);
  });
}

/**
 * Whether a node was drawn; before, it has no place yet. All that was is turned, so that z is up.
 * @param {{matrixWorld: Matrix}} node
 */
export const isPlaced = ({ matrixWorld: { elements } }) =>
  elements.some((value, k) => value !== (k % 5 ? 0 : 1));

/** How many messages the client has yet to draw. @param {Window} inside */
export function waitingMessages(inside) {
  return /** @type {any} */ (inside).__viserMutable?.messageQueue?.length ?? 0;
}

/** How many frames the scene has drawn so far; undefined before it is there. */
export function sceneFrames() {
  const frame = /** @type {HTMLIFrameElement} */ (byId("viser"));
  return /** @type {any} */ (frame.contentWindow)?.__viserTestpoints?.rendererInfo?.render.frame;
}
