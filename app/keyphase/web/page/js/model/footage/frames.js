/**
 * Which frame of a video was taken when. Frame k is on the screen from `from_s + k / fps` of the file
 * on; half a frame later no rounding can bring its neighbour.
 *
 * @typedef {import("../../messages/control_messages").CameraMessage} Camera
 */

/** So near its beginning, in frames, a frame counts as begun: times are rounded on their way. */
const NEARLY = 0.02;

/**
 * The frame that is seen at a time of the recording; the first or last where there is none.
 * @param {Camera} camera
 * @param {number} offset s, how much later than its file says a person laid it
 * @param {number} time
 */
export function frameAt(camera, offset, time) {
  const at = Math.floor((time - camera.begins_s - offset) * camera.fps + NEARLY);
  return Math.min(Math.max(at, 0), camera.frames - 1);
}

/** Whether anything was filmed at a time. @param {Camera} camera */
export function isFilmed(camera, offset, time) {
  const at = (time - camera.begins_s - offset) * camera.fps + NEARLY;
  return at >= 0 && at < camera.frames;
}

/** The middle of a frame on the recording's clock. @param {Camera} camera */
export const timeOfFrame = (camera, offset, frame) =>
  camera.begins_s + offset + (frame + 0.5) / camera.fps;

/** Where in the file a frame is sought. @param {Camera} camera */
export const seekTime = (camera, frame) => camera.from_s + (frame + 0.5) / camera.fps;

/** Where in the file a time of the recording is. @param {Camera} camera */
export const fileTime = (camera, offset, time) => camera.from_s + time - camera.begins_s - offset;

/** The frame whose own time in the file the browser tells. @param {Camera} camera */
export const frameShown = (camera, mediaTime) =>
  Math.round((mediaTime - camera.from_s) * camera.fps);

/** What a person has laid a camera later by [s]. @param {import("../types.js").Doc|null} doc */
export const offsetOf = (doc, { name }) => doc?.camera_offsets[name] ?? 0;

/** The cameras that are looked at, in their order. @param {import("../state.js").State} state */
export function chosenCameras({ cameras, camerasChosen }) {
  const all = cameras?.cameras ?? [];
  const chosen = all.filter(({ name }) => camerasChosen.includes(name));
  return chosen.length ? chosen : all.slice(0, 1);
}

/** Whether there is anything to show beside the scene. @param {import("../state.js").State} state */
export const hasFootage = ({ cameras, camerasShown }) =>
  Boolean(camerasShown && cameras && cameras.cameras.length + cameras.refused.length);
