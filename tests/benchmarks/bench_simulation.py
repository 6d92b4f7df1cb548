"""How fast the workcells are.

    pytest tests/benchmarks/bench_simulation.py --benchmark-only

Building, which includes the calibration of the wrist sensor, and whole demonstrations with control,
sensor and logging are measured in processor time, as one core spends it.
"""

import time

import numpy as np
import pytest

from keyphase.simulation import RATE_HZ, record, workcell
from keyphase.simulation.demonstrating.lead_through import LeadThrough
from keyphase.simulation.demonstrating.operator import hand_path
from keyphase.simulation.demonstrating.recording import lead, settle

NAMES = ["setup1", "setup2"]
BUILT_WITHIN_S = 0.2
TIMES_REAL_TIME = 10.0


@pytest.mark.benchmark(timer=time.process_time)
@pytest.mark.parametrize("name", NAMES)
def test_building(benchmark, name) -> None:
    cell = workcell(name)
    benchmark.pedantic(cell.build, rounds=10, warmup_rounds=1)
    assert benchmark.stats["mean"] < BUILT_WITHIN_S


@pytest.mark.benchmark(timer=time.process_time)
@pytest.mark.parametrize("name", NAMES)
def test_a_demonstration_against_real_time(benchmark, name) -> None:
    def prepared():
        simulation = workcell(name).build(seed=7)
        random = np.random.default_rng(7)
        return (simulation, hand_path(simulation, settle(simulation, random), random)), {}

    samples = benchmark.pedantic(lead, setup=prepared, rounds=5, warmup_rounds=1)
    simulated_s = len(samples) / RATE_HZ
    benchmark.extra_info["times_real_time"] = simulated_s / benchmark.stats["mean"]
    assert simulated_s / benchmark.stats["mean"] >= TIMES_REAL_TIME


@pytest.mark.parametrize("name", NAMES)
def test_recording_from_a_seed(benchmark, name) -> None:
    benchmark.pedantic(record, args=(name,), kwargs={"seed": 7}, rounds=3, warmup_rounds=1)


def test_a_tick_of_lead_through(benchmark) -> None:
    benchmark(LeadThrough(workcell("setup1")).advance)


def test_the_state_for_a_page(benchmark) -> None:
    benchmark(LeadThrough(workcell("setup2")).state)
