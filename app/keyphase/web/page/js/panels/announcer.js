/** Tells readers of the screen what an edit did, and which segment or boundary is chosen. */

import { byId } from "../lib/dom.js";
import { chosenStretch } from "../model/segments.js";
import { duration, moment, plural } from "../lib/format.js";

/** @typedef {import("../model/types.js").Doc} Doc */

/** @param {import("../lib/store.js").Store} store */
export function createAnnouncer(store) {
  const node = byId("announcer");
  /** @type {Doc|null} */
  let before = null;
  const say = (text) => (node.textContent = text);
  store.later(["document"], ({ document: doc }) => {
    const text = changeText(before, doc);
    before = doc;
    if (text) say(text);
  });
  store.later(["selectedTo"], (state) => {
    const [first, last] = chosenStretch(state) ?? [0, 0];
    if (first < last) say(`Segments ${first + 1} to ${last + 1} are selected.`);
  });
  store.later(["selected"], ({ document: doc, selected }) => {
    if (doc?.segments[selected]) say(segmentText(doc, selected));
  });
  store.later(["current"], ({ document: doc, current }) => {
    if (doc?.boundaries[current]) say(boundaryText(doc, current));
  });
}

/**
 * What has become of a recording, if anything: "Drop segment 3. 5 segments."
 * @param {Doc|null} before
 * @param {Doc|null} doc
 */
export function changeText(before, doc) {
  if (!doc) return "";
  const now = plural(doc.segments.length, "segment");
  if (before?.id !== doc.id) return `${doc.name} is open. ${now}.`;
  const isTaken = doc.redo && doc.redo === before.undo;
  if (isTaken && (doc.redo !== before.redo || doc.edits < before.edits))
    return `Undone: ${doc.redo}. ${now}.`;
  const isNew = doc.edits > before.edits || doc.undo !== before.undo;
  return isNew && doc.undo ? `${doc.undo}. ${now}.` : "";
}

/** "Segment 3, Move down until contact, 2.464 to 3.596 s, kept". */
export function segmentText({ segments }, index) {
  const { label, start_s: start, end_s: end, kept, proposed } = segments[index];
  const state = `${kept ? "kept" : "dropped"}${proposed ? ", name proposed" : ""}`;
  return `Segment ${index + 1}, ${label}, ${moment(start)} to ${moment(end)}, ${duration(end - start)} long, ${state}`;
}

/** "Boundary 2 at 3.596 s, from force, contact change, confidence 0.98". */
export function boundaryText({ boundaries }, index) {
  const { time_s: time, origin, contact_change: contact, confidence } = boundaries[index];
  const { accepted, taken_from: from } = boundaries[index];
  const facts = [
    `Boundary ${index + 1} at ${moment(time)}`,
    origin === "both"
      ? "from position and force"
      : origin === "user"
        ? from
          ? "taken over"
          : "placed by hand"
        : origin === "gripper"
          ? "from the gripper"
          : `from ${origin}`,
    ...(contact ? ["contact change"] : []),
    accepted ? "accepted" : `confidence ${confidence.toFixed(2)}`,
  ];
  return facts.join(", ");
}
