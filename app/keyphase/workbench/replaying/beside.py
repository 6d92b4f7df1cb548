"""Work beside a page that goes on for long, says how far it is, and can be given up."""

import threading
from collections.abc import Callable

from keyphase.workbench.tasks import Task
from keyphase.workbench.telling import Telling
from keyphase.workbench.worker import Worker


class GivenUpError(Exception):
    """A person gave the work up."""


class WorkBeside:
    """One thing at a time, in a thread of its own."""

    def __init__(self, telling: Telling) -> None:
        self._telling = telling
        self._worker = Worker(telling.report)
        self._given_up = threading.Event()

    def begin(
        self, title: str, kind: str, work: Callable[[Task], None], ended: Callable[[str], None]
    ) -> None:
        """Do `work`, the newest of its kind; `ended` is told why where it does not come to its end.

        What it raises is reported.
        """

        def run() -> None:
            self._given_up.clear()
            try:
                with self._telling.tasks.begin(title) as task:
                    work(task)
            except GivenUpError:
                ended("Cancelled.")
            except Exception as error:
                ended(str(error))
                raise

        self._worker.submit(run, kind)

    def go_on(self) -> None:
        """Raise GivenUpError where the work was given up."""
        if self._given_up.is_set():
            raise GivenUpError

    def give_up(self) -> None:
        """Give up what runs; what came of it so far is forgotten."""
        self._given_up.set()

    def stop(self) -> None:
        """End everything."""
        self.give_up()
        self._worker.stop()
