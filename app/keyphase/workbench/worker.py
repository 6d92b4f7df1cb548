"""A worker that computes one thing at a time and of each kind only the newest request."""

import logging
import threading
from collections.abc import Callable

_log = logging.getLogger(__name__)


class Worker:
    """One thread, begun with the first job; `submit` replaces a waiting job of the same kind.

    A slider sends values faster than they can be computed and drawn, and only the last one
    matters; an edit must never be lost, so jobs without a kind all run, in order. `on_idle` is
    called in the thread when nothing more is to be done.
    """

    def __init__(
        self, on_error: Callable[[Exception], object], on_idle: Callable[[], None] = lambda: None
    ) -> None:
        self._on_error, self._on_idle = on_error, on_idle
        self._waiting: dict[object, tuple[Callable[[], None], threading.Event]] = {}
        self._changed = threading.Condition()
        self._stopped = False
        self._running: object = None
        self._thread: threading.Thread | None = None

    def submit(self, job: Callable[[], None], kind: str | None = None) -> threading.Event:
        """Run `job` in the worker's thread; of waiting jobs of one kind only the last runs.

        The event is set when the job has run, or never will.
        """
        over = threading.Event()
        with self._changed:
            key = object() if kind is None else kind
            self._forget(key)
            self._waiting[key] = job, over
            if self._stopped:
                self._forget(key)
            elif self._thread is None:
                self._thread = threading.Thread(target=self._run, name="worker", daemon=True)
                self._thread.start()
            self._changed.notify_all()
        return over

    def wait_until_idle(self, timeout_s: float) -> bool:
        """Whether everything submitted so far has run within `timeout_s`."""
        with self._changed:
            return self._changed.wait_for(
                lambda: not self._waiting and self._running is None, timeout=timeout_s
            )

    def is_free(self, but_for: str | None = None) -> bool:
        """Whether nothing runs or waits, jobs of one kind aside."""
        with self._changed:
            return self._running in (None, but_for) and set(self._waiting) <= {but_for}

    def stop(self) -> None:
        """Finish what runs, forget what waits."""
        with self._changed:
            self._stopped = True
            for key in tuple(self._waiting):
                self._forget(key)
            self._changed.notify_all()

    def join(self) -> None:
        """Wait until what runs has finished, after `stop`."""
        if self._thread is not None and threading.current_thread() is not self._thread:
            self._thread.join()

    def _run(self) -> None:
        while (waiting := self._next()) is not None:
            job, over = waiting
            try:
                job()
            except Exception as error:
                self._on_error(error)
            except BaseException as panic:
                # What panics in an extension is no Exception; the thread must outlive it.
                self._on_error(RuntimeError(f"{type(panic).__name__}: {panic}"))
            over.set()
            with self._changed:
                self._running = None
                idle = not self._waiting
                self._changed.notify_all()
            if idle:
                self._on_idle()

    def _forget(self, key: object) -> None:
        if key in self._waiting:
            self._waiting.pop(key)[1].set()

    def _next(self) -> tuple[Callable[[], None], threading.Event] | None:
        with self._changed:
            self._changed.wait_for(lambda: self._waiting or self._stopped)
            if self._stopped:
                return None
            self._running = next(iter(self._waiting))
            return self._waiting.pop(self._running)
