"""Videos beside a recording under its name: `run.mp4`, `run.wrist.mp4`, `run_wrist.mp4`."""

import os
from collections.abc import Iterator
from pathlib import Path

from keyphase.cameras.camera import MAX_NAME_LENGTH, Stretch
from keyphase.files.parts import split_part

SUFFIXES = (".mp4", ".m4v", ".mov", ".webm")

_BETWEEN = (".", "_", "-")
_MAX_ENTRIES = 100_000


def videos_beside(recording: Path) -> Iterator[Stretch]:
    """The videos named after a recording; frame 0 is taken to be of its first sample.

    One that is named after a longer name (`run_2.mp4` beside `run.csv` and `run_2.csv`) belongs to
    that one.
    """
    file, part = split_part(recording)
    own = file.stem if part is None else f"{file.stem}.{part}"
    names = _names(file.parent)
    stems = {Path(name).stem for name in names if not name.lower().endswith(SUFFIXES)}
    longer = tuple(stem for stem in stems if len(stem) > len(own) and stem.startswith(own))
    for name in names:
        stem = Path(name).stem
        if not name.lower().endswith(SUFFIXES) or not stem.startswith(own):
            continue
        rest = stem[len(own) :]
        if rest and (rest[0] not in _BETWEEN or any(_is_of(stem, other) for other in longer)):
            continue
        yield Stretch((rest[1:] or "camera")[:MAX_NAME_LENGTH], file.with_name(name))


def _is_of(stem: str, own: str) -> bool:
    return stem == own or (stem.startswith(own) and stem[len(own)] in _BETWEEN)


def _names(folder: Path) -> list[str]:
    """Names in a folder, sorted; of one that holds too many none is looked for."""
    try:
        with os.scandir(folder) as entries:
            found = [entry.name for _, entry in zip(range(_MAX_ENTRIES + 1), entries, strict=False)]
    except OSError:
        return []
    return sorted(found) if len(found) <= _MAX_ENTRIES else []
