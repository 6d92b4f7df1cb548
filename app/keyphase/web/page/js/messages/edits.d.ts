// Made by `make protocol` from the structs in app/keyphase: change those.

/** Put a boundary at `time_s`; None for contact change: as the force there says. */
export interface AddEdit {
  kind: "add";
  time_s: number;
  contact_change?: boolean | null;
}

/** Take the boundary at `time_s` away. */
export interface RemoveEdit {
  kind: "remove";
  time_s: number;
}

/** Move the boundary at `from_s` to `to_s`. */
export interface MoveEdit {
  kind: "move";
  from_s: number;
  to_s: number;
}

/**
 * Name the segment around `time_s`, or all from there to the one around `to_s`. An empty label
 * gives back the proposed one.
 */
export interface LabelEdit {
  kind: "label";
  time_s: number;
  label: string;
  span_s?: [number, number] | null;
  to_s?: number | null;
}

/** Keep or drop the segment around `time_s`, or all from there to the one around `to_s`. */
export interface KeepEdit {
  kind: "keep";
  time_s: number;
  kept: boolean;
  span_s?: [number, number] | null;
  to_s?: number | null;
}

/** Say whether the boundary at `time_s` is a contact change. */
export interface ContactEdit {
  kind: "contact";
  time_s: number;
  contact_change: boolean;
}

/** The boundary at `time_s` has been seen and found right. */
export interface AcceptEdit {
  kind: "accept";
  time_s: number;
}

/** Make one segment of all from `from_s` to `to_s`: every boundary strictly between goes. */
export interface MergeEdit {
  kind: "merge";
  from_s: number;
  to_s: number;
}

/**
 * Execute the segments around these times, in this order; a time may come again.
 * - spans_s: the segments' spans, one for each time
 * - left_out_s: spans of the kept segments that are not to be executed
 */
export interface PlanEdit {
  kind: "plan";
  order: number[];
  spans_s?: [number, number][] | null;
  left_out_s?: [number, number][];
}

/** Drop every idle segment. */
export interface DropIdleEdit {
  kind: "drop_idle";
}

/** Take the proposed label of every kept segment as it stands; `labels` is what they were. */
export interface AcceptLabelsEdit {
  kind: "accept_labels";
  labels?: LabelEdit[] | null;
}

/** Make edit number `edit`, whose place is gone, apply again by adding its boundaries. */
export interface BringBackEdit {
  kind: "bring_back";
  edit: number;
}

/** Leave out edit number `edit`, whose place is gone, from now on. */
export interface ForgetEdit {
  kind: "forget";
  edit: number;
}

/** Back to what the program found; all edits before count no more. */
export interface ResetEdit {
  kind: "reset";
}

/**
 * Take over another's segmentation of this recording; edits before count no more.
 * - source: where it came from, for people
 * - edits: what makes it of the automatic segmentation, in order; see `taking_over`
 * - confidences: time and confidence (0 to 1) of boundaries, where the source is not sure of all
 */
export interface TakeOverEdit {
  kind: "take_over";
  source: string;
  edits: (RemoveEdit | AddEdit | ContactEdit | LabelEdit | KeepEdit | PlanEdit)[];
  confidences?: [number, number][];
}

/**
 * The recording is finished: what is seen stays, whatever the program finds later.
 * - frozen: what was seen; None in what a person asks for
 */
export interface DoneEdit {
  kind: "done";
  frozen?: Frozen | null;
}

/**
 * Boundaries, segments and plan as values; `plan` holds indices of segments.
 * - parameters, software: what had made them
 */
export interface Frozen {
  boundaries: FrozenBoundary[];
  segments: FrozenSegment[];
  plan: number[];
  parameters: { [name: string]: any };
  software: string;
}

/** A boundary as it stood; see `LabeledBoundary`. */
export interface FrozenBoundary {
  time_s: number;
  origin: "both" | "force" | "gripper" | "position" | "user";
  interval_s: [number, number];
  confidence: number;
  contact_change: boolean;
  was_s?: number | null;
  accepted?: boolean;
  taken_from?: string | null;
}

/** A segment as it stood; see `LabeledSegment`. `undecided`: nobody said whether to keep it. */
export interface FrozenSegment {
  start_s: number;
  end_s: number;
  label: string;
  proposed: boolean;
  kept: boolean;
  idle: boolean;
  color: number;
  end_condition: { [name: string]: any };
  undecided?: boolean;
}

/** The recording is not finished after all: the program's boundaries and all edits count. */
export interface ReopenEdit {
  kind: "reopen";
}

/**
 * Give the segment around `time_s` an end condition; None gives it back the program's own.
 * - end: as a segment file has it: kind, direction, threshold_N, release, tolerances, offset_m,
 *   timeout_s; whether the demonstration agrees is found anew
 */
export interface SetEndEdit {
  kind: "end";
  time_s: number;
  end?: { [name: string]: any } | null;
  span_s?: [number, number] | null;
}

/** Show the video of `camera` later by `offset_s` [s] than its file says; below 0: earlier. */
export interface CameraOffsetEdit {
  kind: "camera_offset";
  camera: string;
  offset_s: number;
}

/**
 * Mark the recording as a success or a failure, with its quality from 1 to 5 and a note. The three
 * are said together; what is left out is taken back.
 */
export interface AssessEdit {
  kind: "assess";
  outcome?: "failure" | "success" | null;
  quality?: number | null;
  note?: string;
}

/**
 * Mark the segment around `time_s`, or all from there to the one around `to_s`. Outcome, quality
 * from 1 to 5 and note are said together; what is left out is taken back.
 */
export interface AssessSegmentEdit {
  kind: "assess_segment";
  time_s: number;
  outcome?: "failure" | "success" | null;
  quality?: number | null;
  note?: string;
  span_s?: [number, number] | null;
  to_s?: number | null;
}

/**
 * Make what lies from `from_s` to `to_s` one segment and name it. A boundary that is there already,
 * give or take SAME_S, is its side; those between go. Where a side is an end of the recording, it
 * is that.
 */
export interface NameStretchEdit {
  kind: "name_stretch";
  from_s: number;
  to_s: number;
  label: string;
}

/**
 * Move the boundary at `from_s`, and all later ones, by `by_s`. `all_s` are the times of all of
 * them, which `anchored` fills in.
 */
export interface RippleEdit {
  kind: "ripple";
  from_s: number;
  by_s: number;
  all_s?: number[];
}

/**
 * Name every segment that is called `label` `to` instead.
 * - step: the same in all recordings in which it was done together
 * - labels: the segments it is about; None in what a person asks for
 */
export interface RenamePhaseEdit {
  kind: "rename_phase";
  label: string;
  to: string;
  step: string;
  labels?: LabelEdit[] | null;
}

/** Drop every segment that is called `label`; `step` and `drops` as in RenamePhase. */
export interface DropPhaseEdit {
  kind: "drop_phase";
  label: string;
  step: string;
  drops?: KeepEdit[] | null;
}

export type Edit =
  | AddEdit
  | RemoveEdit
  | MoveEdit
  | LabelEdit
  | KeepEdit
  | ContactEdit
  | AcceptEdit
  | MergeEdit
  | PlanEdit
  | DropIdleEdit
  | AcceptLabelsEdit
  | BringBackEdit
  | ForgetEdit
  | ResetEdit
  | TakeOverEdit
  | DoneEdit
  | ReopenEdit
  | SetEndEdit
  | CameraOffsetEdit
  | AssessEdit
  | AssessSegmentEdit
  | NameStretchEdit
  | RippleEdit
  | RenamePhaseEdit
  | DropPhaseEdit;
