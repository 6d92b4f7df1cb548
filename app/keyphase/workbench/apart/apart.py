"""A process beside the server that reads for it; if a file ends it, the next file gets another."""

import os
import pickle
import subprocess
import sys
import threading
from collections.abc import Callable
from contextlib import suppress
from pathlib import Path
from typing import Any, Protocol, TypeVar

import keyphase
from keyphase.errors import DemonstrationError
from keyphase.files.parts import split_part
from keyphase.readers.formats.known import format_of

_CHILD = "keyphase.workbench.apart.child"
_LIBRARY = str(Path(keyphase.__file__).parents[1])


R = TypeVar("R")


class Calls(Protocol):
    """How what reads a file is called: here, or in another process."""

    def __call__(self, path: Path, function: Callable[..., R], /, *given: Any) -> R:
        """What `function(*given)` comes to, which reads the file at `path`."""
        ...


def right_here(_path: Path, function: Callable[..., R], /, *given: Any) -> R:
    """In this process."""
    return function(*given)


class ReadingApart:
    """Reads files of other people's formats, one at a time, in a process of its own.

    What keyphase reads by itself, tables and archives, is read right here. For many threads.
    """

    def __init__(self) -> None:
        self._one_at_a_time = threading.Lock()
        self._child: subprocess.Popen[bytes] | None = None
        self._closed = False

    def begin(self, path: Path) -> None:
        """Start the process, where a file like this would need it, so that it is there by then."""
        if self._is_apart(path):
            with self._one_at_a_time:
                self._living(path)

    def call(self, path: Path, function: Callable[..., R], /, *given: Any) -> R:
        """What `function(*given)` comes to, which reads the file at `path`.

        Raises what it raises, and DemonstrationError where it ended the process.
        """
        if not self._is_apart(path):
            return function(*given)
        with self._one_at_a_time:
            good, answer = self._answer(path, (function, given))
        if not good:
            raise answer
        return answer

    def close(self) -> None:
        """What is being read is broken off."""
        self._closed = True
        if self._child is not None:
            _ended(self._child)

    def _is_apart(self, path: Path) -> bool:
        return bool(sys.executable) and format_of(split_part(path)[0]) is not None

    def _answer(self, path: Path, asked: object) -> tuple[bool, Any]:
        child = self._living(path)
        assert child.stdin is not None
        assert child.stdout is not None
        try:
            pickle.dump(asked, child.stdin)
            child.stdin.flush()
            return pickle.load(child.stdout)
        except (EOFError, OSError, ValueError, pickle.UnpicklingError) as error:
            how = _ended(child)
            self._child = None
            raise DemonstrationError(
                f"{path}: expected a recording, but what reads its format broke off over it "
                f"({how}); it is damaged, or too large for the memory: copy or export it again."
            ) from error

    def _living(self, path: Path) -> "subprocess.Popen[bytes]":
        if self._closed:
            raise DemonstrationError(f"{path}: is not read any more; keyphase is being stopped.")
        if self._child is None or self._child.poll() is not None:
            known = os.pathsep.join(filter(None, (_LIBRARY, os.environ.get("PYTHONPATH"))))
            self._child = subprocess.Popen(
                [sys.executable, "-m", _CHILD],
                stdin=subprocess.PIPE,
                stdout=subprocess.PIPE,
                env={**os.environ, "PYTHONPATH": known},
            )
        return self._child


def _ended(child: "subprocess.Popen[bytes]") -> int:
    """How it ended; it is ended where it did not by itself."""
    child.kill()
    how = child.wait()
    for end in (child.stdin, child.stdout):
        with suppress(OSError):
            if end is not None:
                end.close()
    return how
