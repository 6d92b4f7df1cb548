/** Everything the page knows, by name. What a person may change is in the second half. */

import { firstChoice } from "./rows.js";

/**
 * What the server told
 * @typedef {import("../messages/list_messages").Recordings} Recordings
 * @typedef {import("../messages/control_messages").RecordMessage} RecordMessage
 * @typedef {import("../messages/control_messages").ReplaySettingsMessage} ReplaySettings
 * @typedef {import("../messages/control_messages").RobotMessage} Robot
 * @typedef {import("../messages/control_messages").TrialsMessage} Trials
 * @typedef {import("../messages/list_messages").TaskMessage} Task
 * @typedef {import("../messages/comparison_messages").ComparisonMessage} Comparison
 * @typedef {import("../messages/list_messages").SpreadMessage} Spread
 * @typedef {import("./types.js").Signals} Signals
 * @typedef {{path: string, lines: string, recording: string|null}} Saved
 * @typedef {{level: string, text: string|null, act?: {text: string, run: () => void}, of?: string}} Notice
 * @typedef {{
 *   connected: boolean|null, greeted: boolean, lookingOnly: boolean, readOnly: boolean,
 *   recordings: Omit<Recordings, "type">, recording: string|null, method: string|null,
 *   document: import("./types.js").Doc|null,
 *   labels: import("../messages/document_messages").VocabularyLabel[],
 *   ghost: import("../messages/document_messages").Ghost[],
 *   whole: Signals|null, fine: Signals|null, lens: Signals|null,
 *   playhead: import("./types.js").Playhead,
 *   progress: Task|null, sending: ?{name: string, fraction: number, more: number},
 *   tables: import("../messages/import_messages").TableProposal[],
 *   notice: Notice|null, comparison: Comparison|null, spread: Spread|null,
 *   lanes: import("../messages/comparison_messages").LaneMessage[],
 *   replay: import("./types.js").Replay|null,
 *   samples: import("../replay/samples.js").Samples|null, replayShown: boolean,
 *   defaults: Object<string, *>, record: RecordMessage|null,
 *   take: import("./recordings/take.js").Take|null, replaySettings: ReplaySettings|null,
 *   robot: Robot|null, pushOffered: boolean, trials: Trials|null,
 *   margin: import("../messages/control_messages").MarginMessage|null,
 *   shown: Object<string, boolean>, saved: Saved|null, exporting: string|null,
 *   offers: import("../messages/export_messages").OffersMessage|null,
 *   inTheWay: import("../messages/export_messages").InTheWayMessage|null,
 *   cameras: import("../messages/control_messages").CamerasMessage|null,
 *   following: string|null, lostAt: Date|null, command: string|null}} Told
 *
 * What a person looks at and holds; `hovered`, `current` and `explained` are numbers of boundaries,
 * `selected`, `selectedTo` (so far more are chosen with it) and `renaming` of segments, `candidate` of a candidate, `pointer` and `clock` are times,
 * `lineOver` is the parameter of the line under the pointer
 * @typedef {import("./types.js").View} View
 * @typedef {{
 *   view: View|null, viewBefore: View|null, clock: number, selected: number|null,
 *   selectedTo: number|null,
 *   hovered: number|null, candidate: number|null, lineOver: string|null,
 *   secondsPerDoubt: number|null, current: number|null, explained: number|null,
 *   pointer: number|null, drag: import("./drag.js").Drag|null, range: [number, number]|null,
 *   planDrag: any, renaming: number|null, naming: {from_s: number, label: string}|null,
 *   held: Object<string, *>,
 *   pending: import("./pending.js").Pending[], tab: string, drawer: "panel"|"queue"|null,
 *   holding: boolean, saving: boolean, small: boolean, dark: boolean|null, snap: boolean|null,
 *   logarithmic: boolean, leastCertainFirst: boolean, filter: string, picked: string[],
 *   firstSteps: boolean, camerasShown: boolean, camerasChosen: string[],
 *   sought: ReadonlySet<string>,
 *   folded: Set<string>, hidden: Set<string>, replayFolded: Set<string>, replayView: View|null,
 *   plotWidth: number, paneHeight: number, paneWidth: number,
 *   layout: import("./rows.js").Layout|null}} Seen
 *
 * The other pages at this recording, and all recordings of the folder beside each other; `asked` is
 * the recording this page wanted last, which may be unreadable; `goTo` is
 * where one goes on from there
 * @typedef {{grid: import("./recordings/grid.js").Grid|null, gridShown: boolean, gridAlign: string,
 *   gridChange: import("./recordings/grid.js").Change|null,
 *   refusals: number,
 *   others: import("../messages/document_messages").OtherSelected[],
 *   phaseSteps: import("./recordings/phase_steps.js").PhaseStep[],
 *   asked: string|null, goTo: {id: string, time_s: number}|null}} Beside
 *
 * @typedef {Told & Seen & Beside} State
 */

/** Before anything was told. @param {boolean} small @returns {State} */
export function firstState(small) {
  return { ...nothingTold(), ...nothingSeen(small), ...nothingBeside() };
}

/** @returns {Beside} */
const nothingBeside = () => ({
  others: [],
  grid: null,
  gridShown: false,
  gridAlign: "start",
  gridChange: null,
  refusals: 0,
  phaseSteps: [],
  asked: null,
  goTo: null,
});

/** @returns {Told} */
function nothingTold() {
  return {
    connected: null,
    greeted: false,
    lookingOnly: false,
    readOnly: false,
    recordings: { folder: "", current: null, items: [] },
    recording: null,
    method: null,
    document: null,
    labels: [],
    ghost: [],
    whole: null,
    fine: null,
    lens: null,
    playhead: { time_s: 0, playing: false, speed: 1, loop: false, between_s: null },
    progress: null,
    sending: null,
    tables: [],
    notice: null,
    comparison: null,
    lanes: [],
    spread: null,
    replay: null,
    samples: null,
    replayShown: false,
    defaults: {},
    record: null,
    take: null,
    replaySettings: null,
    robot: null,
    pushOffered: false,
    trials: null,
    margin: null,
    shown: {},
    saved: null,
    exporting: null,
    offers: null,
    inTheWay: null,
    cameras: null,
    following: null,
    lostAt: null,
    command: null,
  };
}

/** @param {boolean} small @returns {Seen} */
function nothingSeen(small) {
  return {
    view: null,
    viewBefore: null,
    clock: 0,
    selected: null,
    selectedTo: null,
    hovered: null,
    candidate: null,
    secondsPerDoubt: null,
    lineOver: null,
    current: null,
    explained: null,
    pointer: null,
    drag: null,
    range: null,
    planDrag: null,
    renaming: null,
    naming: null,
    held: {},
    pending: [],
    tab: "segment",
    drawer: null,
    holding: false,
    saving: false,
    small,
    dark: null,
    snap: null,
    logarithmic: true,
    leastCertainFirst: false,
    filter: "",
    picked: [],
    firstSteps: false,
    camerasShown: true,
    camerasChosen: [],
    sought: new Set(),
    ...firstChoice(small),
    replayFolded: new Set(["torque"]),
    replayView: null,
    plotWidth: 0,
    paneHeight: 0,
    paneWidth: 0,
    layout: null,
  };
}
