"""Work beside a page that goes on for long, says how far it is, and can be given up."""

import threading
import traceback
from collections.abc import Callable, Iterator
from contextlib import contextmanager

from keyphase.workbench.tasks import Task
from keyphase.workbench.telling import Telling
from keyphase.workbench.worker import Worker

_LOOK_S = 0.1


class GivenUpError(Exception):
    """A person gave the work up."""


class WorkBeside:
    """One thing at a time, in a thread of its own, and on all cores when it is its turn."""

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
                with self._telling.tasks.begin(title) as task, self._all_cores():
                    work(task)
            except GivenUpError:
                ended("Cancelled.")
            except Exception as error:
                ended(str(error))
                raise

        self._worker.submit(run, kind)

    @contextmanager
    def _all_cores(self) -> Iterator[None]:
        """Wait until no other page works on all cores; giving up ends the waiting, too."""
        cores = self._telling.tasks.cores
        while not cores.acquire(timeout=_LOOK_S):
            self.go_on()
        try:
            yield
        except Exception as error:
            # What was begun ends with the frames that hold it, which must not be during the next.
            traceback.clear_frames(error.__traceback__)
            raise
        finally:
            cores.release()

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
