// Made by `make protocol` from the structs in app/keyphase: change those.

/**
 * How a replay stands, whenever a skill ends or it pauses, goes on, is over.
 * - run: counts up
 * - words: what is disturbed; `world` is seed, friction and noise
 * - current: index of the skill that runs
 * - zero_m: positions are told from there
 */
export interface ReplayMessage {
  type: "replay";
  run: number;
  phase: "over" | "paused" | "running";
  name: string;
  words: string;
  world: string;
  goal: string;
  speed: number;
  held: boolean;
  time_s: number;
  current: number | null;
  zero_m: [number, number, number];
  force_arrow: ForceArrowMessage;
  skills: SkillMessage[];
  outcome: string | null;
  succeeded: boolean | null;
}

/** How the scene draws the force, so that a page can put its size at the arrow's tip. */
export interface ForceArrowMessage {
  beside_m: [number, number, number];
  metres_per_N: number;
  least_N: number;
}

/**
 * One skill of a replay.
 * - proposed: its name is the program's, and no person's
 * - middle_m: where it is named
 * - demonstrated_s: (from, to) in the recording
 * - met_s: when a contact was met
 */
export interface SkillMessage {
  segment: number | null;
  color: number | null;
  label: string;
  proposed: boolean;
  short: [string, string, string];
  middle_m: [number, number, number];
  until: string;
  contact: ContactMessage | null;
  expected_s: number;
  demonstrated_s: [number, number] | null;
  way_m: number;
  outcome: string | null;
  start_s: number | null;
  end_s: number | null;
  met_s: number | null;
  peak_N: number | null;
}

/** The contact at which a skill is over. */
export interface ContactMessage {
  direction: [number, number, number];
  threshold_N: number;
}

/**
 * What was measured since, about 60 times a second, at 125 Hz.
 * - first: index of the first row
 * - factor: replay time per real time
 * - rows: time_s, position x y z [mm], force x y z [N], torque x y z [N m], mm off the path
 * - demonstrated: columns by name for each skill, with row 0 only; null in a connecting move
 */
export interface ReplaySamples {
  type: "replay_samples";
  run: number;
  first: number;
  factor: number;
  rows: number[][];
  demonstrated?: ({ [name: string]: number[] } | null)[];
}

/** The replay is shown no more. */
export interface ReplayClosed {
  type: "replay_closed";
}
