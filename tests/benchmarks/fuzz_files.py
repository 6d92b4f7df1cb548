"""Mutate every kind of file keyphase reads, read it, and count what came.

    python tests/benchmarks/fuzz_files.py --cases 20000

A fault is: an exception that is no KeyphaseError, a process that ends, more than ten seconds of
processor time, more memory than four times the file's size and 64 MB, a reading that differs from
numpy's or the csv module's where both read. Each is printed with the number of its case;
`--first N --cases 1` tries it again, with the same `--only`.
"""

import argparse
import json
import select
import subprocess
import sys
from collections import Counter
from collections.abc import Sequence
from pathlib import Path

WORKER = Path(__file__).with_name("fuzzing") / "worker.py"
WAIT_S = 300.0
"""A case that says nothing for so long waits for something; a busy machine takes less."""
SOUND = ("read", "refused")


def fuzz(
    cases: int, seed: int, first: int = 0, only: Sequence[str] = ()
) -> tuple[Counter[tuple[str, str]], list[str]]:
    """Try cases in warm child processes: how often each kind came out how, and the faults."""
    counts: Counter[tuple[str, str]] = Counter()
    faults: list[str] = []
    at, last = first, first + cases
    while at < last:
        at = _until_it_ends(seed, at, last, counts, faults, only)
    return counts, faults


def _until_it_ends(
    seed: int,
    first: int,
    last: int,
    counts: Counter[tuple[str, str]],
    faults: list[str],
    only: Sequence[str],
) -> int:
    """The case to go on with after the process has ended."""
    command = [sys.executable, str(WORKER), str(seed), str(first), str(last), *only]
    with subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL) as worker:
        begun: dict[str, object] | None = None
        while line := _line(worker):
            said = json.loads(line)
            if "case" in said:
                begun = said
                continue
            _count(begun, said["outcome"], said["said"], counts, faults)
            first, begun = int(str(begun["case"])) + 1, None
        worker.kill()
    if begun is None and first < last:
        raise RuntimeError(f"the worker ended before case {first}")
    if begun is not None:
        status = worker.returncode
        _count(begun, "ended", f"the process ended with {status}", counts, faults)
        first += 1
    return first


def _line(worker: subprocess.Popen[bytes]) -> bytes:
    ready, _, _ = select.select([worker.stdout], [], [], WAIT_S)
    return worker.stdout.readline() if ready else b""


def _count(
    begun: dict[str, object],
    outcome: str,
    said: str,
    counts: Counter[tuple[str, str]],
    faults: list[str],
) -> None:
    counts[str(begun["kind"]), outcome] += 1
    if outcome not in SOUND:
        faults.append(f"case {begun['case']}, {begun['kind']}: {outcome}: {said}")
        print(faults[-1], flush=True)


def main() -> int:
    """Print a table of outcomes and the faults; the exit status says whether there were any."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--cases", type=int, default=20_000)
    parser.add_argument("--seed", type=int, default=0)
    parser.add_argument("--first", type=int, default=0)
    parser.add_argument(
        "--only", nargs="*", default=[], help="kinds of file, as the table names them"
    )
    options = parser.parse_args()
    counts, faults = fuzz(options.cases, options.seed, options.first, options.only)
    kinds = dict.fromkeys(kind for kind, _ in counts)
    print("| kind | cases | read | refused | faults |\n|---|---|---|---|---|")
    for kind in kinds:
        read, refused = (counts[kind, outcome] for outcome in SOUND)
        every = sum(count for (one, _), count in counts.items() if one == kind)
        print(f"| {kind} | {every} | {read} | {refused} | {every - read - refused} |")
    print(f"{sum(counts.values())} cases, {len(faults)} faults")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
