"""Work on all cores beside a page: one at a time, whichever page asked."""

import threading
from collections.abc import Iterator

import pytest

from keyphase.workbench.replaying.beside import WorkBeside
from keyphase.workbench.tasks import Tasks, TaskState
from keyphase.workbench.telling import Telling

WAIT_S = 10.0


class Works:
    """The work of two pages of one workbench, and what came of it in order."""

    def __init__(self) -> None:
        self.told: list[str] = []
        self._changed = threading.Condition()
        telling = Telling(lambda _level, text: self.say(text), Tasks(self._begun))
        self.first, self.second = WorkBeside(telling), WorkBeside(telling)

    def _begun(self, task: TaskState) -> None:
        self.say(f"task {task.name}")

    def say(self, text: str) -> None:
        with self._changed:
            self.told.append(text)
            self._changed.notify_all()

    def wait_for(self, text: str) -> None:
        with self._changed:
            assert self._changed.wait_for(lambda: text in self.told, WAIT_S), self.told

    def processes(self, name: str) -> Iterator[int]:
        """As joblib's: what is left of them is given up when nobody holds them any more."""
        try:
            while True:
                yield 1
        finally:
            self.say(f"{name} gave its processes up")


@pytest.fixture
def works() -> Iterator[Works]:
    works = Works()
    yield works
    works.first.stop()
    works.second.stop()


def test_who_gives_up_has_let_go_before_the_next_begins(works: Works) -> None:
    goes_on = threading.Event()

    def first(_task: object) -> None:
        held = works.processes("first")
        for _each in held:
            works.say("first")
            assert goes_on.wait(WAIT_S)
            works.first.go_on()

    works.first.begin("first", "trials", first, lambda why: works.say(f"first: {why}"))
    works.wait_for("first")
    works.second.begin("second", "margin", lambda _task: works.say("second"), works.say)
    works.first.give_up()
    goes_on.set()
    works.wait_for("second")
    works.wait_for("first: Cancelled.")
    assert works.told.index("first gave its processes up") < works.told.index("second")
    assert works.told.index("first") < works.told.index("second")


def test_one_that_waits_for_its_turn_can_be_given_up(works: Works) -> None:
    goes_on = threading.Event()

    def first(_task: object) -> None:
        works.say("first")
        assert goes_on.wait(WAIT_S)

    works.first.begin("first", "trials", first, works.say)
    works.wait_for("first")
    works.second.begin("second", "trials", lambda _task: works.say("second"), works.say)
    works.wait_for("task second")
    works.second.give_up()
    works.wait_for("Cancelled.")
    goes_on.set()
    assert "second" not in works.told
