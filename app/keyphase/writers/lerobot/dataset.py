"""A LeRobot dataset that is being changed: its info, its data files, and where its episodes are."""

import json
from collections.abc import Callable, Iterator, Mapping
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from keyphase.errors import ExportError
from keyphase.files.writing import write_whole
from keyphase.readers.formats.damage import what_is_wrong
from keyphase.readers.formats.lerobot import INFO, file_of_episode, is_lerobot
from keyphase.writers.packages import package

EXTRA = "lerobot"
TEMPORARY_SUFFIX = ".parquet.keyphase"


@dataclass(frozen=True, eq=False)
class Dataset:
    """The copy of a dataset at `path`, and what its `meta/info.json` says."""

    path: Path
    info: dict[str, Any]

    @property
    def is_v3(self) -> bool:
        """Whether many episodes share a file, and `meta/episodes` says where each is."""
        return str(self.info.get("codebase_version", "")).startswith("v3")

    @property
    def has_videos(self) -> bool:
        """Whether any feature is a video."""
        features = self.info["features"].values()
        return any(isinstance(one, dict) and one.get("dtype") == "video" for one in features)

    def write_info(self, **changes: Any) -> None:
        """Write `meta/info.json` with these changes."""
        text = json.dumps({**self.info, **changes}, indent=4, ensure_ascii=False)
        write_whole(self.path / INFO, text.encode(), refusal=ExportError)

    def data_files(self) -> list[Path]:
        """Every file of frames, in the order of episodes."""
        return sorted((self.path / "data").rglob("*.parquet"))

    def timestamps(self, number: int) -> NDArray[np.float32]:
        """The timestamps of an episode's frames, as they are stored."""
        parquet = package("pyarrow.parquet", EXTRA)
        file = file_of_episode(self.path, self.info, number)
        table = parquet.read_table(
            file,
            columns=["episode_index", "timestamp"],
            filters=[("episode_index", "=", number)],
        )
        times = table["timestamp"].to_numpy()
        if not len(times) or times.dtype != np.float32:
            raise ExportError(
                f"{self.path}: expected float32 timestamps of episode {number}, but found "
                f"{len(times)} of {times.dtype}; convert the dataset with lerobot."
            )
        return times


def opened(path: Path) -> Dataset:
    """The dataset at `path`. Raises ExportError where it is none."""
    if not is_lerobot(path):
        raise ExportError(
            f"{path}: expected a LeRobot dataset, since LeRobot is written into a copy of the "
            "dataset that was recorded; choose another format for this recording."
        )
    info = json.loads((path / INFO).read_bytes())
    if not isinstance(info.get("features"), dict):
        raise ExportError(f"{path}: its {INFO} names no features; export the dataset again.")
    return Dataset(path, info)


@contextmanager
def damage_told(path: Path) -> Iterator[None]:
    """Turn what pyarrow and damaged metadata raise into an ExportError."""
    arrow = package("pyarrow", EXTRA)
    try:
        yield
    except (arrow.ArrowException, OSError, KeyError, ValueError, TypeError, IndexError) as error:
        raise ExportError(
            f"{path}: expected a whole LeRobot dataset, but it cannot be written into "
            f"({what_is_wrong(path, error)}); copy it again."
        ) from error


def rewrite(file: Path, change: Callable[[Any], Any]) -> None:
    """Change a Parquet file group by group, so that memory holds one; groups stay as they are.

    The description of columns that Hugging Face keeps in the file goes, since it would not know
    new ones; readers then take that in `meta/info.json`.
    """
    parquet = package("pyarrow.parquet", EXTRA)
    temporary = file.with_suffix(TEMPORARY_SUFFIX)
    writer: Any = None
    with parquet.ParquetFile(file) as before:
        for group in range(before.num_row_groups):
            after = change(before.read_row_group(group))
            if writer is None:
                writer = parquet.ParquetWriter(temporary, _plain(after.schema))
            if after.num_rows:
                writer.write_table(after.cast(writer.schema), row_group_size=after.num_rows)
    if writer is not None:
        writer.close()
        temporary.replace(file)


def _plain(schema: Any) -> Any:
    metadata: Mapping[bytes, bytes] = schema.metadata or {}
    return schema.with_metadata({k: v for k, v in metadata.items() if k != b"huggingface"})
