"""The recordings that methods are compared on: made ones of every family, and real ones."""

import json
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path

from keyphase.demonstration import Demonstration
from keyphase.making import FAMILIES, make
from keyphase.readers import read
from keyphase.scoring import Truth, read_truth

FIRST_SEED = 4_000_000
"""Far from the seeds that weights are fitted on."""


@dataclass(frozen=True)
class Recording:
    """A recording with its truth; `set` is a family or the folder of real recordings."""

    set: str
    key: str
    demonstration: Demonstration
    truth: Truth
    made: bool


def made_recordings(count: int, scratch: Path, first: int = FIRST_SEED) -> Iterator[Recording]:
    """`count` of every family; their truth goes through a truth file as anybody's does."""
    for family in FAMILIES:
        made = {f"{family}/{seed}": make(family, seed) for seed in range(first, first + count)}
        path = scratch / "truth.json"
        path.write_text(json.dumps({key: each.truth() for key, each in made.items()}))
        for key, truth in read_truth(path).items():
            yield Recording(family, key, made[key].demonstration, truth, True)


def real_recordings(folder: Path) -> Iterator[Recording]:
    """All of a folder with a truth.json."""
    for key, truth in read_truth(folder / "truth.json").items():
        yield Recording(key.partition("/")[0], key, read(folder / f"{key}.npz"), truth, False)
