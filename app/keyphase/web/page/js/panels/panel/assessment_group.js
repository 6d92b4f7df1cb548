/** What a person thinks of the recording, or of the selected segments: outcome, quality, a note. */

import { el } from "../../lib/dom.js";
import { chosenStretch } from "../../model/segments.js";
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

/** @typedef {import("../../messages/list_messages").Assessment} Assessment */

/** @param {import("../../lib/store.js").Store} store @param {any} actions */
export function createAssessmentGroup(store, actions) {
  const fields = assessmentFields("", actions.assess);
  store.on(["document", "readOnly"], ({ document: doc, readOnly }) => {
    if (doc) fields.show(doc.assessment, readOnly);
  });
  return group("Recording", {}, ...fields.nodes);
}

/** Of the segments that are chosen. @param {import("../../lib/store.js").Store} store @param {any} actions */
export function createSegmentAssessmentGroup(store, actions) {
  const fields = assessmentFields(" of the segment", actions.assessSegment);
  const made = group("Segment", { open: false }, ...fields.nodes);
  made.hidden = true;
  const title = made.querySelector("summary span");
  store.on(["document", "selected", "selectedTo", "readOnly"], (state) => {
    const { document: doc, selected, readOnly } = state;
    const segment = doc && selected !== null ? doc.segments[selected] : null;
    made.hidden = !segment;
    if (!segment) return;
    const [first, last] = chosenStretch(state) ?? [selected, selected];
    if (title)
      title.textContent =
        first < last ? `Segments ${first + 1} to ${last + 1}` : `Segment ${first + 1}`;
    fields.show(segment.assessment, readOnly);
  });
  return made;
}

/**
 * @param {string} of what the fields are about, for readers of the screen
 * @param {(change: Partial<Assessment>) => void} tell
 */
function assessmentFields(of, tell) {
  const outcome = choice("Outcome", "Whether what was demonstrated succeeded.", (value) =>
    tell({ outcome: /** @type {Assessment["outcome"]} */ (value || null) }),
  );
  const quality = choice("Quality", "How good it is to learn from.", (value) =>
    tell({ quality: value ? Number(value) : null }),
  );
  const note = /** @type {HTMLInputElement} */ (
    el("input", {
      type: "text",
      maxlength: 1000,
      class: "note",
      on: { change: () => tell({ note: note.value.trim() }) },
    })
  );
  const nodes = [
    outcome.node,
    quality.node,
    line("Note", "Kept with the labels, found by the filter of the list.", note),
  ];
  for (const node of nodes) {
    const control = node.querySelector("select, input");
    if (of) control?.setAttribute("aria-label", `${node.querySelector("label")?.textContent}${of}`);
  }
  return {
    nodes,
    /** @param {Assessment} said @param {boolean} readOnly */
    show(said, readOnly) {
      outcome.show(OUTCOMES, said.outcome ?? "");
      quality.show(QUALITIES, String(said.quality ?? ""));
      if (document.activeElement !== note && note.value !== said.note) note.value = said.note;
      outcome.disable(readOnly);
      quality.disable(readOnly);
      note.disabled = readOnly;
    },
  };
}
