// Made by `make protocol` from the structs in app/keyphase: change those.

/** Tell which videos there are of a recording that is open. */
export interface CamerasRequest {
  type: "cameras";
  recording: string;
}

/** Look at a recording. */
export interface OpenRequest {
  type: "open";
  id: string;
}

/** Look at a copy of the recording that comes with keyphase. */
export interface OpenDemonstrationRequest {
  type: "open_demonstration";
}

/** See what another page sees; null: no more. */
export interface FollowRequest {
  type: "follow";
  page: string | null;
}

/** Move the playhead. */
export interface SeekRequest {
  type: "seek";
  time_s: number;
}

/** Start, pause, or change how playback runs; backwards below zero. */
export interface PlayRequest {
  type: "play";
  playing: boolean;
  speed?: number;
  loop?: boolean;
}

/** Play what is right before and after a time again and again, until anything else is asked. */
export interface PlayAroundRequest {
  type: "play_around";
  time_s: number;
}

/** Show or hide a part of the scene. */
export interface ShowRequest {
  type: "show";
  what: string;
  visible: boolean;
}

/** Draw in the scene what of the recording's path lies in this time. */
export interface InViewRequest {
  type: "in_view";
  recording: string;
  from_s: number;
  to_s: number;
}

/** Tell how all recordings of the folder stand, now and whenever one changes; or no more. */
export interface GridRequest {
  type: "grid";
  shown: boolean;
}

/** The page has become light or dark. */
export interface ThemeRequest {
  type: "theme";
  dark: boolean;
}

/** Which arm follows the recording, whether the robot can be moved, where it stands. */
export interface RobotRequest {
  type: "robot";
  arm?: string | null;
  moving?: boolean | null;
  place?: "automatically" | null;
}

/** How long it took from an input event to the first frame that shows what it did. */
export interface LatencyRequest {
  type: "latency";
  event: number;
  milliseconds: number;
}

/** A file follows in binary messages. */
export interface UploadRequest {
  type: "upload";
  name: string;
  size: number;
}

/** The file on its way is not wanted after all. */
export interface UploadCancelRequest {
  type: "upload_cancel";
}
