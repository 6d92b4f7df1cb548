"""Killing a server while edits stream in, at a random moment, and seeing what is left of them."""

import json
import os
import random
import signal
import time
from dataclasses import dataclass
from pathlib import Path

from serving import Served, Serving
from talking import PageClient
from websockets.exceptions import ConnectionClosed

from keyphase.demonstration import Demonstration
from keyphase.files.shipped import shipped
from keyphase.labeling.edits import Label
from keyphase.labeling.storage.journal import Journal
from keyphase.readers import read, save_npz

_AHEAD = 3
"""So many edits are on their way at once."""


@dataclass(frozen=True)
class Aftermath:
    """Numbers of edits: sent, confirmed to the page, and found on disk (all that are there)."""

    sent: int
    confirmed: int
    found: tuple[str, ...]

    @property
    def is_safe(self) -> bool:
        """Whether what was confirmed is there, in order, and nothing that was not sent."""
        whole = tuple(f"edit {number}" for number in range(len(self.found)))
        return self.found == whole and self.confirmed <= len(self.found) <= self.sent


def write_short_recording(path: Path) -> Path:
    """Every tenth sample of setup 1: what there is to segment costs a server next to nothing."""
    whole = read(shipped("data") / "synthetic_setup1.npz")
    assert whole.force_N is not None
    short = Demonstration(
        path.stem, whole.time_s[::10], whole.position_m[::10], force_N=whole.force_N[::10]
    )
    save_npz(short, path)
    return path


def kill_once(recording: Path, seed: int, serve: Serving) -> Aftermath:
    """Serve a recording, let a page edit it, kill the server, and read the journal again."""
    chance = random.Random(seed)
    with serve(recording) as served:
        sent, confirmed = _edit(served, chance)
    demonstration = read(recording)
    with Journal(demonstration) as journal:
        edits = tuple(journal.document.edits.values())
    labels = tuple(edit.label for edit in edits if isinstance(edit, Label))
    assert len(labels) == len(edits)
    return Aftermath(sent, confirmed, labels)


def _edit(served: Served, chance: random.Random) -> tuple[int, int]:
    """Edit, kill after some edits were confirmed; how many were sent, how many confirmed."""
    confirmed = sent = 0
    with PageClient(served) as page:
        document = page.wait_for("document")
        made_on = {"recording": document["id"], "revision": document["revision"]}
        for _ in range(chance.randrange(1, 25)):
            while sent < confirmed + _AHEAD:
                edit = {"kind": "label", "time_s": 0.1, "label": f"edit {sent}"}
                page.send_raw(json.dumps({"type": "edit", "edit": edit, "event": sent, **made_on}))
                sent += 1
            page.wait_for("document", lambda m: m["cause"] is not None)
            confirmed += 1
        # The moment itself is random, so that it may fall anywhere inside a save.
        time.sleep(chance.uniform(0.0, 0.01))
        os.kill(served.pid, signal.SIGKILL)
        try:
            while True:
                page.wait_for("document", lambda m: m["cause"] is not None)
                confirmed += 1
        except (ConnectionClosed, TimeoutError):
            return sent, confirmed
