"""Batches of a thousand: efficiency on two cores, killed and continued, Dask, Ray, and listing.

    python tests/benchmarks/batch_many.py efficiency     # 1 000 recordings on one core and on two
    python tests/benchmarks/batch_many.py killed         # killed in the middle and continued
    python tests/benchmarks/batch_many.py dask           # pip install "keyphase[dask]"
    python tests/benchmarks/batch_many.py ray            # pip install "keyphase[ray]"
    python tests/benchmarks/batch_many.py listing        # a LeRobot dataset of 1 000 episodes

`--count` takes fewer, `--rounds 4` makes them 32 s long. Each prints what was measured and exits
with 1 where it does not hold.
"""

import argparse
import hashlib
import json
import signal
import subprocess
import sys
import tempfile
import time
from pathlib import Path

import numpy as np

LEAST_EFFICIENCY = 0.9
MOST_LISTING_S = 10.0
RUN = "from keyphase.cli import main; main()"


def main() -> int:
    """Run one of the five."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    runs = {
        "efficiency": lambda folder, count: efficiency(folder, count, given.rounds),
        "killed": killed,
        "dask": lambda folder, count: same_bytes(folder, count, "dask"),
        "ray": lambda folder, count: same_bytes(folder, count, "ray"),
        "listing": listing,
    }
    parser.add_argument("what", choices=runs)
    parser.add_argument("--count", type=int, default=1000)
    parser.add_argument("--rounds", type=int, default=1, help="of 8 s, in each recording")
    given = parser.parse_args()
    with tempfile.TemporaryDirectory() as folder:
        return 0 if runs[given.what](Path(folder), given.count) else 1


def recordings(folder: Path, count: int, rounds: int = 1) -> Path:
    """Recordings that differ: a tool goes down, presses, slides, rises; 8 s a round at 250 Hz."""
    from keyphase.demonstration import Demonstration
    from keyphase.readers import save_npz

    folder.mkdir()
    for number in range(count):
        random = np.random.default_rng(number)
        passed = np.arange(2000 * rounds) / 250
        seconds = passed % 8.0
        turns = np.sort(random.uniform(0.8, 7.2, 4))
        height = np.interp(
            seconds, [0, turns[0], turns[1], turns[3], 8], [0.2, 0.2, 0.05, 0.05, 0.2]
        )
        aside = np.interp(seconds, [0, turns[1], turns[2], 8], [0, 0, 0.1, 0.1])
        place = np.stack([0.3 + aside + 0.1 * (passed // 8.0), 0 * seconds, height], axis=1)
        force = random.normal(0, 0.1, place.shape)
        force[(seconds > turns[1]) & (seconds < turns[3]), 2] += 6.0
        name = f"run_{number:04d}"
        save_npz(Demonstration(name, passed, place, force_N=force), folder / f"{name}.npz")
    return folder


def efficiency(folder: Path, count: int, rounds: int) -> bool:
    """How much of two cores is work: all of them on one core, and on two.

    Beside it what the machine itself gives: two programs at once that know nothing of each other,
    with half of the recordings each.
    """
    data = recordings(folder / "data", count, rounds)
    one = segmented(data, folder / "one", jobs=1) / count
    two = segmented(data, folder / "two", jobs=2) / count
    found, most = one / (2 * two), one / (2 * apart(data, folder, count))
    print(
        f"{1e3 * one:.0f} ms each on one core, {1e3 * two:.0f} ms on two: {found:.0%} efficiency; "
        f"two programs with half of them each: {most:.0%}"
    )
    return found >= LEAST_EFFICIENCY


def apart(data: Path, folder: Path, count: int) -> float:
    """Seconds for each recording of two programs at once, beyond the start of the interpreter."""
    command = [sys.executable, "-c", RUN, "segment", str(data), "--jobs", "1"]
    begun = time.perf_counter()
    halves = [
        subprocess.Popen(
            [*command, "--output", str(folder / f"half{half}"), "--shard", f"{half}/2"],
            stdout=subprocess.DEVNULL,
            stderr=subprocess.DEVNULL,
        )
        for half in (1, 2)
    ]
    for half in halves:
        assert half.wait() == 0
    return (time.perf_counter() - begun) / count


def segmented(data: Path, output: Path, *options: str, jobs: int = 2) -> float:
    """Seconds that `keyphase segment` takes, without starting the interpreter."""
    from keyphase.batch.segmenting import segment_all

    named = dict(zip(options[::2], options[1::2], strict=True))
    begun = time.perf_counter()
    report = segment_all([data], output, jobs=jobs, **named)
    assert not report.refused, report.refused[:3]
    return time.perf_counter() - begun


def killed(folder: Path, count: int) -> bool:
    """A run killed when half is done leaves that half, and the next does the other half only."""
    data, output = recordings(folder / "data", count), folder / "out"
    command = [sys.executable, "-c", RUN, "segment", str(data), "--output", str(output)]
    running = subprocess.Popen(
        [*command, "--jobs", "2"], stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL
    )
    while len(done(output)) < count // 2 and running.poll() is None:
        time.sleep(0.05)
    running.send_signal(signal.SIGKILL)
    running.wait()
    before = {name: (output / name).stat().st_mtime_ns for name in done(output)}
    begun = time.perf_counter()
    subprocess.run(
        [*command, "--jobs", "2"], check=True, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL
    )
    seconds = time.perf_counter() - begun
    again = [name for name, at in before.items() if (output / name).stat().st_mtime_ns != at]
    files = list(output.glob("*.segments.json"))
    print(
        f"killed after {len(before)} of {count}, continued in {seconds:.0f} s: {len(files)} files, "
        f"{len(again)} done twice"
    )
    return len(files) == count and not again and 0 < len(before) < count


def done(output: Path) -> list[str]:
    """Names of the segment files that the manifest says are done."""
    manifest = output / "keyphase-manifest.jsonl"
    lines = manifest.read_bytes().splitlines() if manifest.exists() else []
    found = []
    for line in lines:
        try:
            found.append(f"{Path(json.loads(line)['recording']).stem}.segments.json")
        except ValueError:
            continue
    return found


def same_bytes(folder: Path, count: int, backend: str) -> bool:
    """A local cluster writes the bytes that this machine's cores write."""
    data = recordings(folder / "data", count)
    cores = segmented(data, folder / "cores")
    cluster = segmented(data, folder / backend, "backend", backend)
    hashes = [
        {path.name: hashlib.sha256(path.read_bytes()).hexdigest() for path in one.glob("*.json")}
        for one in (folder / "cores", folder / backend)
    ]
    same = hashes[0] == hashes[1] and len(hashes[0]) == count
    print(f"{count} on cores {cores:.0f} s, on {backend} {cluster:.0f} s; identical bytes: {same}")
    return same


def listing(folder: Path, count: int) -> bool:
    """A LeRobot dataset of many episodes is listed in seconds."""
    sys.path.insert(0, str(Path(__file__).parents[1] / "writers"))
    import lerobot_datasets

    from keyphase.readers import find_recordings

    lerobot_datasets.EPISODES = count
    lerobot_datasets.dataset(folder)
    begun = time.perf_counter()
    found = find_recordings([folder])
    seconds = time.perf_counter() - begun
    print(f"{len(found)} episodes listed in {seconds:.2f} s")
    return len(found) == count and seconds < MOST_LISTING_S


if __name__ == "__main__":
    sys.exit(main())
