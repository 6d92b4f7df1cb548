// Made by `make protocol` from the structs in app/keyphase: change those.

import type { Edit } from "./edits";

/** Change a parameter; `held` while the person is still dragging. */
export interface SetRequest {
  type: "set";
  parameter: string;
  value: number | string | null;
  held?: boolean;
  recording: string;
  revision: number;
  event?: number | null;
}

/** Parameters back to automatic. */
export interface ResetRequest {
  type: "reset";
  recording: string;
  revision: number;
  event?: number | null;
}

/** Apply one edit. */
export interface EditRequest {
  type: "edit";
  edit: Edit;
  recording: string;
  revision: number;
  event?: number | null;
}

/** Take back the last edit or parameter change. */
export interface UndoRequest {
  type: "undo";
  recording: string;
  revision: number;
  event?: number | null;
}

/** Do again what was taken back. */
export interface RedoRequest {
  type: "redo";
  recording: string;
  revision: number;
  event?: number | null;
}

/** This recording is, or is not, finished. */
export interface DoneRequest {
  type: "done";
  done: boolean;
  recording: string;
  revision: number;
  event?: number | null;
}

/** The recording has changed since it was labeled, and the labels are to be kept. */
export interface KeepLabelsRequest {
  type: "keep_labels";
  recording: string;
  revision: number;
  event?: number | null;
}

/** Take over what was done to the same bytes under another name. */
export interface TakeJournalRequest {
  type: "take_journal";
  recording: string;
  revision: number;
  event?: number | null;
}

/** Take a label out of the folder's vocabulary. */
export interface ForgetLabelRequest {
  type: "forget_label";
  label: string;
  recording: string;
  revision: number;
  event?: number | null;
}

/**
 * Tell what these parameters would do to all recordings of the folder; do it; or never mind. With
 * `include_done` those that are done are opened again; without, they are left alone.
 */
export interface SpreadRequest {
  type: "spread";
  step: "apply" | "leave" | "look";
  include_done?: boolean;
  recording: string;
  revision: number;
  event?: number | null;
}

/**
 * Call a phase `to` in all recordings of the folder that have it; null: drop it in all. Those that
 * are done stay as they are, unless `include_done`; they stay done then, too.
 */
export interface PhaseForAllRequest {
  type: "phase_for_all";
  label: string;
  to?: string | null;
  include_done?: boolean;
  recording: string;
  revision: number;
  event?: number | null;
}

/** Take back what was done last to a phase in all recordings of the folder. */
export interface PhaseUndoRequest {
  type: "phase_undo";
  recording: string;
  revision: number;
  event?: number | null;
}

/** Keep these as the phases of the folder's task, in this order; none: it has no task. */
export interface PhasesRequest {
  type: "phases";
  name: string;
  phases: PhaseOfTask[];
  recording: string;
  revision: number;
  event?: number | null;
}

/**
 * A phase of a task: its name, colour (`#rrggbb`), what it ends with.
 * - optional: not every recording has it
 * - repeated: a recording may have it several times
 */
export interface PhaseOfTask {
  name: string;
  color: string;
  end: "configuration" | "contact" | "gripper" | "release";
  optional: boolean;
  repeated: boolean;
}

/** Compare with another segmentation of this recording; null: tell with which one can. */
export interface CompareRequest {
  type: "compare";
  with?: string | null;
  recording: string;
  revision: number;
  event?: number | null;
}

/** Tell what the other tools did that were recorded at the same time. */
export interface LanesRequest {
  type: "lanes";
  recording: string;
  revision: number;
  event?: number | null;
}

/** Make another segmentation of this recording its own, as one edit. */
export interface TakeOverRequest {
  type: "take_over";
  from: string;
  recording: string;
  revision: number;
  event?: number | null;
}

/** Write what was recorded from one time to another as a recording of its own, and open it. */
export interface CutRequest {
  type: "cut";
  from_s: number;
  to_s: number;
  recording: string;
  revision: number;
  event?: number | null;
}

/** Tell in which formats this recording can be written, and what each would lose. */
export interface OffersRequest {
  type: "offers";
  recording: string;
  revision: number;
  event?: number | null;
}

/**
 * Write a recording, or others of the list, too.
 * - kind: a format by the name it has in `offers`, or `page`: the replay that is over, as one that
 *   needs no server
 * - scope: this recording, those that are `picked`, those that are done, or all of the list
 * - trim_idle: leave out idle ends, where the format can
 * - if_there: what becomes of files that keyphase did not write as they are; without, `in_the_way`
 *   tells which there are
 */
export interface ExportRequest {
  type: "export";
  kind: string;
  scope?: "all" | "done" | "picked" | "this";
  picked?: string[];
  trim_idle?: boolean;
  if_there?: "ask" | "keep both" | "replace";
  recording: string;
  revision: number;
  event?: number | null;
}

/** Select a segment, or none; with `to` all from it to that one. */
export interface SelectRequest {
  type: "select";
  segment: number | null;
  to?: number | null;
  recording: string;
  revision: number;
  event?: number | null;
}

/** Ask for the visible range of some tracks. */
export interface SignalsRequest {
  type: "signals";
  recording: string;
  request: number;
  tracks: string[];
  from_s: number;
  to_s: number;
  width: number;
}
