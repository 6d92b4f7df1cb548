"""The journal of one recording: every step is on disk before anyone is told that it is done."""

from dataclasses import replace
from pathlib import Path

from keyphase.demonstration import Demonstration, Source
from keyphase.errors import JournalError
from keyphase.files.writing import write_whole
from keyphase.labeling.document import Document
from keyphase.labeling.storage.elsewhere import Elsewhere, journal_elsewhere, remember_folder
from keyphase.labeling.storage.journal_file import FileChangedError, JournalFile
from keyphase.labeling.storage.journal_lock import JournalLock
from keyphase.labeling.storage.journaled import FORMAT, Journaled, changes, compact, opening
from keyphase.labeling.storage.old_files import keep_as_old, put_back
from keyphase.labeling.storage.read_with import read_otherwise, recipe_of
from keyphase.labeling.storage.readings import Reading, longest_journal, notices_of, read_journal
from keyphase.labeling.storage.records import Record, encode
from keyphase.labeling.storage.state_folder import StateFolder, journal_path, state_folder
from keyphase.segmentation.parameters import Parameters

_SPARE_RECORDS = 200
"""A journal is rewritten on opening when this many records more than needed are in it."""


class Journal:
    """The open journal of a demonstration, and the document it leads to.

    Exactly one process writes a journal; to others it is read-only, and `read_only` says why.
    Close it, or use it in a `with` statement. Not for use by several threads at once.

    document   the document as it is on disk
    changed    the recording's bytes, or the recipe it is read with, are not those that were
               labeled; see `keep_labels`
    elsewhere  what was done to the same bytes under another name, where nothing is done here
    notices    what a person should know: lines left out, another place for edits, read-only,
               another program that changed the journal while it was open
    """

    def __init__(
        self,
        demonstration: Demonstration,
        shared: Parameters | None = None,
        *,
        read_only: bool = False,
    ) -> None:
        """Open the journal and follow it; it is created by the first step.

        Where nothing can be written it is open for looking only. Raises JournalError for a
        demonstration that was not read from a file, and for a journal of a later version.
        """
        self._source = _source(demonstration)
        self._notices: list[str] = []
        self._lock: JournalLock | None = None
        self._closed = False
        self.elsewhere: Elsewhere | None = None
        self.read_only: str | None = "opened for looking only" if read_only else None
        folder = self._folder()
        self._path = journal_path(self._source.path, folder.path)
        self._file = JournalFile(self._path)
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
    def changed(self) -> bool:
        """Whether the recording's bytes, or its recipe, are not those that were labeled."""
        other_bytes = self._labeled_sha256 not in (None, self._source.sha256)
        return other_bytes or read_otherwise(self._recipe, self._source) is not None

    @property
    def notices(self) -> tuple[str, ...]:
        """What a person should know."""
        return tuple(self._notices)

    def save(self, document: Document) -> None:
        """Put what is new in `document`, made from this journal's, on disk before returning.

        Raises JournalError where the journal is closed, read-only or the disk refuses; then
        nothing has changed.
        """
        before = self._document
        self._append(changes(before.history, document.history, before.next_number))
        self._document = document

    def follow_folder(self, shared: Parameters) -> None:
        """Take up what the parameters of the folder have become; nothing is written."""
        self._document = self._document.with_shared(shared)

    def keep_labels(self) -> None:
        """Agree to the recording as it is now: the labels are about these bytes."""
        self._append([opening(self._document.demonstration)])
        self._labeled_sha256 = self._source.sha256
        self._recipe = recipe_of(self._source)

    def take_over(self, elsewhere: Elsewhere) -> None:
        """Make what was done to the same bytes under another name this recording's; that stays.

        Raises JournalError where something was done here already, or it cannot be written.
        """
        if self._document.history.steps or self.read_only is not None or self._closed:
            raise JournalError(
                f"{self._source.path.name}: edits made under another name can be taken over only "
                "where none were made yet and the recording can be changed."
            )
        self._require_lock()
        before = self._document, self._recipe
        self._follow(read_journal(elsewhere.path).state, self._document)
        try:
            self._rewrite(keep_old=True)
        except JournalError:
            self._document, self._recipe = before
            raise
        self.elsewhere = None

    def close(self) -> None:
        """Let another process write; from here on nothing can be changed here."""
        self._closed = True
        self._file.close()
        if self._lock is not None:
            self._lock.release()
            self._lock = None

    def _folder(self) -> StateFolder:
        beside = self._source.path.parent
        try:
            return state_folder(beside, create=self.read_only is None)
        except JournalError as error:
            self._look_only(str(error))
            return state_folder(beside, create=False)

    def _open(self, demonstration: Demonstration, shared: Parameters, folder: StateFolder) -> None:
        if folder.writable:
            self._take_lock()
        followed, others = longest_journal(folder, self._path.name)
        state = followed.state if followed else Journaled()
        if followed:
            torn = followed.read.torn and self.read_only is None
            self._notices += notices_of(followed, others, torn=torn)
        self._follow(state, Document(demonstration, shared))
        if self.read_only is None:
            self._begin(followed)
        if self.read_only is None and not state.history.steps:
            source = self._source
            self.elsewhere = journal_elsewhere(source.path, source.sha256, self._path)

    def _follow(self, state: Journaled, document: Document) -> None:
        self._document = replace(
            document,
            history=state.history,
            next_number=state.next_number,
            own_before=state.own_before,
            done_before=state.done_before,
        )
        self._labeled_sha256, self._recipe = state.sha256, state.recipe
        if (notice := read_otherwise(state.recipe, self._source)) is not None:
            self._notices.append(notice)

    def _begin(self, followed: Reading | None) -> None:
        """Make the file one that can be appended to; where that fails, only look."""
        try:
            if followed and (followed.path != self._path or _needs_rewriting(followed)):
                self._rewrite(keep_old=followed.path != self._path or not _is_sound(followed))
            else:
                self._file.expect(followed.data if followed else b"")
        except (JournalError, OSError) as error:
            self._look_only(str(error))

    def _look_only(self, reason: str) -> None:
        self.read_only = reason
        self._notices.append(f"Opened for looking only: {reason.removesuffix('.')}.")

    def _take_lock(self) -> None:
        lock = JournalLock(self._path.with_suffix(".lock"))
        try:
            if lock.acquire():
                self._lock = lock
                return
            reason = f"{lock.holder()} is editing {self._source.path.name}"
        except OSError as error:
            reason = f"{self._path.parent} takes no locks ({error.strerror})"
        self._look_only(reason)

    def _rewrite(self, keep_old: bool, more: bytes = b"") -> Path | None:
        """Write the whole journal from memory; where the one before is kept."""
        document = self._document
        state = Journaled(
            self._labeled_sha256,
            document.history,
            document.next_number,
            document.own_before,
            document.done_before,
            self._recipe,
        )
        data = b"".join(map(encode, compact(state, opening(document.demonstration)))) + more
        old = keep_as_old(self._path) if keep_old else None
        try:
            write_whole(self._path, data, refusal=JournalError)
        except JournalError:
            if old is not None:
                put_back(old, self._path)
            raise
        self._file.expect(data)
        return old

    def _append(self, records: list[Record]) -> None:
        if not records:
            return
        if self._closed or self.read_only is not None:
            reason = self.read_only or "its journal was closed; open the recording again"
            raise JournalError(f"Nothing can be changed here: {reason}.")
        first = [opening(self._document.demonstration)] if self._file.is_new else []
        if first:
            remember_folder(self._source.path.parent)
        lines = b"".join(map(encode, records))
        try:
            self._require_lock()
            self._file.append(b"".join(map(encode, first)) + lines)
        except FileChangedError as change:
            self._write_again(change.what, lines)
        except OSError as error:
            raise JournalError(
                f"{self._path}: the edit could not be written and was not made "
                f"({error.strerror}); make room or check the folder."
            ) from error

    def _require_lock(self) -> None:
        """The file that is locked may have gone with its folder."""
        if self._lock is not None and self._lock.still_held():
            return
        self._path.parent.mkdir(exist_ok=True)
        lock = JournalLock(self._path.with_suffix(".lock"))
        if not lock.acquire():
            self._look_only(f"{lock.holder()} is editing {self._source.path.name}")
            raise JournalError(f"Nothing can be changed here: {self.read_only}.")
        if self._lock is not None:
            self._lock.release()
        self._lock = lock

    def _write_again(self, what: str, lines: bytes) -> None:
        """Another program changed the file: write it whole from memory, and keep the other."""
        old = self._rewrite(keep_old=True, more=lines)
        kept = f"; the other is kept as {old.name}" if old else ""
        notice = (
            f"Another program touched the journal {self._path} while it was open ({what}). It was "
            f"written again with all edits{kept}."
        )
        if notice not in self._notices:
            self._notices.append(notice)


def _source(demonstration: Demonstration) -> Source:
    if demonstration.source is None:
        raise JournalError(
            f"{demonstration.name}: edits are kept beside a recording on disk, but this one was "
            "never saved; save it first."
        )
    return demonstration.source


def _is_sound(reading: Reading) -> bool:
    """Whether nothing of the file is lost by writing it anew."""
    return not reading.read.damaged and reading.state.refused == 0


def _needs_rewriting(reading: Reading) -> bool:
    spare = len(reading.read.records) - len(reading.state.history.steps)
    old = any(record.get("format", FORMAT) != FORMAT for record in reading.read.records[:1])
    return not reading.read.clean or spare > _SPARE_RECORDS or old
