// Made by `make protocol` from the structs in app/keyphase: change those.

/**
 * What a page is told first.
 * - client: its id, as in the cause of a document
 * - read_only: it may only look
 * - defaults: the parameters as they are where nobody chose any
 * - command: how the server is started again; null where that is not known
 */
export interface Hello {
  type: "hello";
  client: string;
  read_only: boolean;
  defaults: { [name: string]: any };
  command: string | null;
}

/** The list, whenever it changes; `current` is what this page looks at. */
export interface Recordings {
  type: "recordings";
  folder: string;
  current: string | null;
  items: RecordingLine[];
}

/**
 * One line of the list.
 * - folder: name of the folder it lies in
 * - strip: its segments in small; `color` null: idle or dropped
 * - unsure: how many boundaries a person should look at
 * - pages: who else is there
 * - proposed_from, proposed_confidence: from which finished recordings its segmentation is
 *   proposed, and how sure the least sure of it is
 * - outlier: it fits none of the finished ones
 * - differs: how its phases differ from theirs
 * - differences: how often another person's segments differ; null where there are none to compare
 *   with
 * - marked: what is said of single segments
 * - changed_since_done: segments were changed after it was done
 */
export interface RecordingLine {
  id: string;
  name: string;
  folder: string;
  state: "automatic" | "done" | "touched";
  confidence: number | null;
  unsure: number;
  strip: Piece[];
  error: string | null;
  pages: PageThere[];
  proposed_from: string[];
  proposed_confidence: number | null;
  outlier: boolean;
  differs: Difference | null;
  assessment: Assessment;
  differences: number | null;
  marked: Assessment[];
  changed_since_done: boolean;
}

/** One segment in a strip: its share of the duration, its colour; None: idle or dropped. */
export interface Piece {
  share: number;
  color: number | null;
}

/** Another page at a recording. */
export interface PageThere {
  id: string;
  name: string;
  color: number;
}

/**
 * How the phases of a recording differ from those of the finished ones.
 * - at: the name of the phase to look at
 * - told: in words
 */
export interface Difference {
  at: string;
  told: string;
}

/** Outcome, quality from 1 to 5, and a note; nothing is said where nobody has said it. */
export interface Assessment {
  outcome: "failure" | "success" | null;
  quality: number | null;
  note: string;
}

/** The page that is followed; null: none. */
export interface Following {
  type: "following";
  page: string | null;
}

/** Something that takes long; `fraction` null: nobody knows how much is left. */
export interface TaskMessage {
  type: "task";
  id: number;
  name: string;
  fraction: number | null;
  done: boolean;
}

/** A line of text, never HTML. */
export interface Notice {
  type: "notice";
  level: "error" | "info" | "warning";
  text: string;
}

/** A request that was not done, and why; its type, recording and event where it has them. */
export interface Refused {
  type: "refused";
  request: string;
  recording: string | null;
  event: number | null;
  text: string;
}

/**
 * What parameters would do to a folder, again and again until all `total` are known. Each look has
 * a number of its own, so that what was left is told from what is asked.
 */
export interface SpreadMessage {
  type: "spread";
  look: number;
  total: number;
  items: SpreadLine[];
}

/**
 * What the parameters would do to one recording; with an `error` nothing is known.
 * - newly_inapplicable: edits whose place would be gone
 * - own: parameters set on that recording alone, which go on holding
 * - done: a person has finished with it
 */
export interface SpreadLine {
  id: string;
  name: string;
  error: string | null;
  comes_s?: number[];
  goes_s?: number[];
  moves_s?: [number, number][];
  newly_inapplicable?: string[];
  own?: string[];
  done: boolean;
}

/**
 * All recordings of a folder and the phases of its task, again whenever any of it changes.
 * - ids: of all of them, in the order of the list
 * - rows: those that have changed since the message before; in the first one all
 * - task: name of the folder's task
 * - undo: what can be taken back in all recordings; null where nothing can
 */
export interface GridMessage {
  type: "grid";
  folder: string;
  ids: string[];
  rows: GridLine[];
  task: string;
  phases: TaskPhase[];
  undo: string | null;
}

/**
 * A recording in the grid.
 * - standing: as it is sorted and marked
 * - stretches: its segments, or what is proposed for it
 * - unsure: how many of its boundaries a person should look at
 * - proposed_from: from which recordings `stretches` are proposed; empty: they are its own
 * - differs: how its phases differ from those of the finished ones
 */
export interface GridLine {
  id: string;
  name: string;
  state: "automatic" | "done" | "touched";
  standing: "automatic" | "broken" | "differs" | "done" | "outlier" | "proposed" | "touched" | "unsure" | "waiting";
  stretches: Stretch[];
  unsure: number;
  proposed_from: string[];
  error: string | null;
  differs: Difference | null;
}

/**
 * A segment from one time to another [s]; `color` None: idle or dropped.
 * - proposed: nobody has given or accepted the name
 */
export interface Stretch {
  start_s: number;
  end_s: number;
  label: string;
  color: number | null;
  proposed: boolean;
}

/**
 * A phase of a task: its name, colour (`#rrggbb`) and kind of end.
 * - optional: not every recording has it
 * - repeated: a recording may have it several times, one after another
 */
export interface TaskPhase {
  name: string;
  color: string;
  end: "configuration" | "contact" | "gripper" | "release";
  optional: boolean;
  repeated: boolean;
}

/** The pieces of the file may come; `name` is what it will be called. */
export interface UploadReady {
  type: "upload_ready";
  name: string;
}

/** Why a file was not taken, before or after it came; nothing is left of it. */
export interface UploadRefused {
  type: "upload_refused";
  text: string;
}

/** The answer to `upload_cancel`; nothing is left of the file. */
export interface UploadCancelled {
  type: "upload_cancelled";
  name: string;
}

/**
 * The file is whole, could be read, and has this name now. A recording is opened; a segment file
 * (`compares`) is one of the options to compare with.
 */
export interface Uploaded {
  type: "uploaded";
  name: string;
  compares: boolean;
}
