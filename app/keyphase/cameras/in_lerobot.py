"""Videos of a LeRobot dataset: v2.1 has a file for each episode, v3.0 many episodes in one file."""

import math
from collections.abc import Iterator, Mapping
from pathlib import Path
from typing import Any

from keyphase.cameras.camera import MAX_NAME_LENGTH, Stretch
from keyphase.errors import CameraError
from keyphase.readers.formats.lerobot import (
    episode_number,
    episode_row,
    info_of,
    inside,
    is_v3,
)

_MAX_CAMERAS = 32


def videos_in_lerobot(path: Path, part: str | None) -> Iterator[Stretch]:
    """The videos of an episode; frame 0 was taken at its time 0, as the format has it.

    Raises DemonstrationError or CameraError where the dataset does not say where they are.
    """
    info, number = info_of(path), episode_number(part)
    features = info.get("features")
    if number is None or not isinstance(features, dict):
        return
    keys = [key for key, one in features.items() if _is_video(one)][:_MAX_CAMERAS]
    if not keys:
        return
    pattern = info.get("video_path")
    if not isinstance(pattern, str):
        raise CameraError(f"{path}: the dataset has videos, but no video_path says where.")
    row = episode_row(path, number, _columns(keys)) if is_v3(info) else None
    for key in keys:
        from_s, to_s, values = _place(info, row, key, number)
        name = key.removeprefix("observation.images.").removeprefix("observation.image.")
        try:
            relative = pattern.format(video_key=key, **values)
        except (KeyError, IndexError, ValueError) as error:
            raise CameraError(f"{path}: video_path {pattern[:100]!r} names no file.") from error
        yield Stretch(name[:MAX_NAME_LENGTH], inside(path, relative), from_s, to_s, 0.0)


def _is_video(feature: object) -> bool:
    return isinstance(feature, dict) and feature.get("dtype") == "video"


def _columns(keys: list[str]) -> list[str]:
    ends = ("chunk_index", "file_index", "from_timestamp", "to_timestamp")
    return [f"videos/{key}/{end}" for key in keys for end in ends]


def _place(
    info: Mapping[str, Any], row: Mapping[str, Any] | None, key: str, number: int
) -> tuple[float, float | None, dict[str, int]]:
    """From when to when in the file, and what its name is made of."""
    if row is None:
        chunk = number // max(int(info.get("chunks_size", 1000)), 1)
        return 0.0, None, {"episode_chunk": chunk, "episode_index": number}
    here = {end: row.get(f"videos/{key}/{end}") for end in ("from_timestamp", "to_timestamp")}
    from_s, to_s = (float(value) if value is not None else math.nan for value in here.values())
    if not 0.0 <= from_s < to_s < 1e7:
        raise CameraError(
            f"{key}: meta/episodes must say from when to when its video lies, but says {here}."
        )
    values = {end: int(row[f"videos/{key}/{end}"]) for end in ("chunk_index", "file_index")}
    return from_s, to_s, values
