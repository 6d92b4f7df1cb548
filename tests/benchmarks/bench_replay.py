"""A replay against the clock, by processor time on one core: everything it does is logged.

OMP_NUM_THREADS=1 pytest tests/benchmarks/bench_replay.py -o addopts= --benchmark-only
"""

import sys
import time
from pathlib import Path

import pytest

sys.path.insert(0, str(Path(__file__).parents[1] / "simulation"))
from replaying import NAMES, begun, bundled, plan

from keyphase.simulation import Simulation, workcell
from keyphase.simulation.replay.replay import run
from keyphase.skills.library import skills_of

REPLAYED_S = 10.0
ROUNDS = 15


@pytest.mark.benchmark(timer=time.process_time)
@pytest.mark.parametrize("name", NAMES)
def test_a_replay_of_10_s_computes_in_1_s(benchmark, name) -> None:
    """The least of several runs of the same work: what it takes, and not what ran beside it."""
    demonstration = bundled(name)[0]
    skills = skills_of(demonstration, plan(name))

    def built() -> tuple[tuple[Simulation], dict[str, object]]:
        return (workcell(name).build(),), {}

    def replayed_s(simulation: Simulation) -> float:
        return run(simulation, skills, demonstration).duration_s

    replayed = benchmark.pedantic(replayed_s, setup=built, rounds=ROUNDS)
    for statistic in ("min", "median"):
        per_10_s = benchmark.stats[statistic] * REPLAYED_S / replayed
        benchmark.extra_info[f"{statistic} seconds for 10 s of replay"] = round(per_10_s, 3)
    assert benchmark.stats["min"] * REPLAYED_S / replayed < 1.0


@pytest.mark.parametrize("name", NAMES)
def test_stopping_takes_no_longer_than_a_tick(benchmark, name) -> None:
    def prepared():
        replay = begun(name)
        for _ in range(50):
            replay.step()
        return (replay,), {}

    def stop(replay) -> None:
        replay.stop()

    benchmark.pedantic(stop, setup=prepared, rounds=5)
    assert benchmark.stats["max"] < 0.1


@pytest.mark.parametrize("name", NAMES)
def test_a_tick_leaves_time_for_the_page(benchmark, name) -> None:
    replay = begun(name)
    took = []

    def tick() -> None:
        began = time.process_time()
        replay.step()
        took.append(time.process_time() - began)

    benchmark.pedantic(tick, rounds=1000)
    assert sorted(took)[len(took) // 2] < 0.001
