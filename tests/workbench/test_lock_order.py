"""Locks are taken in one order by all threads, so that no two wait for each other for ever."""

import random
import sys
import threading
from collections import defaultdict
from pathlib import Path
from types import TracebackType

import pytest
from two_pages import TalkingPage, act, workbench_on

import keyphase

HOME = str(Path(keyphase.__file__).parent)


class Watched:
    """Notes which locks a thread holds while it takes a lock, each named by where it is made."""

    def __init__(self) -> None:
        self.after: dict[str, set[str]] = defaultdict(set)
        self._held = threading.local()

    def lock(self, real: object, name: str) -> "WatchedLock":
        return WatchedLock(self, real, name)

    def took(self, name: str) -> None:
        held = self._held.__dict__.setdefault("names", [])
        for other in held:
            if other != name:
                self.after[other].add(name)
        held.append(name)

    def gave_back(self, name: str) -> None:
        names = self._held.names
        del names[len(names) - 1 - names[::-1].index(name)]

    def circles(self) -> list[tuple[str, str]]:
        """Pairs of locks of which either is taken while the other is held."""
        return [(a, b) for a in self.after for b in self.after[a] if a in self._beyond(b)]

    def _beyond(self, name: str) -> set[str]:
        found, waiting = set[str](), [name]
        while waiting:
            for other in self.after.get(waiting.pop(), ()):
                if other not in found:
                    found.add(other)
                    waiting.append(other)
        return found


class WatchedLock:
    """A lock as `with` statements use it; everything else of it is the real one's."""

    def __init__(self, watched: Watched, real: object, name: str) -> None:
        self._watched, self._real, self._name = watched, real, name

    def __enter__(self) -> bool:
        # What would wait for ever is told, too.
        self._watched.took(self._name)
        return self._real.__enter__()  # type: ignore[attr-defined]

    def __exit__(
        self,
        kind: type[BaseException] | None,
        error: BaseException | None,
        trace: TracebackType | None,
    ) -> None:
        self._real.__exit__(kind, error, trace)  # type: ignore[attr-defined]
        self._watched.gave_back(self._name)

    def __getattr__(self, name: str) -> object:
        return getattr(self._real, name)


def _watch(monkeypatch: pytest.MonkeyPatch) -> Watched:
    """Every lock that keyphase makes from here on."""
    watched = Watched()
    for kind in ("Lock", "RLock"):
        real = getattr(threading, kind)

        def made(real: object = real) -> object:
            frame = sys._getframe(1)
            file = frame.f_code.co_filename
            lock = real()  # type: ignore[operator]
            if not file.startswith(HOME):
                return lock
            return watched.lock(lock, f"{file.removeprefix(HOME)}:{frame.f_lineno}")

        monkeypatch.setattr(threading, kind, made)
    return watched


def test_no_two_locks_are_taken_in_both_orders(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    watched = _watch(monkeypatch)
    workbench = workbench_on(tmp_path, "abc")
    pages = [TalkingPage(workbench, f"page {number}") for number in range(2)]
    chance = random.Random(3)
    for _ in range(120):
        act(chance.choice(pages), chance, "x", slow=0.0)
    for page in pages:
        page.document()
    workbench.close()
    assert len(watched.after) > 3
    assert watched.circles() == []
