/** Requests about a document name the recording and the revision they are made on. */

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
  "compare",
  "take_over",
  "export",
  "select",
]);

/**
 * @param {import("./types.js").Message} message
 * @param {import("./types.js").Doc|null} doc
 * @returns {import("./types.js").Message}
 */
export function aboutDocument(message, doc) {
  if (!doc) return message;
  if (message.type === "signals") return { recording: doc.id, ...message };
  if (!ABOUT.has(message.type)) return message;
  return { recording: doc.id, revision: doc.revision, ...message };
}
