/**
 * All recordings of a folder beside each other: their order, where their segments lie when they
 * are aligned, and what a change of a phase would make of them.
 *
 * @typedef {import("../../messages/list_messages").GridLine} Line
 * @typedef {import("../../messages/list_messages").GridMessage} Message
 * @typedef {import("../../messages/list_messages").TaskPhase} Phase
 * @typedef {import("../../messages/list_messages").Stretch} Stretch
 * @typedef {{folder: string, rows: Line[], task: string, phases: Phase[], undo: string|null}} Grid
 * @typedef {{label: string, to: string|null}} Change  to: its new name; null: it is dropped
 * @typedef {{stretch: Stretch, from: number, width: number, astray: boolean}} Piece  parts of 1
 */

export const AT_START = "start";
export const EQUAL = "equal";
/** Aligned where the phase of this name begins. @param {string} name */
export const atPhase = (name) => `at:${name}`;

/** What is known after a message: only rows that have changed are told again. @param {Grid|null} before @param {Message} message @returns {Grid} */
export function withGrid(before, { folder, ids, rows, task, phases, undo }) {
  const known = new Map((before?.rows ?? []).map((row) => [row.id, row]));
  for (const row of rows) known.set(row.id, row);
  const present = ids.map((id) => known.get(id)).filter((row) => row !== undefined);
  return { folder, rows: present, task, phases, undo };
}

/** How recordings stand, in the order in which they are counted; so many ask for a look first. */
const ORDER = /** @type {const} */ ([
  "outlier",
  "differs",
  "unsure",
  "proposed",
  "done",
  "touched",
  "automatic",
  "broken",
]);
const ASKING = 3;
const OF_SEVERAL = { outlier: "outliers", differs: "differ" };

/** Outliers first, those whose phases differ, those that ask for a look, then by name. @param {Line[]} rows */
export function inOrder(rows) {
  const rank = Object.fromEntries(ORDER.slice(0, ASKING).map((one, place) => [one, place]));
  const names = new Intl.Collator("en", { numeric: true });
  return rows.toSorted(
    (a, b) =>
      (rank[a.standing] ?? ASKING) - (rank[b.standing] ?? ASKING) || names.compare(a.name, b.name),
  );
}

/** How many stand how, those there are. @param {Line[]} rows @returns {Map<Line["standing"], number>} */
export function standings(rows) {
  const counts = new Map();
  for (const { standing } of rows) counts.set(standing, (counts.get(standing) ?? 0) + 1);
  return counts;
}

/** How many stand how, in words; those that wait are not counted. @param {Line[]} rows */
export function summary(rows) {
  const counts = standings(rows);
  return ORDER.filter((standing) => counts.has(standing))
    .map((standing) => {
      const count = counts.get(standing) ?? 0;
      return `${count} ${count > 1 ? (OF_SEVERAL[standing] ?? standing) : standing}`;
    })
    .join(", ");
}

const kept = ({ color }) => color !== null;

/**
 * The names of all phases: those of the task in their order, then others in the order in which
 * they come in the recordings, at last those of outliers alone.
 * @param {Grid} grid
 * @returns {string[]}
 */
export function phaseNames(grid) {
  const usual = usualNames(grid);
  return [...usual, ...namesBeside(usual, grid.rows)];
}

/** Those of the task, and of the recordings that are no outliers. @param {Grid} grid */
export function usualNames({ rows, phases }) {
  const own = phases.map(({ name }) => name);
  const alike = rows.filter(({ standing }) => standing !== "outlier");
  return [...own, ...namesBeside(own, alike)];
}

/**
 * Names that recordings have beside some, in the order in which they come there.
 * @param {string[]} own
 * @param {Line[]} rows
 */
export function namesBeside(own, rows) {
  /** @type {Map<string, number[]>} */
  const places = new Map();
  for (const { stretches } of rows) {
    const named = stretches.filter(kept);
    named.forEach(({ label }, k) =>
      places.set(label, [...(places.get(label) ?? []), k / named.length]),
    );
  }
  const mean = (name) => {
    const at = places.get(name) ?? [];
    return at.reduce((sum, place) => sum + place, 0) / at.length;
  };
  const others = [...places.keys()].filter((name) => name && !own.includes(name));
  return others.sort((a, b) => mean(a) - mean(b));
}

/** In how many recordings a phase is somebody's own, and not only proposed. @param {Grid} grid @param {string} name */
export const countOf = ({ rows }, name) =>
  rows.filter((row) => !row.proposed_from.length && has(row, name)).length;

const has = ({ stretches }, name) =>
  stretches.some((one) => one.label === name && one.color !== null);

/**
 * Where the segments of each recording lie, by its id; null where it has not the phase that all are
 * aligned at.
 * @param {Grid} grid
 * @param {string} align
 * @returns {Map<string, Piece[]|null>}
 */
export function laidOut(grid, align) {
  if (align === EQUAL) {
    const names = usualNames(grid);
    return new Map(
      grid.rows.map((row) => {
        const pieces = inColumns(row, names);
        return [row.id, pieces.length || !row.stretches.length ? pieces : null];
      }),
    );
  }
  const phase = align.startsWith("at:") ? align.slice(3) : null;
  const anchors = new Map(grid.rows.map((row) => [row.id, anchorOf(row, phase)]));
  const there = grid.rows.filter((row) => row.stretches.length && anchors.get(row.id) !== null);
  const early = Math.min(...there.map((row) => startOf(row) - anchors.get(row.id)), 0);
  const late = Math.max(...there.map((row) => endOf(row) - anchors.get(row.id)), early + 1e-9);
  return new Map(
    grid.rows.map((row) => {
      const anchor = anchors.get(row.id);
      return [row.id, anchor === null ? null : inTime(row, anchor + early, late - early)];
    }),
  );
}

const startOf = ({ stretches }) => stretches[0]?.start_s ?? 0;
const endOf = ({ stretches }) => stretches.at(-1)?.end_s ?? 0;

/** @param {Line} row @param {string|null} phase */
function anchorOf(row, phase) {
  if (phase === null) return startOf(row);
  return row.stretches.find((one) => one.label === phase && kept(one))?.start_s ?? null;
}

/** @param {Line} row @param {number} from_s @param {number} whole_s @returns {Piece[]} */
const inTime = ({ stretches }, from_s, whole_s) =>
  stretches.map((stretch) => ({
    stretch,
    from: (stretch.start_s - from_s) / whole_s,
    width: (stretch.end_s - stretch.start_s) / whole_s,
    astray: false,
  }));

/**
 * Every phase as long as every other: one column for each, shared by those that come again. One
 * that comes before a phase it should follow is astray.
 * @param {Line} row
 * @param {string[]} names
 * @returns {Piece[]}
 */
function inColumns({ stretches }, names) {
  const shown = stretches.filter((one) => kept(one) && names.includes(one.label));
  const times = (label) => shown.filter((one) => one.label === label).length;
  /** @type {Map<string, number>} */
  const seen = new Map();
  let furthest = -1;
  return shown.map((stretch) => {
    const column = names.indexOf(stretch.label);
    const before = seen.get(stretch.label) ?? 0;
    seen.set(stretch.label, before + 1);
    const astray = column < furthest;
    furthest = Math.max(furthest, column);
    const width = 1 / names.length / times(stretch.label);
    return { stretch, from: column / names.length + before * width, width, astray };
  });
}

/**
 * What a change would do: which recordings change, which are done and stay as they are, and which
 * only follow what is done, for what they show is proposed.
 * @param {Grid} grid
 * @param {Change} change
 * @param {boolean} includeDone
 */
export function effectOf({ rows }, { label, to }, includeDone) {
  const meant = (row) =>
    row.stretches.some((one) => one.label === label && (to !== null || one.color !== null));
  const having = rows.filter(meant);
  const own = having.filter((row) => !row.proposed_from.length);
  const done = own.filter(({ state }) => state === "done");
  const changing = own.filter(({ state }) => includeDone || state !== "done");
  return { changing, done, following: having.length - own.length };
}

/** A segment as it would be after a change. @param {Stretch} stretch @param {Change} change @returns {Stretch} */
export function changed(stretch, { label, to }) {
  if (stretch.label !== label) return stretch;
  return to === null ? { ...stretch, color: null } : { ...stretch, label: to, proposed: false };
}

/**
 * Phases and names as they are called after a change; a new name has the colour of the old one.
 * @template {{phases: Grid["phases"]}} G
 * @param {G} grid
 * @param {string[]} names
 * @param {Change} change
 * @returns {{grid: G, names: string[]}}
 */
export function calledAfter(grid, names, { label, to }) {
  if (to === null || names.includes(to)) return { grid, names };
  const phases = grid.phases.map((one) => (one.name === label ? { ...one, name: to } : one));
  return { grid: { ...grid, phases }, names: names.map((one) => (one === label ? to : one)) };
}

/**
 * The colour of a segment: that of its phase, so that it is the same in all recordings.
 * @param {Pick<Grid, "phases">} grid
 * @param {Stretch} stretch
 * @param {string[]} names
 */
export function colorOf({ phases }, { label, color }, names) {
  if (color === null) return null;
  const own = phases.find(({ name }) => name === label)?.color;
  return own ?? COLORS[Math.max(names.indexOf(label), 0) % COLORS.length];
}

/** In the order in which they are given out; the same in both themes. */
export const COLORS = ["#58A2F2", "#EFB63A", "#26C397", "#CA71B6", "#A7A425", "#8FDDE8", "#B98A63"];

/** The phases with one of them in another place, by so many. @template T @param {T[]} list @param {number} at @param {number} by */
export function shifted(list, at, by) {
  const to = Math.min(Math.max(at + by, 0), list.length - 1);
  return list.toSpliced(at, 1).toSpliced(to, 0, list[at]);
}
