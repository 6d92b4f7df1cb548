"""Doing the same to many recordings at once, through joblib, whatever becomes of one of them."""

from collections.abc import Callable, Iterator, Sequence
from typing import Any, TypeVar

Task = TypeVar("Task")
Result = TypeVar("Result")

_RAY_GROUP = 64
"""So many are in work at once on Ray, which gives back no result before all of them are done."""


def one_by_one(
    do: Callable[[Task], Result],
    todo: Sequence[Task],
    jobs: int,
    ended: Callable[[Task], Result],
) -> Iterator[Result]:
    """What becomes of each, in order; workers get paths, never arrays.

    Where a worker ends, what was in work is done once more, each by itself, until the one that
    ends its worker again is found: of that `ended` says the result, and the rest goes on.
    """
    from joblib import Parallel, delayed
    from joblib.externals.loky.process_executor import TerminatedWorkerError

    done = 0
    while done < len(todo):
        try:
            calls = (delayed(do)(task) for task in todo[done:])
            running: Any = Parallel(n_jobs=jobs, return_as="generator")(calls)
            for result in running:
                done += 1
                yield result
        except TerminatedWorkerError:
            for result in _until_one_ends(do, todo[done:], ended):
                done += 1
                yield result


def _until_one_ends(
    do: Callable[[Task], Result], todo: Sequence[Task], ended: Callable[[Task], Result]
) -> Iterator[Result]:
    from joblib.externals.loky.process_executor import TerminatedWorkerError

    for task in todo:
        try:
            # Two jobs, since a single one is done in this process, which is not to end.
            yield from _at_once(do, [task], jobs=2)
        except TerminatedWorkerError:
            yield ended(task)
            return


def in_groups(do: Callable[[Task], Result], todo: Sequence[Task], jobs: int) -> Iterator[Result]:
    """The same where results cannot be given back one by one; what is done is kept by groups."""
    for at in range(0, len(todo), _RAY_GROUP):
        yield from _at_once(do, todo[at : at + _RAY_GROUP], jobs)


def _at_once(do: Callable[[Task], Result], tasks: Sequence[Task], jobs: int) -> Sequence[Result]:
    from joblib import Parallel, delayed

    results: Any = Parallel(n_jobs=jobs)([delayed(do)(task) for task in tasks])
    return results
