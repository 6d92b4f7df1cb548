"""What a journal on disk says, and which of two that lie in two places is followed."""

from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

from keyphase.errors import JournalError
from keyphase.files.reading import read_regular
from keyphase.labeling.storage.journaled import Journaled, state_after
from keyphase.labeling.storage.records import ReadRecords, decode
from keyphase.labeling.storage.state_folder import StateFolder

_LIMIT_BYTES = 256 * 1024**2


@dataclass(frozen=True, eq=False)
class Reading:
    """A journal as it was read: its bytes, its lines and the state they lead to."""

    path: Path
    data: bytes
    read: ReadRecords
    state: Journaled

    @property
    def length(self) -> tuple[int, int, int]:
        """How much history it holds: steps ever made, steps there, records."""
        state = self.state
        return state.next_number, len(state.history.steps), len(self.read.records)

    def lacks(self, other: "Reading") -> bool:
        """Whether the other holds a step that this one does not."""
        own = {(step.number, step.name) for step in self.state.history.steps}
        return any((s.number, s.name) not in own for s in other.state.history.steps)


def read_journal(path: Path) -> Reading:
    """The journal at a path. Raises JournalError where it cannot be read or is of a later form."""
    try:
        data = read_regular(path, _LIMIT_BYTES)
    except (OSError, ValueError) as error:
        reason = error.strerror if isinstance(error, OSError) else str(error)
        raise JournalError(
            f"{path}: the journal cannot be read ({reason}); check its kind and permissions."
        ) from error
    read = decode(data)
    return Reading(path, data, read, state_after(read.records))


def longest_journal(folder: StateFolder, name: str) -> tuple[Reading | None, list[Reading]]:
    """Of the journals of that name in both places the one with more history, and the others.

    The one in use is followed where both hold as much. Raises JournalError likewise.
    """
    readings = [read_journal(path) for path in folder.both(name)]
    followed = max(readings, key=lambda reading: reading.length, default=None)
    return followed, [reading for reading in readings if reading is not followed]


def notices_of(followed: Reading, others: Sequence[Reading], *, torn: bool) -> list[str]:
    """What a person should know about the journals that were found."""
    notices: list[str] = []
    read, state, path = followed.read, followed.state, followed.path
    if torn:
        notices.append(
            "The last line of the journal was incomplete, as after a crash, and was left out."
        )
    if read.damaged:
        lines = ", ".join(map(str, read.damaged[:5])) + (", …" if len(read.damaged) > 5 else "")
        notices.append(f"Damaged lines of the journal {path} were left out: {lines}.")
    if state.refused:
        notices.append(
            f"{state.refused} records of the journal {path} could not be understood and were left "
            "out."
        )
    for other in others:
        if followed.lacks(other):
            notices.append(
                f"Edits of this recording lie in two places. Those in {path} are followed, because "
                f"they are more ({followed.length[0]} steps); those in {other.path} "
                f"({other.length[0]} steps) are left as they are."
            )
    return notices
