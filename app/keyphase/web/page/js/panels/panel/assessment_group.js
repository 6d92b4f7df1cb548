/** What a person thinks of the recording as a whole: success or failure, quality, a note. */

import { el } from "../../lib/dom.js";
import { choice, group, line } from "./fields.js";

const OUTCOMES = [
  { value: "", text: "not marked" },
  { value: "success", text: "success" },
  { value: "failure", text: "failure" },
];
const QUALITIES = [
  { value: "", text: "not marked" },
  ...[1, 2, 3, 4, 5].map((one) => ({ value: String(one), text: `${one} of 5` })),
];

/**
 * @param {import("../../lib/store.js").Store} store
 * @param {any} actions
 */
export function createAssessmentGroup(store, actions) {
  const outcome = choice("Outcome", "Whether what was demonstrated succeeded.", (value) =>
    actions.assess({ outcome: value || null }),
  );
  const quality = choice("Quality", "How good it is to learn from.", (value) =>
    actions.assess({ quality: value ? Number(value) : null }),
  );
  const note = /** @type {HTMLInputElement} */ (
    el("input", {
      type: "text",
      maxlength: 1000,
      class: "note",
      on: { change: () => actions.assess({ note: note.value.trim() }) },
    })
  );
  store.on(["document", "readOnly"], ({ document: doc, readOnly }) => {
    if (!doc) return;
    const said = doc.assessment;
    outcome.show(OUTCOMES, said.outcome ?? "");
    quality.show(QUALITIES, String(said.quality ?? ""));
    if (document.activeElement !== note && note.value !== said.note) note.value = said.note;
    outcome.disable(readOnly);
    quality.disable(readOnly);
    note.disabled = readOnly;
  });
  return group(
    "Recording",
    {},
    outcome.node,
    quality.node,
    line("Note", "Kept with the labels, found by the filter of the list.", note),
  );
}
