"""How long proposals for two hundred recordings of half a minute take, from the command to its end.

    python tests/benchmarks/propose_many.py [--count 200] [--jobs 2]

Recordings are those of the first workcell by a hundred operators, stretched to 30 s at 250 Hz.
Prints the seconds with as many processes as asked for and with one, and whether both wrote the same
bytes; exits with 1 where it took longer than 20 s, or bytes differ.
"""

import argparse
import dataclasses
import os
import subprocess
import sys
import tempfile
import time
from pathlib import Path

import numpy as np

from keyphase.demonstration import Demonstration
from keyphase.readers import save_npz
from keyphase.simulation import record

DURATION_S, RATE_HZ, OPERATORS = 30.0, 250.0, 100
MOST_S = 20.0
RUN = "from keyphase.cli import main; main()"


def main() -> int:
    """Measure, print, judge."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--count", type=int, default=200)
    parser.add_argument("--jobs", type=int, default=2)
    asked = parser.parse_args()
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        _make(folder / "recordings", asked.count + 1)
        taught = folder / "recordings" / "r000.npz"
        _keyphase("segment", str(taught), "--output", str(folder / "taught"))
        took = {jobs: _proposed(folder, jobs) for jobs in (asked.jobs, 1)}
        for jobs, seconds in took.items():
            print(f"{asked.count} recordings, {jobs} at once: {seconds:.1f} s")
        same = _bytes(folder / f"{asked.jobs}") == _bytes(folder / "1")
        print("the same bytes" if same else "other bytes")
    return 0 if same and took[asked.jobs] <= MOST_S else 1


def _make(folder: Path, count: int) -> None:
    folder.mkdir()
    made: list[Demonstration] = []
    for number in range(count):
        if number < OPERATORS:
            made.append(_stretched(record("setup1", seed=number)))
        save_npz(made[number % OPERATORS], folder / f"r{number:03}.npz")


def _stretched(demonstration: Demonstration) -> Demonstration:
    grid = np.arange(0.0, DURATION_S, 1.0 / RATE_HZ)
    share = (demonstration.time_s - demonstration.start_s) / demonstration.duration_s

    def at(values: np.ndarray | None) -> np.ndarray | None:
        if values is None:
            return None
        return np.column_stack([np.interp(grid, DURATION_S * share, one) for one in values.T])

    turned = at(demonstration.orientation_wxyz)
    return dataclasses.replace(
        demonstration,
        time_s=grid,
        position_m=at(demonstration.position_m),
        orientation_wxyz=None
        if turned is None
        else turned / np.linalg.norm(turned, axis=1)[:, None],
        force_N=at(demonstration.force_N),
        torque_Nm=at(demonstration.torque_Nm),
        joints_rad=at(demonstration.joints_rad),
    )


def _proposed(folder: Path, jobs: int) -> float:
    given = ("--from", str(folder / "taught" / "r000.segments.json"), "--jobs", str(jobs))
    began = time.monotonic()
    _keyphase("propose", str(folder / "recordings"), *given, "--output", str(folder / f"{jobs}"))
    return time.monotonic() - began


def _keyphase(*arguments: str) -> None:
    one_thread = {**os.environ, "OMP_NUM_THREADS": "1"}
    subprocess.run(
        [sys.executable, "-c", RUN, *arguments], check=False, capture_output=True, env=one_thread
    )


def _bytes(folder: Path) -> dict[str, bytes]:
    return {path.name: path.read_bytes() for path in sorted(folder.glob("*.segments.json"))}


if __name__ == "__main__":
    sys.exit(main())
