/** Cameras: which are seen, frame by frame, and how they lie on the recording's clock. */

import { chosenCameras, frameAt, offsetOf, timeOfFrame } from "../model/footage/frames.js";

/**
 * @param {import("../lib/store.js").Store} store
 * @param {(edit: import("../model/types.js").Edit) => void} edit
 * @param {any} actions
 */
export function createCameraActions(store, edit, actions) {
  const { state } = store;
  const current = () => chosenCameras(state)[0];
  const own = {
    toggleCameras: () => store.set({ camerasShown: !state.camerasShown }),
    /** Shows a camera beside the others, or no more; one is always shown. @param {string} name */
    toggleCamera(name) {
      const names = chosenCameras(state).map((one) => one.name);
      const next = names.includes(name) ? names.filter((one) => one !== name) : [...names, name];
      if (next.length) store.set({ camerasChosen: next });
    },
    /** Shows the next camera alone. */
    nextCamera() {
      const all = state.cameras?.cameras ?? [];
      const next = all[(all.findIndex(({ id }) => id === current()?.id) + 1) % all.length];
      if (next) store.set({ camerasChosen: [next.name], camerasShown: true });
    },
    /** Goes to the middle of the next frame, or the previous one. @param {number} by */
    stepFrame(by) {
      const camera = current();
      if (!camera || !state.document) return;
      const offset = offsetOf(state.document, camera);
      const frame = frameAt(camera, offset, state.clock) + by;
      const last = Math.min(Math.max(frame, 0), camera.frames - 1);
      actions.goTo(timeOfFrame(camera, offset, last));
    },
    /** Lays a camera later or earlier by frames. @param {number} by */
    shiftCamera(by) {
      const camera = current();
      if (camera) own.setCameraOffset(camera, offsetOf(state.document, camera) + by / camera.fps);
    },
    /** @param {import("../model/footage/frames.js").Camera} camera @param {number} offset s */
    setCameraOffset(camera, offset) {
      const rounded = Math.round(offset * 1e6) / 1e6;
      if (!Number.isFinite(offset) || rounded === offsetOf(state.document, camera)) return;
      edit({ kind: "camera_offset", camera: camera.name, offset_s: rounded });
    },
  };
  return own;
}
