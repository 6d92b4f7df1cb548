/** Requests about a document name the recording and the revision they are made on. */

/** @type {Set<import("./types.js").Request["type"]>} */
const ABOUT = new Set([
  "edit",
  "set",
  "reset",
  "undo",
  "redo",
  "done",
  "keep_labels",
  "take_journal",
  "forget_label",
  "spread",
  "phase_for_all",
  "phase_undo",
  "phases",
  "compare",
  "lanes",
  "take_over",
  "cut",
  "offers",
  "export",
  "select",
]);

/**
 * @param {import("./types.js").Asked} message
 * @param {import("./types.js").Doc|null} doc
 * @returns {import("./types.js").Request}
 */
export function aboutDocument(message, doc) {
  const place = doc && placeFor(message.type, doc);
  return /** @type {import("./types.js").Request} */ (place ? { ...place, ...message } : message);
}

/** @param {import("./types.js").Request["type"]} type @param {import("./types.js").Doc} doc */
function placeFor(type, { id, revision }) {
  if (type === "signals") return { recording: id };
  return ABOUT.has(type) ? { recording: id, revision } : null;
}
