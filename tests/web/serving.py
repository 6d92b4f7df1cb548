"""A server in a process of its own, as users have it."""

import os
import signal
import subprocess
import sys
from collections.abc import Callable, Iterator
from contextlib import AbstractContextManager, contextmanager
from dataclasses import dataclass
from pathlib import Path
from typing import IO
from urllib.parse import parse_qs, urlsplit

from keyphase.web.transport.access import Access


@dataclass(frozen=True)
class Served:
    """What `talking` has to know of a server, and which process it is."""

    port: int
    access: Access
    pid: int


Serving = Callable[[Path], AbstractContextManager[Served]]

_RUN = "from keyphase.cli import main; main()"

_FORK = """
import os, signal, sys
import keyphase.web.server
from keyphase.cli import main
from keyphase.robot.yumi import yumi

yumi()
signal.signal(signal.SIGCHLD, signal.SIG_IGN)
while recording := sys.stdin.readline().strip():
    if os.fork() == 0:
        signal.signal(signal.SIGCHLD, signal.SIG_DFL)
        print(os.getpid(), flush=True)
        main(["open", recording, "--no-browser"])
"""


@contextmanager
def serving(recording: Path) -> Iterator[Served]:
    """`keyphase open` on a recording; killed at the end, whatever it is doing."""
    command = [sys.executable, "-c", _RUN, "open", str(recording), "--no-browser"]
    with subprocess.Popen(command, stdout=subprocess.PIPE, text=True) as process:
        try:
            assert process.stdout is not None
            yield _served(process.stdout, process.pid)
        finally:
            process.kill()


@contextmanager
def many_servings() -> Iterator[Serving]:
    """What does the same as `serving`, faster: a process that has imported everything forks."""
    with subprocess.Popen(
        [sys.executable, "-c", _FORK], stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True
    ) as process:
        asked, told = process.stdin, process.stdout
        assert asked is not None
        assert told is not None

        @contextmanager
        def forked(recording: Path) -> Iterator[Served]:
            print(recording, file=asked, flush=True)
            pid = int(told.readline())
            try:
                yield _served(told, pid)
            finally:
                _kill(pid)

        try:
            yield forked
        finally:
            process.kill()


def _served(told: IO[str], pid: int) -> Served:
    link = urlsplit(told.readline())
    assert link.port is not None
    return Served(link.port, Access("127.0.0.1", parse_qs(link.query)["token"][0]), pid)


def _kill(pid: int) -> None:
    try:
        os.kill(pid, signal.SIGKILL)
    except ProcessLookupError:
        # The test killed it.
        return
