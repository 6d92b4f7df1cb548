"""How soon the strips of 200 recordings of 30 s are told to a page, from the first and anew; and,
once one of them is done, what is proposed for the others.

python tests/benchmarks/bench_grid.py
"""

import argparse
import sys
import tempfile
import time
from pathlib import Path

import numpy as np

from keyphase.demonstration import Demonstration
from keyphase.files.shipped import shipped
from keyphase.readers import read, save_npz
from keyphase.workbench.workbench import Workbench

sys.path.insert(0, str(Path(__file__).parents[1] / "workbench"))

from test_grid import GridPage

RATE_HZ, LASTS_S = 250.0, 30.0


def made(folder: Path, count: int) -> list[Path]:
    """The bundled demonstration at other paces, with noise of its own."""
    base, random = read(shipped("data") / "setup1.npz"), np.random.default_rng(0)
    assert base.force_N is not None
    time_s = np.arange(0.0, LASTS_S, 1.0 / RATE_HZ)
    at = time_s / LASTS_S * base.duration_s + base.start_s
    position, force = (
        np.column_stack([np.interp(at, base.time_s, column) for column in values.T])
        for values in (base.position_m, base.force_N)
    )
    for number in range(count):
        noise = random.normal(0.0, 0.02, force.shape)
        paced = time_s * random.uniform(0.9, 1.1)
        recording = Demonstration(f"r{number}", paced, position, force_N=force + noise)
        save_npz(recording, folder / f"r{number:03d}.npz")
    return sorted(folder.glob("*.npz"))


def _propose(page: GridPage, count: int) -> None:
    """One is done: print when the first of the others has a proposal, and when all have."""

    def told() -> int:
        items = page.told["recordings"]["items"]
        return sum(bool(one["proposed_from"]) or one["outlier"] for one in items)

    began = time.perf_counter()
    page.say("done", page.document(), done=True)
    page.wait_for(lambda: told() > 0)
    print(f"first proposal {time.perf_counter() - began:.2f} s after one was done")
    while told() < count - 1:
        time.sleep(0.1)
    print(f"all proposals {time.perf_counter() - began:.1f} s after one was done")


def main() -> int:
    """Print when how many were known."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--count", type=int, default=200)
    count = parser.parse_args().count
    with tempfile.TemporaryDirectory() as folder:
        workbench = Workbench(made(Path(folder), count))
        began = time.perf_counter()
        page = GridPage(workbench, "one")
        page.document()
        page.say("grid", shown=True)
        page.wait_for(lambda: bool(page.rows))
        print(f"first rows after {time.perf_counter() - began:.2f} s")
        while any(row["standing"] == "waiting" for row in page.rows.values()):
            time.sleep(0.1)
        print(f"all {count} after {time.perf_counter() - began:.1f} s")
        page.rows.clear()
        began = time.perf_counter()
        page.say("grid", shown=True)
        page.wait_for(lambda: len(page.rows) == count)
        print(f"all told anew in {1e3 * (time.perf_counter() - began):.0f} ms")
        _propose(page, count)
        workbench.close()
    return 0


if __name__ == "__main__":
    sys.exit(main())
