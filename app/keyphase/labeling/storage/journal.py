"""The journal of one recording: every step is on disk before anyone is told that it is done."""

import os
from dataclasses import dataclass
from io import FileIO
from pathlib import Path

from keyphase.demonstration import Demonstration, Source
from keyphase.errors import JournalError
from keyphase.files.writing import write_whole
from keyphase.labeling.document import Document
from keyphase.labeling.storage.journal_lock import JournalLock
from keyphase.labeling.storage.journaled import (
    Journaled,
    changes,
    compact,
    done_record,
    opening,
    replay,
)
from keyphase.labeling.storage.records import ReadRecords, Record, decode, encode
from keyphase.labeling.storage.state_folder import StateFolder, state_folder
from keyphase.segmentation.parameters import Parameters

_SPARE_RECORDS = 200
"""A journal is rewritten on opening when this many records more than needed are in it."""


class Journal:
    """The open journal of a demonstration, and the document it leads to.

    Exactly one process writes a journal; to others it is read-only, and `read_only` says why.
    Close it, or use it in a `with` statement. Not for use by several threads at once.

    document   the document as it is on disk
    done       whether a person has finished with the recording
    changed    the recording's bytes are not those that were labeled; see `keep_labels`
    notices    what a person should know: lines left out, another place for edits, read-only
    """

    def __init__(
        self,
        demonstration: Demonstration,
        shared: Parameters | None = None,
        *,
        read_only: bool = False,
    ) -> None:
        """Open the journal and follow it; it is created by the first step.

        Raises JournalError for a demonstration that was not read from a file, a journal of a
        later version, and where no folder for it can be written.
        """
        self._source = _source(demonstration)
        self._notices: list[str] = []
        self._file: FileIO | None = None
        self._lock: JournalLock | None = None
        self.read_only: str | None = "opened for looking only" if read_only else None
        folder = state_folder(self._source.path.parent, create=not read_only)
        self._path = journal_path(self._source.path, folder.path)
        if folder.notice:
            self._notices.append(folder.notice)
        try:
            self._open(demonstration, shared or Parameters(), folder)
        except BaseException:
            self.close()
            raise

    def __enter__(self) -> "Journal":
        return self

    def __exit__(self, *_: object) -> None:
        self.close()

    @property
    def path(self) -> Path:
        """Where the journal is."""
        return self._path

    @property
    def document(self) -> Document:
        """The document as it is on disk."""
        return self._document

    @property
    def done(self) -> bool:
        """Whether a person has finished with the recording."""
        return self._done

    @property
    def changed(self) -> bool:
        """Whether the recording's bytes are not those that were labeled."""
        return self._labeled_sha256 not in (None, self._source.sha256)

    @property
    def notices(self) -> tuple[str, ...]:
        """What a person should know."""
        return tuple(self._notices)

    def save(self, document: Document) -> None:
        """Put what is new in `document`, made from this journal's, on disk before returning.

        Raises JournalError where the journal is read-only or the disk refuses; then nothing has
        changed.
        """
        before = self._document
        self._append(changes(before.history, document.history, before.next_number))
        self._document = document

    def mark_done(self, done: bool) -> None:
        """Say that a person has, or has not, finished with the recording; on disk on return."""
        self._append([done_record(done)])
        self._done = done

    def keep_labels(self) -> None:
        """Agree to the recording as it is now: the labels are about these bytes."""
        self._append([opening(self._document.demonstration)])
        self._labeled_sha256 = self._source.sha256

    def close(self) -> None:
        """Let another process write."""
        if self._file is not None:
            self._file.close()
            self._file = None
        if self._lock is not None:
            self._lock.release()
            self._lock = None

    def _open(self, demonstration: Demonstration, shared: Parameters, folder: StateFolder) -> None:
        if folder.writable:
            self._take_lock()
        found = folder.newest(self._path.name)
        data = _read(found) if found else b""
        read = decode(data)
        state = replay(read.records)
        torn = read.torn and self.read_only is None
        self._notices += _notices(read, state, found or self._path, torn)
        elsewhere = found is not None and found != self._path
        if self.read_only is None and (elsewhere or _needs_rewriting(read, state)):
            keep_old = elsewhere or bool(read.damaged) or state.refused > 0
            self._rewrite(state, opening(demonstration), keep_old)
        self._document = Document(demonstration, shared, state.history, state.next_number)
        self._done = state.done
        self._labeled_sha256 = state.sha256

    def _take_lock(self) -> None:
        lock = JournalLock(self._path.with_suffix(".lock"))
        try:
            if lock.acquire():
                self._lock = lock
                return
            self.read_only = f"{lock.holder()} is editing {self._source.path.name}"
        except OSError as error:
            self.read_only = f"{self._path.parent} takes no locks ({error.strerror})"
        self._notices.append(f"Opened for looking only: {self.read_only}.")

    def _rewrite(self, state: Journaled, first: Record, keep_old: bool) -> None:
        if keep_old and self._path.exists():
            write_whole(_free_name(self._path), _read(self._path), refusal=JournalError)
        compacted = b"".join(map(encode, compact(state, first)))
        write_whole(self._path, compacted, refusal=JournalError)

    def _append(self, records: list[Record]) -> None:
        if not records:
            return
        if self.read_only is not None:
            raise JournalError(f"Nothing can be changed here: {self.read_only}.")
        try:
            self._write(records)
        except OSError as error:
            raise JournalError(
                f"{self._path}: the edit could not be written and was not made "
                f"({error.strerror}); make room or check the folder."
            ) from error

    def _write(self, records: list[Record]) -> None:
        file = self._opened()
        end = file.seek(0, os.SEEK_END)
        first = [opening(self._document.demonstration)] if end == 0 else []
        try:
            _write_all(file, b"".join(map(encode, [*first, *records])))
            os.fsync(file.fileno())
        except OSError:
            self._cut_back(file, end)
            raise

    def _cut_back(self, file: FileIO, end: int) -> None:
        """Take half a line away, which would make the next one unreadable."""
        try:
            file.truncate(end)
        except OSError as error:
            self.read_only = f"{self._path} can no longer be written ({error.strerror})"

    def _opened(self) -> FileIO:
        if self._file is None:
            is_new = not self._path.exists()
            self._file = FileIO(self._path, "a+")
            if is_new:
                _sync_folder(self._path.parent)
                _sync_folder(self._path.parent.parent)
        return self._file


@dataclass(frozen=True)
class JournalSummary:
    """What a list of recordings shows of a journal."""

    touched: bool
    done: bool


def summarize(recording: Path) -> JournalSummary:
    """What the journal of a recording says, without opening it for writing.

    A journal that cannot be read counts as none; opening it says what is wrong.
    """
    folder = state_folder(recording.parent, create=False)
    path = folder.newest(journal_path(recording, folder.path).name)
    try:
        state = replay(decode(_read(path)).records) if path else Journaled()
    except JournalError:
        state = Journaled()
    return JournalSummary(touched=bool(state.history.done), done=state.done)


def journal_path(recording: Path, folder: Path) -> Path:
    """The journal of a recording in a state folder."""
    return folder / f"{recording.name}.journal"


def _source(demonstration: Demonstration) -> Source:
    if demonstration.source is None:
        raise JournalError(
            f"{demonstration.name}: edits are kept beside a recording on disk, but this one was "
            "never saved; save it first."
        )
    return demonstration.source


def _read(path: Path) -> bytes:
    try:
        return path.read_bytes()
    except OSError as error:
        raise JournalError(
            f"{path}: the journal cannot be read ({error.strerror}); check its permissions."
        ) from error


def _needs_rewriting(read: ReadRecords, state: Journaled) -> bool:
    spare = len(read.records) - len(state.history.steps)
    return not read.clean or spare > _SPARE_RECORDS


def _notices(read: ReadRecords, state: Journaled, path: Path, torn: bool) -> list[str]:
    notices: list[str] = []
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
    return notices


def _free_name(path: Path) -> Path:
    """Where a journal that is replaced is kept as it was."""
    names = (path.with_suffix(f".old-{i}") for i in range(1, 1_000_000))
    return next(name for name in names if not name.exists())


def _write_all(file: FileIO, data: bytes) -> None:
    view = memoryview(data)
    while view:
        view = view[file.write(view) :]


def _sync_folder(folder: Path) -> None:
    descriptor = os.open(folder, os.O_RDONLY)
    try:
        os.fsync(descriptor)
    finally:
        os.close(descriptor)
