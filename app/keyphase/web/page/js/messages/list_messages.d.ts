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
 * One line of the list. proposed_from, proposed_confidence  from which finished recordings its
 * segmentation is proposed,                                     and how sure the least sure of it
 * is outlier                             it fits none of the finished ones
 * - folder: name of the folder it lies in
 * - strip: its segments in small; `color` null: idle or dropped
 * - unsure: how many boundaries a person should look at
 * - pages: who else is there
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
  assessment: Assessment;
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
 * With what a recording can be compared, and where `with` is not null how that agrees.
 * - shared: (shown, other) times of boundaries both have
 * - only_first_s, only_second_s: boundaries of what is shown alone, of the other alone
 * - timing_s: median distance of shared boundaries
 */
export interface ComparisonMessage {
  type: "comparison";
  recording: string;
  options: string[];
  with: string | null;
  boundaries_s: number[];
  labels: string[];
  shared: [number, number][];
  only_first_s: number[];
  only_second_s: number[];
  f1: number | null;
  same_label: number | null;
  timing_s: number | null;
}

/** The other tools that were recorded at the same time, as they stand. */
export interface LanesMessage {
  type: "lanes";
  recording: string;
  lanes: LaneMessage[];
}

/** Another tool of the same recording, which is a recording of the list by itself. */
export interface LaneMessage {
  id: string;
  name: string;
  segments: LaneSegment[];
}

/** What another tool did from one time to another; `color` null: idle or dropped. */
export interface LaneSegment {
  start_s: number;
  end_s: number;
  label: string;
  color: number | null;
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
