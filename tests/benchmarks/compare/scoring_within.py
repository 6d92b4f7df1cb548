"""How right a method is, within a budget of processor time: some would take days."""

import multiprocessing
import resource
from collections.abc import Mapping, Sequence
from dataclasses import dataclass

from methods import METHODS
from samples import RATE_HZ
from sets import Recording

from keyphase.scoring import Tally, judge
from keyphase.scoring.counting import together


@dataclass(frozen=True)
class Judged:
    """The counts of a set, and how many of its recordings were done before time was up."""

    tally: Tally
    done: int
    of: int

    @property
    def whole(self) -> bool:
        """Whether every recording was judged."""
        return self.done == self.of

    @property
    def f1(self) -> float | None:
        """None where the set has no events, or nothing of it was done."""
        return self.tally.f1 if self.done and self.tally.recall is not None else None


def in_turns(recordings: Sequence[Recording]) -> list[Recording]:
    """One of every set, then a second one, and so on: who is stopped has seen of every set."""
    sets: dict[str, list[Recording]] = {}
    for each in recordings:
        sets.setdefault(each.set, []).append(each)
    longest = max((len(group) for group in sets.values()), default=0)
    return [g[turn] for turn in range(longest) for g in sets.values() if turn < len(g)]


def scored(name: str, recordings: Sequence[Recording], budget_s: float) -> dict[str, Judged]:
    """A method of METHODS on every recording, in a process of its own that may take `budget_s`."""
    context = multiprocessing.get_context("fork")
    here, there = context.Pipe(duplex=False)
    worker = context.Process(target=_work, args=(name, recordings, budget_s, there))
    worker.start()
    there.close()
    tallies: dict[str, Tally] = {}
    try:
        while True:
            key, tally = here.recv()
            tallies[key] = tally
    except EOFError:
        worker.join()
    return by_set(recordings, tallies)


def by_set(recordings: Sequence[Recording], tallies: Mapping[str, Tally]) -> dict[str, Judged]:
    """The counts of recordings (by key) added up for each set."""
    sets: dict[str, list[str]] = {}
    for each in recordings:
        sets.setdefault(each.set, []).append(each.key)
    return {
        name: Judged(
            together([tallies[key] for key in keys if key in tallies]),
            sum(key in tallies for key in keys),
            len(keys),
        )
        for name, keys in sets.items()
    }


def _work(name: str, recordings: Sequence[Recording], budget_s: float, answer) -> None:
    find = next(method.find for method in METHODS if method.name == name)
    soft = int(resource.getrusage(resource.RUSAGE_SELF).ru_utime + budget_s) + 1
    resource.setrlimit(resource.RLIMIT_CPU, (soft, soft + 5))
    for each in recordings:
        claims = find(each.demonstration, each.truth, RATE_HZ)
        answer.send((each.key, judge(each.truth.judged, claims).tally))
