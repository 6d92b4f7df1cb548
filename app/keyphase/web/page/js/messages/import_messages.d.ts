// Made by `make protocol` from the structs in app/keyphase: change those.

import type { TableAnswers } from "./import_requests";

/**
 * A recording that waits for a person to say how it is read; what the answers come to so far.
 * - others: so many more files of its folder and kind nobody has described either
 * - is_text: whether it is a table of text; else columns of a binary format
 * - others_inside: so many more recordings are in the same file and read alike
 * - asked: what is asked beside columns and units
 * - clocks: columns that rise like a time
 * - names, rows: its columns and first rows, as the answers split them
 * - evidence: why each column was proposed to be what it is, "" where it was not
 * - layout_evidence: the same for encoding, separator, decimal and header
 * - missing: what is still to be said, or why it cannot be read so
 * - looks: the recording, where nothing is missing; of two tools in it one each
 * - recipe: the recipe (TOML), where nothing is missing
 * - choices: what a column can be
 * - units: what each quantity can be written in
 */
export interface TableProposal {
  type: "table";
  id: string;
  name: string;
  others: number;
  answers: TableAnswers;
  is_text: boolean;
  others_inside: number;
  asked: string[];
  clocks: string[];
  names: string[];
  rows: string[][];
  evidence: string[];
  layout_evidence: { [name: string]: string };
  missing: string[];
  looks: TableLook[];
  recipe: string | null;
  choices: ("demonstration" | "fx" | "fy" | "fz" | "gripper" | "ignore" | "joint" | "nanoseconds" | "pitch" | "pose" | "quaternion" | "qw" | "qx" | "qy" | "qz" | "roll" | "rot6d" | "rotation" | "seconds" | "time" | "tx" | "ty" | "tz" | "x" | "y" | "yaw" | "z")[];
  units: { [name: string]: string[] };
}

/**
 * The recording as it would be read.
 * - name: which of the tools side by side in the file it is, "" where there is one
 * - path_m: points of the tool's path [m], in the robot's base frame
 * - time_s: when the force was as it is in `force_N` [s]
 * - force_N: sizes of the force [N]; null without a force
 * - notices: what would be done to it on reading
 */
export interface TableLook {
  name: string;
  samples: number;
  duration_s: number;
  rate_hz: number;
  path_m: number[][];
  time_s: number[] | null;
  force_N: number[] | null;
  notices: string[];
}

/** A table does not wait any more: it was taken in, or left. */
export interface TableDone {
  type: "table_done";
  id: string;
}
