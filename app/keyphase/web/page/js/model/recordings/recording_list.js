/**
 * The list of recordings as a person sees it: filtered, in order, by folder, with names that can
 * be told apart.
 *
 * @typedef {import("../types.js").Recording} Recording
 */

/** Whether a recording asks for a look. @param {Recording} item */
export const asksForALook = ({ unsure, state }) => unsure > 0 && state !== "done";

/**
 * How far one is with a recording, in words.
 * @param {Recording|import("../types.js").Doc} of
 */
export const stateOf = ({ state, changed_since_done: changed }) =>
  changed ? /** @type {const} */ ("changed since done") : state;

/** So much of a common beginning is worth cutting, and so much of it stays. */
const WORTH_CUTTING = 8;
const STAYS = 3;

/**
 * Whether a recording fits a word of the filter: one of `is:success`, `is:failure`, `is:done` and
 * the like, `quality:3` (so good or better), `segment:failure` (or success, or marked: a segment of
 * it), or a part of its folder, its name, or a note.
 * @param {Recording} item
 * @param {string} word
 */
function fits({ name, folder = "", state, assessment, marked = [] }, word) {
  const { outcome, quality, note } = assessment ?? { outcome: null, quality: null, note: "" };
  const [what, value] = word.split(":");
  if (what === "is" && value) return [state, outcome ?? "unmarked"].includes(value);
  if (what === "quality" && value) return (quality ?? 0) >= Number(value);
  if (what === "segment" && value)
    return marked.some((one) => value === "marked" || one.outcome === value);
  const notes = [note, ...marked.map((one) => one.note)].join(" ");
  return `${folder}/${name} ${notes}`.toLowerCase().includes(word);
}

/**
 * The recordings in the order in which they are shown.
 * @param {{recordings: {items: Recording[]}, leastCertainFirst: boolean, filter: string}} state
 */
export function shownRecordings({ recordings, leastCertainFirst, filter }) {
  const words = filter.trim().toLowerCase().split(/\s+/).filter(Boolean);
  const items = recordings.items.filter((item) => words.every((word) => fits(item, word)));
  if (!leastCertainFirst) return items;
  return items.toSorted((a, b) => (a.confidence ?? 2) - (b.confidence ?? 2));
}

/**
 * The recording so many rows below the one that is open (above, for negative), among those shown.
 * @returns {Recording|undefined}
 * @param {import("../../lib/store.js").State} state
 */
export function recordingBeside(state, direction) {
  const shown = shownRecordings(state);
  const at = shown.findIndex(({ id }) => id === state.recording);
  if (at < 0) return direction > 0 ? shown[0] : shown.at(-1);
  return shown[at + direction];
}

/**
 * The picked recordings after a click on one: with Ctrl it comes or goes, with Shift all from the
 * one that is open to it are picked, without either none is.
 * @param {import("../../lib/store.js").State} state
 * @param {string} id
 * @param {{toggles: boolean, extends: boolean}} how
 * @returns {string[]}
 */
export function pickedWith(state, id, how) {
  const shown = shownRecordings(state).map((item) => item.id);
  if (how.extends) {
    const [from, to] = [shown.indexOf(state.recording ?? id), shown.indexOf(id)].sort(
      (a, b) => a - b,
    );
    return shown.slice(Math.max(from, 0), to + 1);
  }
  if (!how.toggles) return [];
  const before = state.picked.length || !state.recording ? state.picked : [state.recording];
  return before.includes(id) ? before.filter((one) => one !== id) : [...before, id];
}

/**
 * The next one, in the order shown and then from its start, that nobody has finished.
 * @param {import("../../lib/store.js").State} state
 */
export function nextUndone(state) {
  const shown = shownRecordings(state);
  const at = shown.findIndex(({ id }) => id === state.recording);
  return [...shown.slice(at + 1), ...shown.slice(0, Math.max(at, 0))].find(
    (item) => item.state !== "done" && !item.error,
  );
}

/** The next one that nobody has finished and that has a doubt left, in the order shown. */
export function nextDoubtful(state) {
  const shown = shownRecordings(state);
  const at = shown.findIndex(({ id }) => id === state.recording);
  return [...shown.slice(at + 1), ...shown.slice(0, Math.max(at, 0))].find(isDoubtful);
}

/** How many doubts are left in all recordings but the open one. */
export function doubtsElsewhere({ recordings, recording }) {
  return recordings.items
    .filter((item) => item.id !== recording && isDoubtful(item))
    .reduce((sum, { unsure }) => sum + unsure, 0);
}

const isDoubtful = (item) => item.state !== "done" && !item.error && item.unsure > 0;

/**
 * How much of the beginning all names have in common, up to a place where a word begins; 0 where
 * cutting it would not help.
 * @param {string[]} names
 */
export function commonBeginning(names) {
  if (names.length < 2) return 0;
  const first = names[0];
  let length = names.reduce((shared, name) => {
    let k = 0;
    while (k < shared && name[k] === first[k]) k++;
    return k;
  }, first.length);
  while (length > 0 && !/[\s_\-./]/.test(first[length - 1])) length--;
  return length >= WORTH_CUTTING ? length : 0;
}

/** The last word of what all share, if it is short enough to stay: it says what the rest counts. */
const LAST_WORD = /(?<![^\s_\-./#])[^\s_\-./#]{1,8}[\s_\-./]$/;

/**
 * A name without the middle of what all share: "ses…take_01", "pic…episode_0".
 * @param {string} name
 * @param {number} common
 */
export function cutName(name, common) {
  const word = LAST_WORD.exec(name.slice(0, common))?.[0] ?? name[common - 1];
  const from = common - (word?.length ?? 0);
  return from > STAYS + 1 ? `${name.slice(0, STAYS)}…${name.slice(from)}` : name;
}

/**
 * The recordings by folder, in the order in which the folders come first.
 * @param {Recording[]} items
 * @returns {{folder: string, items: Recording[]}[]}
 */
export function byFolder(items) {
  /** @type {Map<string, Recording[]>} */
  const folders = new Map();
  for (const item of items) {
    const own = folders.get(item.folder ?? "") ?? [];
    folders.set(item.folder ?? "", [...own, item]);
  }
  return [...folders].map(([folder, own]) => ({ folder, items: own }));
}

/** The next one, in the order shown, in which another person's segments differ. */
export function nextDiffering(state, direction) {
  const shown = shownRecordings(state);
  const at = shown.findIndex(({ id }) => id === state.recording);
  const beside =
    direction > 0
      ? [...shown.slice(at + 1), ...shown.slice(0, Math.max(at, 0))]
      : [...shown.slice(0, Math.max(at, 0)).reverse(), ...shown.slice(at + 1).reverse()];
  return beside.find(({ differences }) => differences);
}

/** Its name among the segmentations to compare with. */
export const PROPOSED = "proposed";

/** The comparison with another person's segments of the recording. */
export const ANOTHER = "another person";

/** The comparison with labels that others left in the recording's own file. */
export const GIVEN = "given";

/**
 * The line of the recording that is shown, where something is proposed and nobody has touched it.
 * @param {Pick<import("../../lib/store.js").State, "recording"|"recordings">} state
 * @returns {import("../types.js").Recording|undefined}
 */
export function proposedHere({ recordings, recording }) {
  return recordings.items.find(
    ({ id, state, proposed_from: from }) =>
      id === recording && state === "automatic" && from.length > 0,
  );
}

/** Names of a few recordings, for people. @param {readonly string[]} names */
export function namesOf(names) {
  const [last, ...others] = [...names].reverse();
  return others.length ? `${others.reverse().join(", ")} and ${last}` : last;
}

/**
 * A name on one line, whose last letters stand apart; no letter of two halves is cut between them.
 * @param {string} name
 * @param {number} end how many letters
 * @returns {[string, string]}
 */
export function nameApart(name, end) {
  const letters = [...name.replace(/[\p{Cc}\u2028\u2029]/gu, " ")];
  return [letters.slice(0, -end).join(""), letters.slice(-end).join("")];
}
