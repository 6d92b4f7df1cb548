// Made by `make protocol` from the structs in app/keyphase: change those.

/** The videos of a recording; `refused` says of each that cannot be shown why. */
export interface CamerasMessage {
  type: "cameras";
  recording: string;
  cameras: CameraMessage[];
  refused: string[];
}

/**
 * A video of a recording; its frame k lies at `from_s + k / fps` of the file.
 * - id: the video is at /app/video/ID, in parts
 * - begins_s: when its first frame was taken, on the recording's clock
 */
export interface CameraMessage {
  id: string;
  name: string;
  fps: number;
  frames: number;
  from_s: number;
  begins_s: number;
  width: number;
  height: number;
}

/** Which arm follows the recording, of which that could, and whether it can be moved. */
export interface RobotMessage {
  type: "robot";
  arms: string[];
  arm: string;
  moving: boolean;
}

/**
 * Recording by hand: which workcell is open, and how its take goes.
 * - workcell: name of the open one; null where none is
 * - recorded_s: length of the take so far; null where none is recorded
 * - force_N: what the wrist measures; null where no workcell is open
 * - newest: of a take: where the tool is [m] and the force on it [N], base frame, x y z each
 */
export interface RecordMessage {
  type: "record";
  workcell: string | null;
  choices: WorkcellChoice[];
  recording: boolean;
  recorded_s: number | null;
  force_N: number | null;
  full_force_N: number;
  can_undo: boolean;
  can_redo: boolean;
  newest: [number, number, number, number, number, number] | null;
}

/** A workcell that can be chosen. */
export interface WorkcellChoice {
  name: string;
  title: string;
}

/** The world of the next replay, and what can be chosen. */
export interface ReplaySettingsMessage {
  type: "replay_settings";
  workcell: string;
  part_height_m: number;
  part_aside_m: number;
  friction: number;
  sensor_noise: number;
  end_by: "configuration" | "contact";
  speed: number;
  choices: WorkcellChoice[];
  ends: string[];
  ranges: { [name: string]: [number, number] };
}

/** Whether the gizmo that pushes the tool is shown while a replay runs. */
export interface PushMessage {
  type: "push";
  offered: boolean;
}

/**
 * Trials on the way, or what came of them.
 * - outcome: in one line, once they are over
 * - svg: their picture; null on the way, and where they were cancelled
 */
export interface TrialsMessage {
  type: "trials_run";
  count: number;
  done: number;
  over: boolean;
  title: string;
  outcome: string | null;
  svg: string | null;
}

/**
 * A margin being tried, or what came of it.
 * - done, count: axes of all plans that were tried, and how many there are
 * - outcome: how far the plan reaches beside others, once it is over
 * - svg: its picture; null on the way, and where it was cancelled
 */
export interface MarginMessage {
  type: "margin_run";
  count: number;
  done: number;
  over: boolean;
  title: string;
  outcome: string | null;
  svg: string | null;
}
