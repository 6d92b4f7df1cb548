/** Everything the page knows, by name. What a person may change is in the second half. */

import { firstChoice } from "./rows.js";

/**
 * What the server told
 * @typedef {{
 *   connected: boolean|null, greeted: boolean, lookingOnly: boolean, readOnly: boolean,
 *   recordings: {folder: string, current: string|null, items: import("./types.js").Recording[]},
 *   recording: string|null, method: string|null, document: import("./types.js").Doc|null,
 *   labels: {name: string, color: string}[],
 *   ghost: {time_s: number, origin: import("./types.js").Origin, fate: "comes"|"goes"}[],
 *   whole: import("./types.js").Signals|null, fine: import("./types.js").Signals|null,
 *   lens: import("./types.js").Signals|null, playhead: import("./types.js").Playhead,
 *   progress: any, sending: any, notice: ?{level: string, text: string}, comparison: any, spread: any,
 *   replay: any, samples: any, replayShown: boolean, defaults: Object<string, *>,
 *   record: any, replaySettings: any, robot: any, pushOffered: boolean, trials: any,
 *   shown: Object<string, boolean>, saved: ?{path: string, recording: string},
 *   inTheWay: ?{recording: string, kind: string, files: {name: string, whose: string}[]},
 *   following: string|null, lostAt: Date|null, command: string|null}} Told
 *
 * What a person looks at and holds; `hovered`, `current` and `explained` are numbers of boundaries,
 * `selected` and `renaming` of segments, `candidate` of a candidate, `pointer` and `clock` are times
 * @typedef {{
 *   view: import("./types.js").View|null, viewBefore: import("./types.js").View|null, clock: number, selected: number|null,
 *   hovered: number|null, candidate: number|null, current: number|null, explained: number|null, pointer: number|null,
 *   drag: any, range: [number, number]|null, planDrag: any, renaming: number|null,
 *   held: Object<string, *>, pending: import("./pending.js").Pending[], tab: string,
 *   drawer: "panel"|"queue"|null,
 *   holding: boolean, saving: boolean, small: boolean,
 *   dark: boolean|null, snap: boolean|null, logarithmic: boolean, leastCertainFirst: boolean, filter: string, firstSteps: boolean,
 *   folded: Set<string>, hidden: Set<string>, replayFolded: Set<string>, replayView: ?import("./types.js").View, plotWidth: number,
 *   paneHeight: number, paneWidth: number, layout: ?import("./rows.js").Layout}} Seen
 *
 * @typedef {Told & Seen & {[name: string]: any}} State
 */

/** Before anything was told. @param {boolean} small @returns {State} */
export function firstState(small) {
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
    playhead: { time_s: 0, playing: false, speed: 1, loop: false },
    progress: null,
    sending: null,
    notice: null,
    comparison: null,
    spread: null,
    replay: null,
    samples: null,
    replayShown: false,
    defaults: {},
    record: null,
    replaySettings: null,
    robot: null,
    pushOffered: false,
    trials: null,
    shown: {},
    saved: null,
    inTheWay: null,
    following: null,
    lostAt: null,
    command: null,
    view: null,
    viewBefore: null,
    clock: 0,
    selected: null,
    hovered: null,
    candidate: null,
    current: null,
    explained: null,
    pointer: null,
    drag: null,
    range: null,
    planDrag: null,
    renaming: null,
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
    firstSteps: false,
    ...firstChoice(small),
    replayFolded: new Set(["torque"]),
    replayView: null,
    plotWidth: 0,
    paneHeight: 0,
    paneWidth: 0,
    layout: null,
  };
}
