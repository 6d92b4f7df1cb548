"""The manifest of a batch: a line for each recording that is done, so that a stopped run goes on.

It lies beside the segment files, one JSON object a line, appended as each is done: the recording,
its size and time of change, the hash of parameters and recipe, the hash of the segment file,
seconds. A recording is done where all of that is still so. A killed run loses no line; one whose
machine stops at most those of the last second, and does these again.
"""

import hashlib
import json
import os
from collections.abc import Mapping
from dataclasses import asdict
from pathlib import Path
from time import monotonic
from typing import Any

from keyphase import __version__
from keyphase.batch.tasks import Refusal, Written
from keyphase.errors import SegmentFileError
from keyphase.files.parts import split_part
from keyphase.readers import own_or_folder_recipe
from keyphase.segmentation.parameters import Parameters

NAME = "keyphase-manifest.jsonl"
_MAX_LINE_LENGTH = 100_000
_SYNC_S = 1.0


def settings_hash(parameters: Parameters, recipe: Path | None, csv: bool) -> str:
    """SHA-256 (hex) of all that shapes a segment file besides its recording."""
    settings = {
        "parameters": asdict(parameters),
        "recipe": None if recipe is None else _hash_of_file(recipe),
        "csv": csv,
        "software": __version__,
    }
    return hashlib.sha256(json.dumps(settings, sort_keys=True).encode()).hexdigest()


class Manifest:
    """What earlier runs into this folder have done; `keep` adds to it."""

    def __init__(self, output: Path, settings: str) -> None:
        self._path = output / NAME
        try:
            output.mkdir(parents=True, exist_ok=True)
        except OSError as error:
            raise SegmentFileError(
                f"{output}: the folder for the segment files cannot be made ({error.strerror}); "
                "choose another one."
            ) from error
        self._settings, self._synced_s = settings, 0.0
        self._done = {str(line["recording"]): line for line in _lines(self._path)}

    def holds(self, task: Written) -> bool:
        """Whether the task is done, under these settings, and nothing has changed since."""
        line = self._done.get(str(task.recording))
        return line is not None and line == {**line, **self._line(task, known_by(task))}

    def keep(self, task: Written) -> None:
        """Write down that the task is done. Raises SegmentFileError where that is impossible."""
        self._append({**self._line(task, task.known_by), "seconds": round(task.seconds, 3)})

    def sync(self) -> None:
        """All that is kept is on the disk. Raises SegmentFileError where that is impossible."""
        self._synced_s = 0.0
        self._write(b"")

    def keep_refusal(self, refusal: Refusal) -> None:
        """Write down that a recording was refused; the next run tries it again."""
        self._append({"recording": str(refusal.path), "refused": refusal.reason})

    def _append(self, line: dict[str, Any]) -> None:
        self._write(json.dumps(line).encode() + b"\n")

    def _write(self, data: bytes) -> None:
        try:
            with self._path.open("ab") as file:
                file.write(data)
                file.flush()
                # The disk is waited for once a second, not for each of thousands of lines.
                if monotonic() - self._synced_s > _SYNC_S:
                    os.fsync(file.fileno())
                    self._synced_s = monotonic()
        except OSError as error:
            raise SegmentFileError(
                f"{self._path}: the manifest cannot be written ({error.strerror}); check the "
                "folder."
            ) from error

    def _line(self, task: Written, known: Mapping[str, Any]) -> dict[str, Any]:
        return {"recording": str(task.recording), "settings": self._settings, **known}


def known_by(task: Written, segment_file: bytes | None = None) -> dict[str, Any]:
    """By what is seen later that recording, recipe and segment file are what they are now.

    `segment_file` are the bytes of the segment file, where they are at hand.
    """
    recording, recipe = split_part(task.recording)[0], own_or_folder_recipe(task.recording)
    return {
        "changed": _stamp(recording),
        "recipe": None if recipe is None else _hash_of_file(recipe),
        "segment_file": (
            _hash_of_file(task.segment_file)
            if segment_file is None
            else hashlib.sha256(segment_file).hexdigest()
        ),
    }


def _stamp(path: Path) -> list[int] | None:
    """Size and time of change; of a folder, of the files right in it."""
    try:
        status = path.stat()
        if path.is_dir():
            inside = [entry.stat().st_mtime_ns for entry in os.scandir(path)]
            return [len(inside), max(inside, default=status.st_mtime_ns)]
        return [status.st_size, status.st_mtime_ns]
    except OSError:
        return None


def _hash_of_file(path: Path) -> str | None:
    try:
        with path.open("rb") as file:
            return hashlib.file_digest(file, "sha256").hexdigest()
    except OSError:
        return None


def _lines(path: Path) -> list[dict[str, Any]]:
    """The lines that can be read; a torn one, left by a kill, is as if it were not there."""
    found = []
    try:
        with path.open("rb") as file:
            while line := file.readline(_MAX_LINE_LENGTH):
                try:
                    content = json.loads(line)
                except (ValueError, RecursionError):
                    continue
                if isinstance(content, dict) and "recording" in content:
                    found.append(content)
    except OSError:
        return []
    return found
