/** Every place where a boundary could be, at its probability: filled where it became one. */

import { svg } from "../../lib/dom.js";
import { LINES } from "../../model/evidence.js";
import { glyph } from "../glyphs.js";

/** With more candidates in view than so many, only those that became boundaries are drawn. */
const MOST_CANDIDATES = 300;
const REACH_PX = 7;
const NOTE_PX = 240;

const originOf = (kind) => LINES.find((line) => line.kind === kind).origin;

/**
 * @param {import("../../lib/store.js").State} state
 * @param {import("../../lib/scale.js").Scale} scale
 * @returns {{candidate: import("../../model/types.js").Candidate, index: number}[]}
 */
function inView({ document: doc }, scale) {
  const all = doc.candidates
    .map((candidate, index) => ({ candidate, index }))
    .filter(({ candidate: { time_s: time } }) => time >= scale.from && time <= scale.to);
  return all.length > MOST_CANDIDATES ? all.filter(({ candidate }) => candidate.given) : all;
}

/**
 * The marks, given ones on top.
 * @param {import("../../lib/store.js").State} state
 * @param {import("../../lib/scale.js").Scale} scale
 */
export function drawCandidates(state, scale, y) {
  const shown = inView(state, scale);
  if (shown.length > MOST_CANDIDATES) return [];
  shown.sort((a, b) => Number(a.candidate.given) - Number(b.candidate.given));
  return shown.map(({ candidate: { time_s: time, kind, probability, given }, index }) =>
    svg(
      "g",
      {
        class: "candidate",
        data: { candidate: index, given },
      },
      glyph(originOf(kind), {
        x: scale.x(time),
        y: y(probability),
        r: index === state.candidate ? 5.2 : 4,
        filled: given,
      }),
    ),
  );
}

/**
 * The candidate under the pointer, or null.
 * @param {import("../../lib/store.js").State} state
 * @param {import("../../lib/scale.js").Scale} scale
 */
export function nearestCandidate(state, scale, y, x, level) {
  let best = null;
  let distance = REACH_PX;
  for (const { candidate, index } of inView(state, scale)) {
    const away = Math.hypot(scale.x(candidate.time_s) - x, y(candidate.probability) - level);
    if (away <= distance) [best, distance] = [index, away];
  }
  return best;
}

/**
 * What the candidate under the pointer is, and what would let it in.
 * @param {HTMLElement} note
 * @param {import("../../lib/store.js").State} state
 * @param {import("../../lib/scale.js").Scale} scale
 */
export function showNote(note, state, scale, y, height) {
  const candidate = state.document.candidates[state.candidate];
  note.hidden = !candidate;
  if (!candidate) return;
  const { kind, probability, time_s: time, given, why_not: why } = candidate;
  const what = kind === "contact" ? "Contact change" : "Motion";
  note.textContent = `${what}, ${probability.toFixed(2)}. ${given ? "A boundary." : why}`;
  const x = scale.x(time);
  const left = x + NOTE_PX + 12 < scale.width ? x + 12 : Math.max(x - NOTE_PX - 12, 0);
  const above = y(probability) > height / 2;
  note.style.setProperty("--x", `${left}px`);
  note.style.setProperty("top", above ? "auto" : `${Math.max(y(probability) - 8, 2)}px`);
  note.style.setProperty(
    "bottom",
    above ? `${Math.max(height - y(probability) - 8, 2)}px` : "auto",
  );
}
