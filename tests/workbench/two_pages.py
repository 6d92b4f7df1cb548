"""Two pages at random on several recordings: what must hold of the journals afterwards."""

import json
import random
import shutil
import threading
import time
from collections import Counter
from collections.abc import Callable
from pathlib import Path
from typing import Any

import msgspec

from keyphase.files.shipped import shipped
from keyphase.labeling.edits import Label
from keyphase.labeling.label import label
from keyphase.labeling.storage.journal import Journal
from keyphase.readers import read
from keyphase.segmentation import Segmenter
from keyphase.web.protocol.conversation import Conversation
from keyphase.workbench.workbench import Settings, Workbench

WAIT_S = 60.0

Message = dict[str, Any]


class TalkingPage:
    """A page without a socket; it knows what it was told last of each kind."""

    def __init__(self, workbench: Workbench, page: str) -> None:
        self.told: dict[str, Message] = {}
        self.refused: list[Message] = []
        self.documents: list[Message] = []
        self.counts: Counter[str] = Counter()
        self._changed = threading.Condition()
        self.conversation = Conversation(
            workbench, page, self._hear, looking=False, latency=lambda _ms: None
        )

    def _hear(self, message: msgspec.Struct | bytes, may_drop: bool = False) -> None:  # noqa: ARG002
        if isinstance(message, bytes):
            return
        told = json.loads(msgspec.json.encode(message))
        with self._changed:
            self.told[told["type"]] = told
            if told["type"] == "refused":
                self.refused.append(told)
            if told["type"] == "document":
                self.documents.append(told)
            self._changed.notify_all()

    def wait_for(self, holds: Callable[[], bool]) -> None:
        """Wait until what was told makes something hold."""
        with self._changed:
            assert self._changed.wait_for(holds, WAIT_S)

    def document(self) -> Message:
        """What is looked at, waited for."""
        self.wait_for(lambda: "document" in self.told)
        return self.told["document"]

    def say(self, kind: str, document: Message | None = None, /, **fields: object) -> None:
        """Say something, about a document as this page saw it."""
        self.counts[kind] += 1
        about = {"recording": document["id"], "revision": document["revision"]} if document else {}
        self.conversation.hear(json.dumps({"type": kind, **about, **fields}))

    def id_of(self, name: str) -> str:
        """The id of a recording."""
        return next(i["id"] for i in self.told["recordings"]["items"] if i["name"] == name)

    def open(self, name: str) -> Message:
        """Look at a recording, and wait for it."""
        self.say("open", id=self.id_of(name))
        self.wait_for(lambda: self.told.get("document", {}).get("name") == name)
        return self.told["document"]


def workbench_on(folder: Path, names: str) -> Workbench:
    """A workbench on copies of one recording."""
    source = shipped("data") / "synthetic_setup1.npz"
    paths = [Path(shutil.copy(source, folder / f"{name}.npz")) for name in names]
    return Workbench(paths, Settings(folder=folder, arms=("left", "right")))


def act(page: TalkingPage, chance: random.Random, own: str, slow: float) -> None:
    """One thing a person might do; labels name the recording they are meant for."""
    document = page.document()
    start_s, end_s = document["start_s"], document["end_s"]
    time_s = chance.uniform(start_s, end_s)
    times = [b["time_s"] for b in document["boundaries"]] or [time_s]
    items = page.told["recordings"]["items"]
    if chance.random() < slow:
        page.say("set", document, parameter="variant", value=chance.choice(["paper", "evidence"]))
        return
    kind = chance.choice(["open", "add", "remove", "move", "label", "label", "undo", "redo",
                          "set", "done", "select", "seek", "reset"])  # fmt: skip
    match kind:
        case "open":
            page.say("open", id=chance.choice(items)["id"])
        case "add":
            page.say("edit", document, edit={"kind": "add", "time_s": time_s})
        case "remove":
            page.say("edit", document, edit={"kind": "remove", "time_s": chance.choice(times)})
        case "move":
            change = {"kind": "move", "from_s": chance.choice(times), "to_s": time_s}
            page.say("edit", document, edit=change)
        case "label":
            name = f"{document['name']} by {own} {page.counts['edit']}"
            page.say("edit", document, edit={"kind": "label", "time_s": time_s, "label": name})
        case "set":
            held = chance.random() < 0.5
            page.say("set", document, parameter="min_distance_s", value=chance.uniform(0.1, 1),
                     held=held)  # fmt: skip
        case "done":
            page.say("done", document, done=chance.random() < 0.5)
        case "select":
            page.say("select", document, segment=None)
        case "seek":
            page.say("seek", time_s=time_s)
        case _:
            page.say(kind, document)


def run_pages(folder: Path, *, actions: int, seed: int, slow: float, names: str = "abcde") -> int:
    """Two pages act at random; the number of actions, once everything holds that must.

    Each recording then is what an offline replay of its journal gives, and every label in it was
    meant for it.
    """
    workbench = workbench_on(folder, names)
    pages = [TalkingPage(workbench, f"page {k}") for k in range(2)]
    for page in pages:
        page.document()

    def work(number: int) -> None:
        chance = random.Random(1000 * seed + number)
        for _ in range(actions):
            act(pages[number], chance, str(number), slow)

    threads = [threading.Thread(target=work, args=(number,)) for number in range(2)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    shown = {}
    for name in names:
        document = pages[0].open(name)
        with workbench.library.at(document["id"]) as desk:
            end = time.monotonic() + WAIT_S
            while not desk.is_free and time.monotonic() < end:
                time.sleep(0.01)
            assert desk.state is not None
            shown[name] = desk.state
    workbench.close()
    for name, state in shown.items():
        check_offline(folder / f"{name}.npz", state)
    return sum(page.counts.total() for page in pages)


def check_offline(path: Path, state: Any) -> None:
    """A recording is what its journal says, and nothing in it was meant for another."""
    demonstration = read(path)
    segmenter = Segmenter(demonstration)
    journal = Journal(demonstration, read_only=True)
    document = journal.document
    found = label(segmenter.segment(document.parameters), document.edits, segmenter.segment_between)
    kept = state.kept_labeling
    assert [(s.start_s, s.end_s, s.label, s.kept) for s in found.segments] == [
        (s.start_s, s.end_s, s.label, s.kept) for s in kept.segments
    ]
    assert document.history == state.document.history
    assert document.parameters == state.document.parameters
    numbers = [step.number for step in document.history.steps]
    assert len(numbers) == len(set(numbers))
    for edit in document.edits.values():
        if isinstance(edit, Label):
            assert edit.label.startswith(f"{path.stem} by ")
