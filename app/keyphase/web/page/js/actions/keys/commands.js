/**
 * Every command: its name, its key, what it does. Keys, the palette and the sheet of keys all
 * read this one list, so none of them can be forgotten. W A S D Q E and the arrow keys are left
 * to the camera.
 *
 * @typedef {{name: string, keys: string[], group: string, run: () => void,
 *   always?: boolean}} Command  keys as `keyOf` writes them; always: also without a recording
 */

import { fold } from "../../model/rows.js";

/**
 * @typedef {[string, string[], () => void, boolean?]} Row  name, keys, what it does, always
 * @typedef {{openPalette: (query?: string) => void, openKeys: () => void, chooseFiles: () => void,
 *   openMenu: () => void}} Dialogs
 */

/**
 * @param {any} actions
 * @param {import("../../lib/store.js").Store} store
 * @param {Dialogs} dialogs
 * @returns {Command[]}
 */
export function createCommands(actions, store, dialogs) {
  return [
    ...group("Playback", playbackCommands(actions)),
    ...group("Segments", segmentsCommands(actions, dialogs)),
    ...group("Boundaries", boundariesCommands(actions)),
    ...group("Plan", planCommands(actions)),
    ...group("Replay", replayCommands(actions)),
    ...group("View", viewCommands(actions, store)),
    ...group("Recordings", recordingsCommands(actions, dialogs)),
    ...group("Everything", everythingCommands(actions, dialogs)),
  ];
}

/** @param {string} name @param {Row[]} rows @returns {Command[]} */
const group = (name, rows) =>
  rows.map(([text, keys, run, always]) => ({ name: text, keys, run, group: name, always }));

/** Folds a row or opens it. @param {import("../../lib/store.js").Store} store @param {string} key */
const folds = (store, key) => () => fold(store, key);

/** @type {(actions: any) => Row[]} */
const playbackCommands = (actions) => [
  ["Play or pause", ["Space"], actions.togglePlay],
  ["Previous boundary", [","], () => actions.step(-1)],
  ["Next boundary", ["."], () => actions.step(1)],
  ["To the start", ["Home"], actions.toStart],
  ["To the end", ["End"], actions.toEnd],
  ["Play again and again", ["O"], actions.toggleLoop],
  ["Next frame of the camera", ["'"], () => actions.stepFrame(1)],
  ["Previous frame of the camera", [";"], () => actions.stepFrame(-1)],
  ["Play backwards; again: faster", ["Alt J"], () => actions.shuttle(-1)],
  ["Stop", ["Alt K"], () => actions.shuttle(0)],
  ["Play forwards; again: faster", ["Alt L"], () => actions.shuttle(1)],
  ["Play slower", [], () => actions.changeSpeed(-1)],
  ["Play faster", [], () => actions.changeSpeed(1)],
];

/** @type {(actions: any, dialogs: Dialogs) => Row[]} */
const segmentsCommands = (actions, dialogs) => [
  ["Split at the playhead; while playing, at the nearest evidence", ["T"], actions.split],
  ["Merge with the next segment", ["M"], actions.merge],
  ["Drop or keep the segment", ["X"], () => actions.toggleDrop()],
  ["Drop all idle segments", ["I"], actions.dropIdle],
  ["Label the segment", ["L"], () => actions.rename()],
  [
    "Label by number; held while it plays, what plays meanwhile",
    ["1 to 9"],
    () => dialogs.openPalette("label the segment"),
  ],
  ["Mark the segment as a success", [], () => actions.assessSegment({ outcome: "success" })],
  ["Mark the segment as a failure", [], () => actions.assessSegment({ outcome: "failure" })],
  ["Accept the proposed name or the boundary", ["Enter"], actions.accept],
  ["Accept all proposed names, or the whole proposal", ["Shift Enter"], actions.acceptAll],
  ["Previous segment", ["["], () => actions.selectNext(-1)],
  ["Next segment", ["]"], () => actions.selectNext(1)],
  ["Choose one more segment, or one less", ["Shift →"], () => actions.selectFurther(1)],
  ["Choose the one before, too, or one less", ["Shift ←"], () => actions.selectFurther(-1)],
];

/** @type {(actions: any) => Row[]} */
const boundariesCommands = (actions) => [
  ["Next unsure boundary", ["N"], () => actions.visitUnsure(1)],
  ["Previous unsure boundary", ["Shift N"], () => actions.visitUnsure(-1)],
  ["Move the boundary earlier", ["<"], () => actions.nudge(-1)],
  ["Move the boundary later", [">"], () => actions.nudge(1)],
  ["Move the boundary and all later ones earlier", [], () => actions.nudge(-1, true)],
  ["Move the boundary and all later ones later", [], () => actions.nudge(1, true)],
  ["Type the time of the boundary", ["Shift T"], actions.typeTime],
  ["Remove the boundary", ["Delete", "Backspace"], () => actions.removeBoundary()],
  ["Contact change or not", ["C"], () => actions.toggleContact()],
  ["Snap to evidence while dragging", ["V"], actions.toggleSnap],
];

/** @type {(actions: any) => Row[]} */
const planCommands = (actions) => [
  ["Repeat the segment", ["R"], actions.repeat],
  ["Earlier in the plan", ["{"], () => actions.shift(-1)],
  ["Later in the plan", ["}"], () => actions.shift(1)],
  ["Take out of the plan", ["Shift X"], actions.takeOut],
];

/** @type {(actions: any) => Row[]} */
const replayCommands = (actions) => [
  ["Replay the plan", ["P"], actions.replay.run],
  ["Replay skill by skill", [], actions.replay.next],
];

/** @type {(actions: any, store: import("../../lib/store.js").Store) => Row[]} */
const viewCommands = (actions, store) => [
  ["The whole recording", ["F"], actions.fit],
  ["Zoom to what is selected, and back", ["Z"], actions.zoomToSelection],
  ["Show the robot or not", ["B"], actions.toggleRobot],
  ["Show the cameras or not", ["H"], actions.toggleCameras],
  ["Next camera", ["Shift H"], actions.nextCamera],
  ["Lay the camera a frame earlier", ["("], () => actions.shiftCamera(-1)],
  ["Lay the camera a frame later", [")"], () => actions.shiftCamera(1)],
  ["Closer", ["+"], () => actions.zoom(1.5)],
  ["Further", ["-"], () => actions.zoom(1 / 1.5)],
  ["Linear or logarithmic error", ["Y"], actions.toggleScale],
  ["Light or dark", [], actions.toggleTheme, true],
  ["Least certain first in the list", [], actions.toggleOrder, true],
  ...["Error", "Position", "Speed", "Force", "Torque", "Orientation"].map(
    (title) =>
      /** @type {Row} */ ([
        `Fold or open ${title.toLowerCase()}`,
        [],
        folds(store, title.toLowerCase()),
      ]),
  ),
];

/** @type {(actions: any, dialogs: Dialogs) => Row[]} */
const recordingsCommands = (actions, dialogs) => [
  ["All recordings beside each other", ["Shift G"], actions.toggleGrid, true],
  ["Previous recording", ["PageUp"], () => actions.nextRecording(-1), true],
  ["Next recording", ["PageDown"], () => actions.nextRecording(1), true],
  ["Least certain recording", ["U"], actions.leastCertain, true],
  ["Done with this recording, on to the next", ["K"], actions.doneAndOn],
  ["Done, or not done after all", ["Shift K"], actions.toggleDone],
  ["Add recordings or segment files…", ["Ctrl O"], dialogs.chooseFiles, true],
  ["Apply these parameters to all recordings…", [], () => actions.spread("look")],
  ["Compare with what the program found, or no longer", ["G"], actions.toggleCompare],
  ["Next difference", ["J"], () => actions.visitDifference(1)],
  ["Previous difference", ["Shift J"], () => actions.visitDifference(-1)],
  ["Take over what is compared", [], actions.takeOver],
  ["Cut to what is in view, as a recording of its own", [], actions.cutToView],
  ["Export the segment file", ["Ctrl S"], () => actions.exportAs("json")],
  ["Export in another format…", ["Ctrl Shift S"], actions.chooseExport],
  ["Export all recordings", [], () => actions.exportAs("json", { scope: "all" })],
];

/** @type {(actions: any, dialogs: Dialogs) => Row[]} */
const everythingCommands = (actions, dialogs) => [
  ["Undo", ["Ctrl Z"], actions.undo],
  ["Redo", ["Ctrl Shift Z", "Ctrl Y"], actions.redo],
  ["Menu of what is chosen", ["Shift F10", "Menu"], dialogs.openMenu],
  ["Threshold back to automatic", [], actions.automaticThreshold],
  ["Parameters back to automatic", [], actions.resetParameters],
  ["Take back all edits", [], actions.resetEdits],
  ["Commands", ["Ctrl K"], dialogs.openPalette, true],
  ["Keys", ["?"], dialogs.openKeys, true],
];

const NAMED = { " ": "Space", ContextMenu: "Menu", ArrowLeft: "←", ArrowRight: "→" };

/**
 * A key press as commands write it: "Ctrl Shift Z", "Shift N", "Alt L", "?", "Space".
 * @param {KeyboardEvent} event
 */
export function keyOf({ key, code, altKey, ctrlKey, metaKey, shiftKey }) {
  // With Alt some systems write another sign, but the key is in the same place.
  if (altKey) return `Alt ${code.replace(/^Key/, "")}`;
  const letter = key.length === 1 ? key.toUpperCase() : key;
  const isLetter = /^[A-Z]$/.test(letter);
  // Shift is part of a sign like "?" already, and told apart only for letters and named keys.
  const shift = shiftKey && (isLetter || key.length > 1);
  return `${ctrlKey || metaKey ? "Ctrl " : ""}${shift ? "Shift " : ""}${NAMED[key] ?? letter}`;
}
