/** What a person did to the list of phases of the task, so that it can be taken back. */

/**
 * @typedef {import("./grid.js").Phase} Phase
 * @typedef {{before: Phase[], after: Phase[]}} PhaseStep
 */

/**
 * The steps after the list was changed; what nobody can take back any more is forgotten.
 * @param {PhaseStep[]} steps
 * @param {Phase[]} before
 * @param {Phase[]} after
 * @returns {PhaseStep[]}
 */
export function withPhaseStep(steps, before, after) {
  return [...(lastPhaseStep(steps, before) ? steps : []), { before, after }];
}

/**
 * The step that can be taken back: the last one, if the list still is what it made of it. Where
 * another person has changed it since, or a phase was renamed in all recordings, there is none.
 * @param {PhaseStep[]} steps
 * @param {Phase[]} phases
 * @returns {PhaseStep|undefined}
 */
export function lastPhaseStep(steps, phases) {
  const last = steps.at(-1);
  return last && isSame(last.after, phases) ? last : undefined;
}

const isSame = (a, b) => JSON.stringify(a.map(plain)) === JSON.stringify(b.map(plain));

/** A phase as it is compared: colours are written in either case. @param {Phase} phase */
const plain = ({ name, color, end, optional, repeated }) => [
  name,
  color.toUpperCase(),
  end,
  optional,
  repeated,
];
