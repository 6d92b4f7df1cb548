"""Killing a program that edits, at a random moment, and seeing what is left of its edits."""

import random
import subprocess
import sys
import time
from dataclasses import dataclass
from pathlib import Path

from handmade import demonstration
from journal_writer import digest

from keyphase.labeling.storage.journal import Journal

_WRITER = Path(__file__).with_name("journal_writer.py")


@dataclass(frozen=True)
class Aftermath:
    """What a killed writer had confirmed, what it was about to save, and what is on disk."""

    confirmed: str
    next: str | None
    found: str
    saves: int

    @property
    def is_safe(self) -> bool:
        """Whether everything confirmed is there, and at most the one edit under way."""
        return self.found == self.confirmed or self.found == self.next


def kill_once(recording: Path, seed: int) -> Aftermath:
    """Let a writer edit a recording, kill it at a random moment, and read the journal again."""
    chance = random.Random(seed)
    arguments = [sys.executable, str(_WRITER), str(recording), str(seed)]
    with subprocess.Popen(arguments, stdout=subprocess.PIPE, text=True) as writer:
        assert writer.stdout is not None
        said = [writer.stdout.readline() for _ in range(chance.randrange(1, 60))]
        # The moment itself is random, so that it may fall anywhere inside a save.
        time.sleep(chance.uniform(0.0, 0.003))
        writer.kill()
        said += writer.stdout.readlines()
    words = [line.split() for line in said if line.endswith("\n")]
    done = [what for word, what in words if word == "done"]
    with Journal(demonstration(path=recording)) as journal:
        found = digest(journal.document)
    return Aftermath(
        confirmed=done[-1],
        next=words[-1][1] if words[-1][0] == "next" else None,
        found=found,
        saves=len(done) - 1,
    )
