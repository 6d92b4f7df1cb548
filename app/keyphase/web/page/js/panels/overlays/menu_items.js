/** What the menus offer for what was clicked: a segment, a boundary, a recording, another way. */

import { stateOf } from "../../model/recordings/recording_list.js";

/** @typedef {import("./menu.js").Item} Item */

/** What the server's own comparisons are called here. */
const OWN_NAMES = {
  automatic: "What the program found",
  "found now": "As it would be found now",
  given: "Labels in the recording’s own file",
};

/**
 * @param {import("../../lib/store.js").Store} store
 * @param {any} actions
 * @param {any} hit
 * @param {number} time
 * @returns {Item[]}
 */
export function timelineItems(store, actions, hit, time) {
  const { document: doc, readOnly: off, labels } = store.state;
  const general = [
    { text: "Go here", run: () => actions.seek(time) },
    { text: "The whole recording", key: "F", run: actions.fit },
    { text: "All commands", key: "Ctrl K", run: () => actions.openPalette() },
  ];
  if (hit.kind === "boundary")
    return [...boundaryItems(doc, hit.boundary, actions, off), "rule", ...general];
  const index = doc.segments.findIndex(({ end_s: end }) => time < end);
  if (!doc.segments[index]) return general;
  return [
    ...thresholdItems(hit, actions, off),
    ...segmentItems(doc, index, time, labels, actions, off),
    "rule",
    ...planItems(doc, index, actions, off),
    "rule",
    ...general,
  ];
}

/** @param {any} hit @returns {Item[]} */
function thresholdItems({ kind, line }, actions, off) {
  if (kind !== "threshold" && kind !== "line") return [];
  const run = () => actions.automaticThreshold(line);
  return [{ text: "Threshold back to automatic", off, run }, "rule"];
}

/**
 * @param {import("../../model/types.js").Doc} doc
 * @param {number} index of the segment
 * @param {number} time
 * @param {import("../../lib/store.js").State["labels"]} labels
 * @param {any} actions
 * @param {boolean} off
 * @returns {Item[]}
 */
function segmentItems(doc, index, time, labels, actions, off) {
  const segment = doc.segments[index];
  return [
    { heading: `Segment ${index + 1}` },
    { text: "Label…", key: "L", off, run: () => actions.rename(index) },
    ...labels.slice(0, 9).map(({ name }, k) => ({
      text: name,
      key: String(k + 1),
      off,
      run: () => actions.label(name, index),
    })),
    ...(segment.proposed
      ? [{ text: "Accept its name", off, run: () => actions.acceptName(index) }]
      : []),
    ...(doc.segments.some(({ proposed, kept }) => proposed && kept)
      ? [{ text: "Accept all proposed names", key: "Shift Enter", off, run: actions.acceptNames }]
      : []),
    { text: segment.kept ? "Drop" : "Keep", key: "X", off, run: () => actions.toggleDrop(index) },
    { text: "Split here", off, run: () => actions.addBoundary(time) },
    {
      text: "Merge with the next",
      key: "M",
      off: off || index === doc.segments.length - 1,
      run: () => actions.mergeRange(index, index + 1),
    },
    {
      text: "Merge with the one before",
      off: off || index === 0,
      run: () => actions.mergeRange(index - 1, index),
    },
  ];
}

/**
 * @param {import("../../model/types.js").Doc} doc
 * @param {number} index of the segment
 * @param {any} actions
 * @param {boolean} off
 * @returns {Item[]}
 */
function planItems(doc, index, actions, off) {
  const isOff = off || !doc.segments[index].kept;
  return [
    {
      text: "Repeat in the plan",
      key: "R",
      off: isOff,
      run: () => (actions.select(index), actions.repeat()),
    },
    {
      text: "Earlier in the plan",
      key: "{",
      off: isOff,
      run: () => (actions.select(index), actions.shift(-1)),
    },
    {
      text: "Later in the plan",
      key: "}",
      off: isOff,
      run: () => (actions.select(index), actions.shift(1)),
    },
    {
      text: "Take out of the plan",
      key: "Shift X",
      off: isOff,
      run: () => (actions.select(index), actions.takeOut()),
    },
  ];
}

/**
 * @returns {Item[]}
 * @param {import("../../lib/store.js").Store} store
 */
export function recordingItems(store, actions, item) {
  const { recording, document: doc, readOnly: off, following, picked } = store.state;
  const isOpen = item.id === recording && doc;
  const done = stateOf(item) === "done";
  const others = item.pages ?? [];
  return [
    { heading: item.name },
    { text: "Open", off: isOpen, run: () => actions.open(item.id) },
    ...(item.error
      ? [{ text: "Say how it is read…", off, run: () => actions.describe(item.id) }]
      : []),
    ...(isOpen
      ? [
          {
            text: done ? "Not done after all" : "Done",
            key: "Shift K",
            off,
            run: actions.toggleDone,
          },
          { text: "Export the segment file", key: "Ctrl S", run: () => actions.exportAs("json") },
          { text: "Cut to what is in view", off, run: actions.cutToView },
        ]
      : []),
    ...(picked.length > 1 && picked.includes(item.id)
      ? [{ text: `Export the ${picked.length} picked…`, off, run: actions.chooseExport }]
      : []),
    { text: "Copy its address", run: () => actions.copyAddress(item) },
    ...others.map(({ id, name }) => ({
      text: `Follow ${name}`,
      checked: following === id,
      run: () => actions.follow(following === id ? null : id),
    })),
  ];
}

/** With which other segmentations of this recording the shown one can be compared. */
export function comparisonItems({ state }, actions) {
  const { options = ["automatic"], with: shown = null } = state.comparison ?? {};
  const items = options.map((name) => ({
    text: OWN_NAMES[name] ?? name,
    checked: name === shown,
    run: () => actions.compare(name === shown ? null : name),
  }));
  return ["rule", { heading: "Compare with" }, ...items];
}

/**
 * @returns {Item[]}
 * @param {import("../../model/types.js").Doc} doc
 */
function boundaryItems(doc, index, actions, off) {
  const boundary = doc.boundaries[index];
  return [
    { heading: `Boundary ${index + 1}` },
    { text: "Why it is there", run: () => actions.visit(index) },
    {
      text: "Accept",
      key: "Enter",
      off: off || boundary.accepted,
      run: () => actions.acceptBoundary(index),
    },
    {
      text: boundary.contact_change ? "Not a contact change" : "A contact change",
      key: "C",
      off,
      run: () => actions.toggleContact(index),
    },
    ...(boundary.was_s !== null
      ? [
          {
            text: "Back to where it was",
            off,
            run: () => actions.moveBoundary(boundary.time_s, boundary.was_s),
          },
        ]
      : []),
    { text: "Remove", key: "Delete", off, run: () => actions.removeBoundary(index) },
  ];
}
