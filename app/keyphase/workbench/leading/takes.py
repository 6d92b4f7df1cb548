"""Recordings made in the page: what they are called, and taking the last one back."""

import threading
from pathlib import Path

from keyphase.errors import SimulationError
from keyphase.labeling.storage.state_folder import state_folder
from keyphase.simulation.demonstrating.recorder import take_of

UNDONE = "undone"
"""Folder for takes that were taken back, beside the labels; nothing in it is ever removed."""


class Takes:
    """The takes of one folder. For many threads."""

    def __init__(self, folder: Path) -> None:
        self.folder = folder
        self._lock = threading.RLock()
        self._named: set[Path] = set()
        self._made: list[Path] = []
        self._undone: list[Path] | None = None

    def next_path(self, workcell: str) -> Path:
        """A name that no recording of the folder has or had: setup1_01.npz, setup1_02.npz, …"""
        with self._lock:
            number = 1
            while self._is_used(path := self.folder / f"{workcell}_{number:02d}.npz"):
                number += 1
            self._named.add(path)
            return path

    def add(self, path: Path) -> None:
        """A recording was made."""
        self._made.append(path)

    @property
    def can_undo(self) -> bool:
        """Whether a take of this server is there to be taken back."""
        return bool(self._made)

    @property
    def can_redo(self) -> bool:
        """Whether a take was taken back, by this server or one before."""
        return bool(self._taken_back())

    def last(self) -> Path:
        """The newest take. Raises SimulationError where there is none."""
        if not self._made:
            raise SimulationError("No take was recorded here yet, so there is none to undo.")
        return self._made[-1]

    def undo(self) -> Path:
        """Move the newest take out of the folder; its former path.

        Raises SimulationError where there is none or it cannot be moved.
        """
        path = self.last()
        hidden = self._hidden_folder() / path.name
        _move(path, hidden)
        self._taken_back().append(hidden)
        return self._made.pop()

    def redo(self) -> Path:
        """Move the take that was taken back last into the folder again; its path.

        Raises SimulationError where there is none or it cannot be moved.
        """
        undone = self._taken_back()
        if not undone:
            raise SimulationError("No take was undone, so there is none to bring back.")
        path = self.folder / undone[-1].name
        _move(undone[-1], path)
        undone.pop()
        self._made.append(path)
        return path

    def _is_used(self, path: Path) -> bool:
        names = (path, take_of(path), self._hidden_folder() / path.name)
        return path in self._named or any(name.exists() for name in names)

    def _taken_back(self) -> list[Path]:
        if self._undone is None:
            found = self._hidden_folder(create=False).glob("*.npz")
            self._undone = sorted(found, key=lambda path: path.stat().st_mtime_ns)
        return self._undone

    def _hidden_folder(self, *, create: bool = True) -> Path:
        folder = state_folder(self.folder, create=create).path / UNDONE
        if create:
            folder.mkdir(exist_ok=True)
        return folder


def _move(path: Path, to: Path) -> None:
    if to.exists():
        raise SimulationError(f"{to} must not exist, but does; move it away and try again.")
    try:
        path.rename(to)
    except OSError as error:
        raise SimulationError(
            f"{path} must be movable to {to.parent}, but is not ({error.strerror}); check both."
        ) from error
