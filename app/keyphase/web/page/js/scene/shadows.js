/**
 * Shadows cost half the frames a second where 3D is drawn in software, and nothing one notices on
 * a graphics card. A page on a machine with one asks for them, once: whoever switches them off in
 * the panel has decided.
 */

import { viserIn } from "./viser_client.js";

const SOFTWARE = /swiftshader|llvmpipe|softpipe|software|basic render/i;
const ASKED = "keyphase.shadows-asked";
const LOOK_MS = 500;

/**
 * @param {import("../lib/store.js").Store} store
 * @param {import("../model/types.js").Send} send
 * @param {() => Window|null} inside viser's window
 */
export function askForShadows(store, send, inside) {
  if (localStorage.getItem(ASKED)) return;
  const timer = setInterval(() => {
    const { greeted, lookingOnly } = store.state;
    const canvas = viserIn(inside())?.canvas;
    if (!greeted || !canvas) return;
    clearInterval(timer);
    if (lookingOnly || SOFTWARE.test(rendererOf(canvas))) return;
    if (send({ type: "show", what: "shadows", visible: true })) localStorage.setItem(ASKED, "yes");
  }, LOOK_MS);
}

/** What draws 3D; a browser that does not say is taken for software. @param {HTMLCanvasElement} canvas */
function rendererOf(canvas) {
  const gl = canvas.getContext("webgl2");
  const told = gl?.getExtension("WEBGL_debug_renderer_info");
  return told ? String(gl.getParameter(told.UNMASKED_RENDERER_WEBGL)) : "software";
}
