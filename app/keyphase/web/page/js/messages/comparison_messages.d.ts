// Made by `make protocol` from the structs in app/keyphase: change those.

/**
 * With what a recording can be compared, and where `with` is not null how that agrees.
 * - shared: (shown, other) times of boundaries both have
 * - only_first_s, only_second_s: boundaries of what is shown alone, of the other alone
 * - timing_s: median distance of shared boundaries
 * - differs_s: every moment at which the two differ, in boundaries or in names
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
  differs_s: number[];
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
