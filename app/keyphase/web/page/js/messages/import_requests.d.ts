// Made by `make protocol` from the structs in app/keyphase: change those.

/**
 * How a person says that a recording is to be read; open is what is "", 0 or null.
 * - parts: what each column is
 * - units: of time, length, angle, force, torque, joints and gripper
 * - order, layout: of a quaternion, of a matrix
 * - sequence: of the axes of three angles, or "rotation_vector"
 * - frame, sign: of the wrench
 * - from_first_s: so long nothing touches the tool at the beginning; the mean is taken out
 * - time_format: of a time in words
 * - clocks: the column with the time of a section that has one of its own
 * - sides: to which of two tools each column belongs, if there are two
 * - urdf, tool_frame: of the robot, where joints say where the tool is
 * - torque_sign: of joint torques
 * - preset: what reads the recording but for what that leaves open
 * - text: the recipe itself, where a person has written it
 */
export interface TableAnswers {
  encoding: string;
  separator: string;
  decimal: "," | ".";
  skip_lines: number;
  header: boolean;
  parts: ("demonstration" | "fx" | "fy" | "fz" | "gripper" | "ignore" | "joint" | "nanoseconds" | "pitch" | "pose" | "quaternion" | "qw" | "qx" | "qy" | "qz" | "roll" | "rot6d" | "rotation" | "seconds" | "time" | "tx" | "ty" | "tz" | "x" | "y" | "yaw" | "z")[];
  units: { [name: string]: string };
  order: "" | "wxyz" | "xyzw";
  layout: "" | "column_major" | "row_major";
  sequence: string;
  frame: "" | "base" | "tool";
  sign: -1 | 0 | 1;
  rate_hz: number | null;
  from_first_s: number | null;
  time_format: string;
  clocks: { [name: string]: string };
  sides: string[];
  lines_after_header: number;
  restarts: boolean;
  leave_out_empty: boolean;
  drop_repeated: boolean;
  urdf: string;
  tool_frame: string;
  torque_sign: -1 | 0 | 1;
  preset: string;
  text: string;
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
