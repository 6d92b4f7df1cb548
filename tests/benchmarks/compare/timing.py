"""How long each method takes for 10 s, 100 s and 1 h, each in a process of its own with an end.

Of means at 25 Hz, as accuracy is judged, and of every sample, as keyphase and the paper see them.
"""

import multiprocessing
import resource
import time
from collections.abc import Callable
from functools import cache
from queue import Empty

import numpy as np
from methods import METHODS
from samples import RATE_HZ as MEANS_HZ

from keyphase.demonstration import Demonstration
from keyphase.making import make
from keyphase.scoring import Truth

LENGTHS_S = (10.0, 100.0, 3600.0)
ENOUGH_S = 0.5
RATE_HZ = 250.0
RATES_HZ = (MEANS_HZ, RATE_HZ)
LIMIT_BYTES = 4 << 30


@cache
def long_demonstration(seconds: float) -> tuple[Demonstration, Truth]:
    """Made demonstrations of the family mixed, one after the other, at 250 Hz, and their events.

    After two minutes of them it begins again from where the tool then is.
    """
    position, force, events_s = _two_minutes()
    times = int(np.ceil(seconds * RATE_HZ / len(position)))
    count = round(seconds * RATE_HZ)
    places = np.concatenate([position + k * position[-1] for k in range(times)])
    joined = Demonstration(
        f"mixed_for_{seconds:g}_s",
        np.arange(count) / RATE_HZ,
        places[:count],
        force_N=np.tile(force, (times, 1))[:count],
    )
    again = [k * len(position) / RATE_HZ + time for k in range(times) for time in events_s]
    return joined, Truth(tuple(t for t in again if t < seconds - 0.5), (), 0.15)


def timed(method: str, seconds: float, rate_hz: float, limit_s: float) -> float | str:
    """Processor seconds with means at `rate_hz`, or why there are none: more than the limit, or
    more memory."""
    long_demonstration(seconds)
    context = multiprocessing.get_context("fork")
    answer = context.Queue()
    worker = context.Process(target=_work, args=(method, seconds, rate_hz, limit_s, answer))
    worker.start()
    while worker.is_alive():
        try:
            return answer.get(timeout=0.5)
        except Empty:
            continue
    return answer.get(timeout=1.0) if not answer.empty() else f"> {limit_s:.0f} s"


@cache
def _two_minutes() -> tuple[np.ndarray, np.ndarray, list[float]]:
    position, force, events, seed, done = [], [], [], 5_000_000, 0.0
    at = np.zeros(3)
    while done < 120.0:
        made = make("mixed", seed)
        each = made.demonstration
        seed += 1
        time_s = np.arange(each.start_s, each.end_s, 1.0 / RATE_HZ)
        moved = _at(time_s, each.time_s, each.position_m)
        position.append(moved - moved[0] + at)
        at = position[-1][-1]
        assert each.force_N is not None
        force.append(_at(time_s, each.time_s, each.force_N - np.median(each.force_N, axis=0)))
        events += [done + event.time_s - each.start_s for event in made.events]
        done += len(time_s) / RATE_HZ
    return np.concatenate(position), np.concatenate(force), events


def _work(name: str, seconds: float, rate_hz: float, limit_s: float, answer) -> None:
    find = next(method.find for method in METHODS if method.name == name)
    demonstration, truth = long_demonstration(seconds)
    small, small_truth = long_demonstration(5.0)
    find(small, small_truth, rate_hz)
    resource.setrlimit(resource.RLIMIT_AS, (LIMIT_BYTES, LIMIT_BYTES))
    soft = int(time.process_time() + limit_s) + 1
    resource.setrlimit(resource.RLIMIT_CPU, (soft, soft + 5))
    try:
        answer.put(_mean(lambda: find(demonstration, truth, rate_hz)))
    except MemoryError:
        answer.put(f"> {LIMIT_BYTES >> 30} GB")


def _mean(run: Callable[[], object]) -> float:
    """Mean of as many runs as take half a second: clocks of processor time are coarse."""
    start, runs, taken = time.process_time(), 0, 0.0
    while taken < ENOUGH_S:
        run()
        runs += 1
        taken = time.process_time() - start
    return taken / runs


def _at(time_s: np.ndarray, stamps: np.ndarray, values: np.ndarray) -> np.ndarray:
    return np.stack([np.interp(time_s, stamps, column) for column in values.T], axis=1)
