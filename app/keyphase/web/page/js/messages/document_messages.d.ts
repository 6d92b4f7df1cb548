// Made by `make protocol` from the structs in app/keyphase: change those.

import type { Assessment } from "./list_messages";

/**
 * What a recording is at one revision.
 * - selected: index of the segment this page has selected
 * - folder: name of the folder it lies in
 * - notices: what was done on reading, and what journal and folder say
 * - threshold: the force threshold in force; null without force
 * - gaussians: how many the movement is described by; none without a mixture
 * - candidates: where boundaries could be, and what became of each
 * - greatest_step_N: the change of force that the longest arrow of the scene stands for
 * - changed_since_done: segments were changed after it was done
 * - locked: why nothing can be changed; null where it can
 * - changed: the file, or the recipe it is read with, is no longer the one that was labeled
 * - elsewhere: the same bytes were labeled under another name; null where nothing is known
 * - labels: the folder's vocabulary, in the order of the number keys
 * - saved_at: HH:MM:SS of the last step on disk
 * - inapplicable: edits whose place is gone
 * - line_counts: how many boundaries are found wherever each line lies
 * - assessment: what a person thinks of the recording as a whole
 * - camera_offsets: how far a person has moved each video on the recording's clock [s]
 * - held_back: how many more there would be, were another parameter let go
 */
export interface DocumentMessage {
  type: "document";
  revision: number;
  cause: CauseMessage | null;
  id: string;
  name: string;
  folder: string;
  start_s: number;
  end_s: number;
  rate_hz: number;
  channels: string[];
  force_channels: number;
  edits: number;
  notices: NoticeMessage[];
  parameters: { [name: string]: any };
  threshold: number | null;
  automatic_threshold: number | null;
  motion_threshold: number | null;
  automatic_motion_threshold: number | null;
  automatic_least_step_N: number | null;
  boundaries: BoundaryMessage[];
  segments: SegmentMessage[];
  peaks: PeakMessage[];
  gaussians: number;
  candidates: CandidateMessage[];
  plan: PlanEntryMessage[];
  proposed_drops: number[];
  inapplicable: Inapplicable[];
  undo: string | null;
  redo: string | null;
  saved_at: string | null;
  greatest_step_N: number | null;
  state: "automatic" | "done" | "touched";
  changed_since_done: boolean;
  locked: string | null;
  changed: boolean;
  elsewhere: ElsewhereMessage | null;
  labels: VocabularyLabel[];
  line_counts: LineCounts[];
  held_back: HeldBack[];
  breaks: BreakMessage[];
  events: EventMessage[];
  wrench_estimated: boolean;
  camera_offsets: { [name: string]: number };
  assessment: Assessment;
  selected: number | null;
}

/** The page's own number of the request that led here, and which page it was. */
export interface CauseMessage {
  event: number;
  client: string;
}

/**
 * What a person should know: of reading, of the journal or of the folder.
 * - severity: a warning where data was left out, held, filled or mended, is odd, or is not kept as
 *   usual
 */
export interface NoticeMessage {
  text: string;
  severity: "note" | "warning";
}

/**
 * A boundary.
 * - was_s: moved by hand from there
 * - taken_from: whose it was, where it was added by taking over
 * - accepted: seen by a person and found right
 * - unsure: a person should look at it
 * - change: what became of the contact; "" where it is no contact change
 * - at_m: where the tool was at a contact change
 */
export interface BoundaryMessage {
  time_s: number;
  origin: "both" | "force" | "gripper" | "position" | "user";
  interval_s: [number, number];
  confidence: number;
  contact_change: boolean;
  change: string;
  was_s: number | null;
  taken_from: string | null;
  accepted: boolean;
  unsure: boolean;
  at_m: [number, number, number] | null;
  why: Why;
}

/** Why a boundary is where it is, in words and figures; the few strongest reasons. */
export interface Why {
  sentences: string[];
  reasons: ReasonMessage[];
  height: number | null;
  times_threshold: number | null;
  position_s: number | null;
  steps: StepMessage[];
}

/** One term of a boundary's probability: what it says, and what it adds to the log-odds. */
export interface ReasonMessage {
  name: string;
  contribution: number;
}

/** How much one channel changed at a contact change. */
export interface StepMessage {
  name: string;
  value: number;
  unit: string;
  axis: string;
}

/**
 * A segment.
 * - proposed: its name is not accepted yet
 * - color: number of its colour
 * - short: the label, shorter, shortest
 * - middle_m: where the tool was in its middle
 */
export interface SegmentMessage {
  start_s: number;
  end_s: number;
  label: string;
  proposed: boolean;
  kept: boolean;
  idle: boolean;
  color: number;
  end_condition: EndConditionMessage;
  short: [string, string, string];
  middle_m: [number, number, number];
  assessment: Assessment;
}

/** When a skill is over: `contact` or `configuration`, with the figures of that kind. */
export interface EndConditionMessage {
  kind: "configuration" | "contact";
  direction?: [number, number, number];
  threshold_N?: number;
  release?: boolean;
  agrees?: boolean | null;
  offset_m?: number | null;
  position_tolerance_m?: number;
  rotation_tolerance_rad?: number;
  timeout_s?: number | null;
  gripper?: { [name: string]: any };
}

/** A peak of the error; `rejection` says why it is no boundary, nothing where it is. */
export interface PeakMessage {
  time_s: number;
  bin_time_s: number;
  height: number;
  rejection: string;
}

/** A place where a boundary could be; `why_not` says what would let it in. */
export interface CandidateMessage {
  time_s: number;
  kind: "contact" | "motion";
  probability: number;
  given: boolean;
  why_not: string;
}

/**
 * One entry of the plan.
 * - time_s: its anchor inside the segment
 * - repeat: how often the segment came before
 * - connect_mm: how far it starts from where the last one ended; null where that is near
 */
export interface PlanEntryMessage {
  time_s: number;
  segment: number;
  repeat: number;
  connect_mm: number | null;
}

/** An edit whose place is gone: its number in the document, and why, for people. */
export interface Inapplicable {
  edit: number;
  text: string;
}

/** What was done to the same bytes under another name; `take_journal` takes it over. */
export interface ElsewhereMessage {
  name: string;
  steps: number;
  done: boolean;
}

/** A label and its colour, as `#rrggbb`. */
export interface VocabularyLabel {
  name: string;
  color: string;
}

/**
 * How many boundaries are found wherever a line lies, all else as it is.
 * - parameter: whose line it is
 * - steps: probabilities (K,) at which the number changes, ascending
 * - counts: (K + 1,) numbers: of a line up to each step, and above the last
 */
export interface LineCounts {
  parameter: "force_threshold" | "motion_threshold";
  steps: number[];
  counts: number[];
}

/** Boundaries held back by a parameter whatever the lines, and its value that lets them go. */
export interface HeldBack {
  parameter: "least_step_N" | "turns";
  count: number;
  free: number | string;
}

/** A stretch in which nothing was demonstrated, a gap or a jump, and what it is in words. */
export interface BreakMessage {
  start_s: number;
  end_s: number;
  text: string;
}

/** Something that was logged in words, or what a button or digital output did. */
export interface EventMessage {
  time_s: number;
  text: string;
}

/** No recording is looked at any more. */
export interface NothingMessage {
  type: "nothing";
}

/** What a slider or line that is held would bring and take; empty when let go. */
export interface GhostMessage {
  type: "ghost";
  boundaries: Ghost[];
}

/** A boundary that a change under way would bring or take. */
export interface Ghost {
  time_s: number;
  origin: "both" | "force" | "gripper" | "position" | "user";
  fate: "comes" | "goes";
}

/** The segment this page has selected. */
export interface SelectionMessage {
  type: "selection";
  segment: number | null;
}

/** What the other pages at the recording that is shown have selected. */
export interface OthersMessage {
  type: "others";
  pages: OtherSelected[];
}

/** Another page at the same recording, and the segment it has selected. */
export interface OtherSelected {
  name: string;
  color: number;
  segment: number;
}

/** Where this page's playhead is; `between_s` is a stretch that is played again and again. */
export interface PlayheadMessage {
  type: "playhead";
  time_s: number;
  playing: boolean;
  speed: number;
  loop: boolean;
  between_s: [number, number] | null;
}

/** Which parts this page's scene shows. */
export interface ShownMessage {
  type: "shown";
  parts: { [name: string]: boolean };
}
