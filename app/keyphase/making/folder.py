"""A folder of made demonstrations: recordings by family, and one truth.json for all of them."""

import json
from collections.abc import Callable, Mapping, Sequence
from pathlib import Path
from typing import Any

from keyphase.errors import MakingError
from keyphase.files.writing import write_whole
from keyphase.making.families import FAMILIES, SINGLE
from keyphase.making.made import Made
from keyphase.making.making import make
from keyphase.readers import npz_data

TRUTH = "truth.json"

Maker = Callable[[str, int], Made]
"""From a family and a seed to a demonstration with its truth."""

Put = Callable[[Path, bytes, str], None]
"""Where a file goes, what it holds, and what it was made from."""

BY_FORMULA: Mapping[str, Maker] = dict.fromkeys([*FAMILIES, *SINGLE], make)
"""The maker of every family of this package."""


def write_over(path: Path, data: bytes, _made_from: str) -> None:
    """A `Put` that replaces what is there."""
    write_whole(path, data, MakingError)


def make_folder(
    families: Sequence[str],
    count: int,
    seed: int,
    output: Path,
    progress: Callable[[int, int], None] | None = None,
    makers: Mapping[str, Maker] = BY_FORMULA,
    put: Put = write_over,
) -> Path:
    """Write `count` demonstrations of each family, seeded from `seed` on, and their truth.json.

    `makers` are who makes which family; others than those by formula live with the simulation.
    `put` writes each file, and may refuse to where one is in the way.
    A recording is FAMILY/SEED.npz below `output`; those that were made there before keep their
    truth. Returns the path of the truth. Raises MakingError
    for an unknown family, a count below one, or a folder that takes no files.
    """
    unknown = [family for family in families if family not in makers]
    if unknown or not families:
        came = ", ".join(unknown) or "none"
        raise MakingError(f"Expected families among {', '.join(makers)}, but got {came}.")
    if count < 1 or seed < 0:
        raise MakingError(f"Expected a count from 1 and a seed from 0, but got {count} and {seed}.")
    truth = _known(output)
    jobs = [(family, seed + k) for family in families for k in range(count)]
    for done, (family, number) in enumerate(jobs, start=1):
        made = makers[family](family, number)
        path = output / family / f"{number}.npz"
        _make_folder(path.parent)
        put(path, npz_data(made.demonstration), f"{family}, seed {number}")
        truth[f"{family}/{number}"] = made.truth()
        if progress:
            progress(done, len(jobs))
    target = output / TRUTH
    put(target, f"{json.dumps(truth, indent=1)}\n".encode(), "made demonstrations")
    return target


def _known(output: Path) -> dict[str, Any]:
    """The truth of recordings that were made in this folder before and are there still."""
    try:
        known = json.loads((output / TRUTH).read_bytes())
    except (OSError, ValueError):
        return {}
    if not isinstance(known, dict):
        return {}
    return {key: truth for key, truth in known.items() if (output / f"{key}.npz").is_file()}


def _make_folder(folder: Path) -> None:
    try:
        folder.mkdir(parents=True, exist_ok=True)
    except OSError as error:
        raise MakingError(
            f"{folder}: expected a folder that takes files, but {error.strerror}; name another."
        ) from error
