"""A server in a process of its own, as users have it."""

import subprocess
import sys
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path
from urllib.parse import parse_qs, urlsplit

from keyphase.web.access import Access


@dataclass(frozen=True)
class Served:
    """What `talking` has to know of a server, and which process it is."""

    port: int
    access: Access
    pid: int


@contextmanager
def serving(recording: Path) -> Iterator[Served]:
    """`keyphase open` on a recording; killed at the end, whatever it is doing."""
    command = [sys.executable, "-c", "from keyphase.cli import main; main()", "open"]
    with subprocess.Popen(
        [*command, str(recording), "--no-browser"], stdout=subprocess.PIPE, text=True
    ) as process:
        try:
            assert process.stdout is not None
            link = urlsplit(process.stdout.readline())
            assert link.port is not None
            access = Access("127.0.0.1", parse_qs(link.query)["token"][0])
            yield Served(link.port, access, process.pid)
        finally:
            process.kill()
