// Made by `make protocol` from the structs in app/keyphase: change those.

/**
 * How a person says that a table is to be read; open is what is "", 0 or null.
 * - parts: what each column is
 * - units: of time, length, angle, force, torque, joints and gripper
 * - frame, sign: of the wrench
 * - from_first_s: so long nothing touches the tool at the beginning; the mean is taken out
 */
export interface TableAnswers {
  encoding: string;
  separator: string;
  decimal: "," | ".";
  skip_lines: number;
  header: boolean;
  parts: ("fx" | "fy" | "fz" | "gripper" | "ignore" | "joint" | "nanoseconds" | "pitch" | "qw" | "qx" | "qy" | "qz" | "roll" | "seconds" | "time" | "tx" | "ty" | "tz" | "x" | "y" | "yaw" | "z")[];
  units: { [name: string]: string };
  sequence: string;
  frame: "" | "base" | "tool";
  sign: -1 | 0 | 1;
  rate_hz: number | null;
  from_first_s: number | null;
}

/** Propose how a recording in the list could be read that cannot be read as it is. */
export interface DescribeRequest {
  type: "describe";
  recording: string;
}

/** Tell what these answers would come to. */
export interface DescribeTryRequest {
  type: "describe_try";
  id: string;
  answers: TableAnswers;
}

/** Read the table so, and write the recipe: of this file, or of all tables in its folder. */
export interface DescribeConfirmRequest {
  type: "describe_confirm";
  id: string;
  answers: TableAnswers;
  scope: "file" | "folder";
}

/** Do not read this table after all. */
export interface DescribeLeaveRequest {
  type: "describe_leave";
  id: string;
}
