// Made by `make protocol` from the structs in app/keyphase: change those.

import type {
  CompareRequest,
  CutRequest,
  DoneRequest,
  EditRequest,
  ExportRequest,
  ForgetLabelRequest,
  KeepLabelsRequest,
  LanesRequest,
  OffersRequest,
  PhaseForAllRequest,
  PhaseUndoRequest,
  PhasesRequest,
  RedoRequest,
  ResetRequest,
  SelectRequest,
  SetRequest,
  SignalsRequest,
  SpreadRequest,
  TakeJournalRequest,
  TakeOverRequest,
  UndoRequest,
} from "./document_requests";
import type {
  DescribeConfirmRequest,
  DescribeLeaveRequest,
  DescribeRequest,
  DescribeTryRequest,
} from "./import_requests";
import type {
  MarginRequest,
  PushRequest,
  RecordRequest,
  ReplayRequest,
  ReplaySettingsRequest,
  TrialsCancelRequest,
  TrialsRequest,
} from "./replay_requests";
import type {
  CamerasRequest,
  FollowRequest,
  GridRequest,
  InViewRequest,
  LatencyRequest,
  OpenDemonstrationRequest,
  OpenRequest,
  PlayAroundRequest,
  PlayRequest,
  RobotRequest,
  SeekRequest,
  ShowRequest,
  ThemeRequest,
  UploadCancelRequest,
  UploadRequest,
} from "./view_requests";

export type Request =
  | SetRequest
  | ResetRequest
  | EditRequest
  | UndoRequest
  | RedoRequest
  | DoneRequest
  | KeepLabelsRequest
  | TakeJournalRequest
  | ForgetLabelRequest
  | SpreadRequest
  | PhaseForAllRequest
  | PhaseUndoRequest
  | PhasesRequest
  | CompareRequest
  | LanesRequest
  | TakeOverRequest
  | CutRequest
  | OffersRequest
  | ExportRequest
  | SelectRequest
  | SignalsRequest
  | CamerasRequest
  | OpenRequest
  | OpenDemonstrationRequest
  | FollowRequest
  | SeekRequest
  | PlayRequest
  | PlayAroundRequest
  | ShowRequest
  | InViewRequest
  | GridRequest
  | ThemeRequest
  | RobotRequest
  | LatencyRequest
  | ReplayRequest
  | ReplaySettingsRequest
  | PushRequest
  | TrialsRequest
  | TrialsCancelRequest
  | MarginRequest
  | RecordRequest
  | UploadRequest
  | UploadCancelRequest
  | DescribeRequest
  | DescribeTryRequest
  | DescribeConfirmRequest
  | DescribeLeaveRequest;
