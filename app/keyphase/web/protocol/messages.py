"""Everything the server says to a page; docs/protocol.md and the page's types are made of this."""

from keyphase.web.protocol.comparison_messages import ComparisonMessage, LanesMessage
from keyphase.web.protocol.control_messages import (
    CamerasMessage,
    MarginMessage,
    PushMessage,
    RecordMessage,
    ReplaySettingsMessage,
    RobotMessage,
    TrialsMessage,
)
from keyphase.web.protocol.document_messages import (
    DocumentMessage,
    GhostMessage,
    NothingMessage,
    OthersMessage,
    PlayheadMessage,
    SelectionMessage,
    ShownMessage,
)
from keyphase.web.protocol.export_messages import InTheWayMessage, OffersMessage, Saved
from keyphase.web.protocol.import_messages import TableDone, TableProposal
from keyphase.web.protocol.list_messages import (
    Following,
    GridMessage,
    Hello,
    Notice,
    Recordings,
    Refused,
    SpreadMessage,
    TaskMessage,
    UploadCancelled,
    Uploaded,
    UploadReady,
    UploadRefused,
)
from keyphase.web.protocol.replay_messages import ReplayClosed, ReplayMessage, ReplaySamples

Message = (
    Hello
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
)
