// Made by `make protocol` from the structs in app/keyphase: change those.

/** Begin, steer or end a replay of the plan. */
export interface ReplayRequest {
  type: "replay";
  do: "again" | "hold" | "keep" | "leave" | "next" | "pause" | "release" | "run" | "speed" | "stop";
  speed?: number | null;
}

/** Choose the world of the next replay; what is left out stays as it is. */
export interface ReplaySettingsRequest {
  type: "replay_settings";
  workcell?: string;
  part_height_m?: number;
  part_aside_m?: number;
  friction?: number;
  sensor_noise?: number;
  end_by?: "configuration" | "contact";
  speed?: number;
  seed?: number;
}

/** Show or hide what pushes the tool while a replay runs. */
export interface PushRequest {
  type: "push";
  offered: boolean;
}

/** Run the plan in so many disturbed worlds. */
export interface TrialsRequest {
  type: "trials";
  count: number;
}

/** Give up the trials that run. */
export interface TrialsCancelRequest {
  type: "trials_cancel";
}

/** Try how far the world may differ until the plan fails, or give that up. */
export interface MarginRequest {
  type: "margin";
  do: "begin" | "cancel";
}

/**
 * Open or close a workcell to be led by hand, start or stop a take, take one back. `open` and
 * `start` name the workcell.
 */
export interface RecordRequest {
  type: "record";
  do: "close" | "open" | "redo_take" | "reset" | "start" | "stop" | "undo_take";
  workcell?: string | null;
}
