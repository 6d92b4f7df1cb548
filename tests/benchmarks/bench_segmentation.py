"""How fast segmentation is, as ratios measured within one run.

    pytest tests/benchmarks --benchmark-only -o python_files='bench_*.py'

Every benchmark asserts its bar and puts its figures into `extra_info`.
"""

import time
import tracemalloc
import warnings
from collections.abc import Callable
from functools import cache

import numpy as np
import pytest
from sklearn.mixture import GaussianMixture

import synthetic
from keyphase.demonstration import Demonstration
from keyphase.segmentation import Parameters, Segmenter, segment
from keyphase.segmentation.paper.force import normalized_error

RATE_HZ = round(synthetic.RATE_HZ)
THRESHOLDS = np.linspace(0.02, 0.98, 41)


@cache
def recording(seconds: float) -> Demonstration:
    """Setup 1 over and over with forces, the tool lifted and brought back in between."""
    samples = round(seconds * RATE_HZ)
    position, force, seed = [np.zeros((0, 3))], [np.zeros((0, 3))], 7000
    back = synthetic.minimum_jerk(np.arange(1, RATE_HZ + 1) / RATE_HZ)[:, None]
    while sum(map(len, position)) < samples:
        made = synthetic.setup1(seed, "real", forces=True).demonstration
        assert made.force_N is not None
        there = made.position_m - made.position_m[0]
        noise = np.random.default_rng(seed).normal(size=(RATE_HZ, 3)) * 0.15
        position += [there, there[-1] * (1.0 - back)]
        force += [made.force_N, noise]
        seed += 1
    joined = np.concatenate(position)[:samples]
    return Demonstration(
        f"setup1_for_{seconds:g}_s",
        np.arange(samples) / RATE_HZ,
        joined,
        force_N=np.concatenate(force)[:samples],
    )


def pose_and_wrench(samples: int) -> Demonstration:
    """The same at 1 kHz, with the orientation and the torque about a lever of 0.1 m."""
    slow = recording(samples / 1000.0 + 1.0)
    assert slow.force_N is not None
    time_s = np.arange(samples) / 1000.0
    rng = np.random.default_rng(0)

    def at_1_khz(values: np.ndarray) -> np.ndarray:
        return np.stack([np.interp(time_s, slow.time_s, column) for column in values.T], axis=1)

    force = at_1_khz(slow.force_N) + 0.05 * rng.normal(size=(samples, 3))
    half = 0.15 * np.sin(0.2 * time_s)
    zero = np.zeros(samples)
    return Demonstration(
        f"{samples}_samples",
        time_s,
        at_1_khz(slow.position_m),
        np.stack([np.cos(half), np.sin(half), zero, zero], axis=1),
        force,
        np.stack([-0.1 * force[:, 1], 0.1 * force[:, 0], zero], axis=1),
    )


def size_bytes(demonstration: Demonstration) -> int:
    """Bytes of a recording's own arrays."""
    it = demonstration
    arrays = (it.time_s, it.position_m, it.orientation_wxyz, it.force_N, it.torque_Nm)
    return sum(array.nbytes for array in arrays if array is not None)


def seconds(run: Callable[[], object], repeats: int) -> float:
    """Least processor time of several runs [s]; wall time counts other programs, too."""
    taken = []
    for _ in range(repeats):
        start = time.process_time()
        run()
        taken.append(time.process_time() - start)
    return min(taken)


def test_the_filter_is_a_hundred_times_faster_than_filterpy(benchmark):
    rng = np.random.default_rng(0)
    measured = np.cumsum(rng.normal(size=(10_000, 6)), axis=0) * 0.1
    noise = np.full(6, 0.01)
    benchmark(normalized_error, measured, noise)
    ours = seconds(lambda: normalized_error(measured, noise), 20)
    theirs = seconds(lambda: normalized_error(measured, noise, engine="filterpy"), 2)
    benchmark.extra_info.update(ours_ms=1e3 * ours, filterpy_ms=1e3 * theirs, ratio=theirs / ours)
    assert theirs / ours >= 100


def test_segment_is_ten_times_faster_than_a_scikit_learn_sweep(benchmark):
    made = recording(10.0)
    samples = np.column_stack([made.time_s, made.position_m])

    def sweep(starts: int) -> None:
        for count in range(1, 16):
            mixture = GaussianMixture(count, n_init=starts, random_state=0)
            with warnings.catch_warnings():
                warnings.simplefilter("ignore")
                mixture.fit(samples).bic(samples)

    benchmark(segment, made)
    ours = seconds(lambda: segment(made), 10)
    one, ten = seconds(lambda: sweep(1), 1), seconds(lambda: sweep(10), 1)
    benchmark.extra_info.update(
        ours_ms=1e3 * ours, one_start_ratio=one / ours, ten_starts_ratio=ten / ours
    )
    assert ten / ours >= 10


@pytest.mark.parametrize(("samples", "most_ms"), [(2_500, 2.0), (1_000_000, 5.0)])
def test_a_threshold_gives_new_segments_at_once(benchmark, samples, most_ms):
    segmenter = Segmenter(recording(samples / RATE_HZ))
    segmenter.segment()
    thresholds = iter(np.tile(THRESHOLDS, 10_000).tolist())

    def move() -> None:
        segmenter.segment(Parameters(force_threshold=next(thresholds)))

    first = [seconds(move, 1) for _ in THRESHOLDS]
    benchmark.pedantic(move, rounds=len(THRESHOLDS) * 3, warmup_rounds=0)
    again = [seconds(move, 1) for _ in THRESHOLDS]
    found = segmenter.segment()
    benchmark.extra_info.update(
        samples=samples,
        boundaries=len(found.boundaries),
        first_visit_median_ms=1e3 * float(np.median(first)),
        first_visit_worst_ms=1e3 * max(first),
        revisit_median_ms=1e3 * float(np.median(again)),
    )
    assert 1e3 * np.median(first) <= most_ms
    assert 1e3 * np.median(again) <= most_ms


def mean_seconds(run: Callable[[], object], in_all: float) -> float:
    """Mean processor time [s] of as many runs as take `in_all` seconds together."""
    start, runs = time.process_time(), 0
    while (taken := time.process_time() - start) < in_all:
        run()
        runs += 1
    return taken / runs


def test_time_grows_no_faster_than_the_recording_and_memory_stays_small(benchmark):
    """Processors change their speed within seconds: the lengths take turns, and means of equally
    long stretches of work are compared."""
    lengths = (10.0, 60.0, 600.0, 3600.0)
    rounds = [
        {length: mean_seconds(lambda at=length: segment(recording(at)), 6.0) for length in lengths}
        for _ in range(3)
    ]
    growth = float(np.median([taken[3600.0] / taken[10.0] / 360.0 for taken in rounds]))
    benchmark.pedantic(segment, args=(recording(3600.0),), rounds=1)
    tracemalloc.start()
    segment(recording(3600.0))
    _, peak = tracemalloc.get_traced_memory()
    tracemalloc.stop()
    memory = peak / size_bytes(recording(3600.0))
    benchmark.extra_info.update(
        {
            f"{length:g}_s_ms": 1e3 * float(np.median([taken[length] for taken in rounds]))
            for length in lengths
        },
        growth_over_linear=growth,
        peak_memory_over_recording=memory,
    )
    assert growth <= 1.0
    assert memory < 4.0


def test_an_hour_at_1_khz_costs_what_its_samples_cost(benchmark):
    """Pose and wrench: processor time by length, in turns, and what is held in memory at most."""
    counts = (100_000, 1_000_000, 3_600_000)
    recordings = {count: pose_and_wrench(count) for count in counts}
    segment(recordings[counts[0]])
    taken = [
        {count: seconds(lambda at=count: segment(recordings[at]), 1) for count in counts}
        for _ in range(3)
    ]
    least = {count: min(each[count] for each in taken) for count in counts}
    longest = recordings[counts[-1]]
    benchmark.pedantic(segment, args=(longest,), rounds=1)
    tracemalloc.start()
    segment(longest)
    _, peak = tracemalloc.get_traced_memory()
    tracemalloc.stop()
    growth = least[counts[-1]] / least[counts[1]] / (counts[-1] / counts[1])
    benchmark.extra_info.update({f"{count}_samples_s": least[count] for count in counts})
    benchmark.extra_info.update(
        growth_over_linear=growth,
        peak_MB=peak / 1e6,
        with_the_recording_MB=(peak + size_bytes(longest)) / 1e6,
    )
    assert growth <= 1.2
    assert peak + size_bytes(longest) < 1e9
