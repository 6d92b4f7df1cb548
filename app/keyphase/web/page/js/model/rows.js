/**
 * Which rows the timeline has, from top to bottom, and how high each is. The first five and a comparison stay
 * in place; the tracks below them scroll when the pane is lower than they are.
 *
 * @typedef {{key: string, y: number, height: number, folded: boolean}} Row
 * @typedef {{rows: Map<string, Row>, headHeight: number, height: number}} Layout
 */

/** Below this window width the page takes its small sizes. */
export const SMALL_BELOW_PX = 1500;

export const FOLDED_PX = 20;

const HEAD = [
  { key: "overview", large: 26, small: 20 },
  { key: "ruler", large: 18, small: 18 },
  { key: "boundaries", large: 20, small: 18 },
  { key: "segments", large: 42, small: 34 },
];

/** Every track: what it shows, its heights, the channel it needs and the method that has it. */
export const TRACKS = [
  {
    key: "evidence",
    title: "Evidence",
    unit: "",
    channel: "position",
    variant: "evidence",
    large: 112,
    small: 82,
  },
  { key: "error", title: "Normalized error", unit: "", channel: "force", large: 112, small: 78 },
  { key: "position", title: "Position", unit: "mm", channel: "position", large: 86, small: 56 },
  { key: "speed", title: "Speed", unit: "mm/s", channel: "position", large: 64, small: 46 },
  { key: "gripper", title: "Gripper", unit: "open", channel: "gripper", large: 56, small: 42 },
  { key: "force", title: "Force", unit: "N", channel: "force", large: 96, small: 62 },
  { key: "torque", title: "Torque", unit: "N m", channel: "torque", large: 86, small: 56 },
  {
    key: "orientation",
    title: "Orientation",
    unit: "deg",
    channel: "orientation",
    large: 86,
    small: 56,
  },
];

/** @param {import("../lib/store.js").State} state */
const showsSkills = ({ document: doc, hidden }) => Boolean(doc?.plan.length) && !hidden.has(SKILLS);

/** Where the further channels of a recording begin among the names of its channels. */
const NAMED = "channel/";

/** The lane of what is executed, above the segments it is made of. */
export const SKILLS = "skills";
const SKILLS_PX = 18;

/** The error beside the evidence, where it decides nothing: folded apart from the error alone. */
const SECOND_ERROR = "error beside evidence";
const FOLDED_AT_FIRST = ["speed", "torque", "orientation", SECOND_ERROR];
const HIDDEN_WHEN_SMALL = [SKILLS, "torque", "orientation"];

/** Which tracks are folded and hidden before anyone chose. @param {boolean} small */
export function firstChoice(small) {
  return { folded: new Set(FOLDED_AT_FIRST), hidden: new Set(small ? HIDDEN_WHEN_SMALL : []) };
}

/** What a row is called among the folded ones. @param {string} key @param {string|null} method */
export const foldName = (key, method) =>
  key === "error" && method === "evidence" ? SECOND_ERROR : isNamed(key) ? `open ${key}` : key;

/** Whether a track is one of the further channels, which are folded until somebody opens them. */
const isNamed = (key) => key.startsWith(NAMED);

/**
 * The tracks this recording can show and the person has not hidden.
 * @param {import("../lib/store.js").State} state
 */
export function tracksOf(state) {
  return tracksFor(state.document).filter(({ key }) => !state.hidden.has(key));
}

/** The tracks a recording has, shown or hidden. @param {import("./types.js").Doc|null} doc */
export function tracksFor(doc) {
  const known = TRACKS.filter(
    ({ channel, variant }) =>
      doc?.channels.includes(channel) && (!variant || variant === doc.parameters.variant),
  );
  const named = (doc?.channels ?? []).filter(isNamed).map((channel) => ({
    key: channel,
    title: channel.slice(NAMED.length),
    unit: "",
    channel,
    large: 64,
    small: 46,
  }));
  return [...known, ...named];
}

/**
 * @param {import("../lib/store.js").State} state
 * @param {number} [room] height of the pane; open tracks grow to fill what is left of it
 * @returns {Layout}
 */
export function layOut(state, room = 0) {
  const { small, folded, method } = state;
  const isFolded = ({ key }) => folded.has(foldName(key, method)) !== isNamed(key);
  const rows = new Map();
  let y = 0;
  const put = (key, height, isLow = false) => {
    rows.set(key, { key, y, height, folded: isLow });
    y += height;
  };
  for (const { key, large, small: low } of HEAD) {
    if (key === "segments" && showsSkills(state)) put("skills", SKILLS_PX);
    const isLow = key === "segments" && folded.has(key);
    put(key, isLow ? 24 : small ? low : large, folded.has(key));
  }
  if (state.lanes.length) put("lanes", state.lanes.length * (small ? 17 : 20));
  if (state.document?.events.length) put("events", small ? 15 : 17);
  if (state.camerasShown && state.cameras?.cameras.length)
    put("cameras", folded.has("cameras") ? FOLDED_PX : small ? 32 : 40, folded.has("cameras"));
  if (state.comparison?.with) put("comparison", small ? 32 : 36);
  const headHeight = y;
  const tracks = tracksOf(state);
  const natural = tracks.map((track) =>
    isFolded(track) ? FOLDED_PX : small ? track.small : track.large,
  );
  const total = natural.reduce((sum, height) => sum + height, 0);
  const open = natural.reduce((sum, height, k) => sum + (isFolded(tracks[k]) ? 0 : height), 0);
  const stretch = stretchOf(total, open, room - headHeight);
  tracks.forEach((track, k) => {
    const isLow = isFolded(track);
    put(track.key, Math.round(natural[k] * (isLow ? 1 : stretch)), isLow);
  });
  return { rows, headHeight, height: y };
}

function stretchOf(total, open, room) {
  return open > 0 && room > total ? 1 + (room - total) / open : 1;
}

/**
 * Folds a row or opens it.
 * @param {import("../lib/store.js").Store} store
 * @param {string} key
 */
export function fold(store, key) {
  toggle(store, "folded", foldName(key, store.state.method));
}

/**
 * Puts a name into one of the sets or takes it out: a track is hidden or shown, say.
 * @param {import("../lib/store.js").Store} store
 * @param {"folded"|"hidden"} what
 * @param {string} key
 */
export function toggle(store, what, key) {
  const next = new Set(store.state[what]);
  if (!next.delete(key)) next.add(key);
  store.set({ [what]: next });
}
