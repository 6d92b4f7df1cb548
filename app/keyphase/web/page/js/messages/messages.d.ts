// Made by `make protocol` from the structs in app/keyphase: change those.

import type { ComparisonMessage, LanesMessage } from "./comparison_messages";
import type {
  CamerasMessage,
  MarginMessage,
  PushMessage,
  RecordMessage,
  ReplaySettingsMessage,
  RobotMessage,
  TrialsMessage,
} from "./control_messages";
import type {
  DocumentMessage,
  GhostMessage,
  NothingMessage,
  OthersMessage,
  PlayheadMessage,
  SelectionMessage,
  ShownMessage,
} from "./document_messages";
import type { InTheWayMessage, OffersMessage, Saved } from "./export_messages";
import type { TableDone, TableProposal } from "./import_messages";
import type {
  Following,
  GridMessage,
  Hello,
  Notice,
  Recordings,
  Refused,
  SpreadMessage,
  TaskMessage,
  UploadCancelled,
  UploadReady,
  UploadRefused,
  Uploaded,
} from "./list_messages";
import type { ReplayClosed, ReplayMessage, ReplaySamples } from "./replay_messages";
import type { SignalsHeader } from "./signals_frame";

export type Message =
  | Hello
  | Recordings
  | DocumentMessage
  | NothingMessage
  | GhostMessage
  | SelectionMessage
  | OthersMessage
  | PlayheadMessage
  | ShownMessage
  | Following
  | TaskMessage
  | Notice
  | Refused
  | Saved
  | InTheWayMessage
  | OffersMessage
  | SpreadMessage
  | GridMessage
  | ComparisonMessage
  | LanesMessage
  | UploadReady
  | UploadRefused
  | UploadCancelled
  | Uploaded
  | TableProposal
  | TableDone
  | CamerasMessage
  | RobotMessage
  | RecordMessage
  | ReplaySettingsMessage
  | PushMessage
  | ReplayMessage
  | ReplaySamples
  | ReplayClosed
  | TrialsMessage
  | MarginMessage
  | SignalsHeader;
