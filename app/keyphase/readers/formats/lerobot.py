"""LeRobot datasets v2.1 and v3.0: a folder of Parquet files is a list of episodes.

No key of the format is a wrench or a pose, so a recipe or a preset says which columns are what;
the names in `meta/info.json` (`features.*.names`) name them: `observation.state.x`.
"""

import json
from collections.abc import Iterator, Mapping, Sequence
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from keyphase.errors import DemonstrationError
from keyphase.files.bounded_memory import memory_bounded
from keyphase.readers.formats.array_table import ArrayTable
from keyphase.readers.formats.damage import damage_told, what_is_wrong
from keyphase.readers.formats.numeric import MAX_NUMBERS_A_ROW, refuse_too_large, unknown_part
from keyphase.readers.formats.packages import package

EXTRA = "lerobot"
INFO = "meta/info.json"

_MAX_INFO_BYTES = 64 << 20
_MAX_EPISODES = 10_000_000
_MANY_EPISODES = 1000
"""What states more of them must have something to say of each: a name for each takes memory."""
_BATCH_ROWS = 8192


def is_lerobot(path: Path) -> bool:
    """Whether a folder is a LeRobot dataset."""
    return (path / INFO).is_file() and (path / "data").is_dir()


def parts_of_lerobot(path: Path) -> tuple[str, ...]:
    """episode_0, episode_1, …, as many as `meta/info.json` counts."""
    count = info_of(path).get("total_episodes")
    if isinstance(count, bool) or not isinstance(count, int) or not 0 <= count <= _MAX_EPISODES:
        raise _damaged(path, "total_episodes must be a whole number")
    if count > _MANY_EPISODES and count > _bytes_of_meta(path):
        raise _damaged(path, f"total_episodes is {count}, more than meta/ has bytes")
    return tuple(f"episode_{i}" for i in range(count))


def _bytes_of_meta(path: Path) -> int:
    return sum(one.stat().st_size for one in (path / "meta").rglob("*") if one.is_file())


def table_of_lerobot(path: Path, part: str | None, limit_bytes: int) -> ArrayTable:
    """The numbers and texts of one episode; of a shared file only its row groups are read.

    Raises DemonstrationError for a dataset or part that cannot be read, MissingPackageError where
    pyarrow is not installed.
    """
    info = info_of(path)
    number = episode_number(part)
    if number is None or number >= len(parts_of_lerobot(path)):
        raise unknown_part(str(path), part, parts_of_lerobot(path))
    with damage_told(path, "LeRobot dataset"):
        table = _episode(path, info, number)
        shown = f"{path}#{part}"
        columns = dict(columns_of_parquet(table))
        refuse_too_large(columns.values(), shown, limit_bytes)
        texts = dict(texts_of_parquet(table))
    return ArrayTable(shown, columns, texts, (), _feature_names(info))


def names_in_lerobot(path: Path, _part: str | None) -> tuple[str, ...]:
    """What the columns of every episode are called, by `meta/info.json` alone."""
    info = info_of(path)
    features = info.get("features")
    empty: dict[str, NDArray[Any]] = {}
    for name, feature in features.items() if isinstance(features, dict) else ():
        shape = feature.get("shape") if isinstance(feature, dict) else None
        if shape == [1]:
            empty[name] = np.empty(0)
        elif isinstance(shape, list) and len(shape) == 1 and _is_width(shape[0]):
            empty[name] = np.empty((0, shape[0]))
    return ArrayTable(str(path), empty, {}, (), _feature_names(info)).names


def _is_width(value: Any) -> bool:
    return isinstance(value, int) and 0 < value <= MAX_NUMBERS_A_ROW


def file_of_episode(path: Path, info: Mapping[str, Any], number: int) -> Path:
    """The Parquet file that holds an episode, by the pattern the dataset states."""
    pattern = info.get("data_path")
    if not isinstance(pattern, str):
        raise _damaged(path, "data_path is missing")
    if is_v3(info):
        where = episode_row(path, number, ["data/chunk_index", "data/file_index"])
        values = {
            "chunk_index": int(where["data/chunk_index"]),
            "file_index": int(where["data/file_index"]),
        }
    else:
        size = info.get("chunks_size", 1000)
        values = {"episode_chunk": number // int(size), "episode_index": number}
    return inside(path, pattern.format(**values))


def inside(path: Path, relative: str) -> Path:
    """A file of the dataset, and no other."""
    file = (path / relative).resolve()
    if path.resolve() not in file.parents or not file.is_file():
        raise _damaged(path, f"{relative[:200]} is not a file in it")
    return file


def is_v3(info: Mapping[str, Any]) -> bool:
    """Whether it holds many episodes in one file."""
    return str(info.get("codebase_version", "")).startswith("v3")


def _episode(path: Path, info: Mapping[str, Any], number: int) -> Any:
    """The episode's rows: of the other row groups no more than whose they are."""
    parquet = package("pyarrow.parquet", EXTRA, path)
    compute = package("pyarrow.compute", EXTRA, path)
    arrow = package("pyarrow", EXTRA, path)
    chosen = file_of_episode(path, info, number)
    # Without threads: one that cannot be begun under the bound would end the program.
    with memory_bounded(chosen), parquet.ParquetFile(chosen) as file:
        groups = [g for g in range(file.num_row_groups) if _holds(file, g, number, compute)]
        names = [one.name for one in file.schema_arrow if _is_plain(one.type)]
        pieces = [
            piece.filter(compute.equal(piece["episode_index"], number))
            for piece in file.iter_batches(
                _BATCH_ROWS, row_groups=groups, columns=names, use_threads=False
            )
        ]
        schema = arrow.schema([one for one in file.schema_arrow if one.name in names])
    return arrow.Table.from_batches(pieces, schema)


def _is_plain(kind: Any) -> bool:
    """Numbers, lists of numbers, words and dates; images lie in records of bytes."""
    types = package("pyarrow.types", EXTRA, Path())
    return not (types.is_struct(kind) or types.is_binary(kind) or types.is_large_binary(kind))


def _holds(file: Any, group: int, number: int, compute: Any) -> bool:
    """By the numbers themselves: statistics that are damaged end pyarrow and the whole program."""
    column = file.read_row_group(group, columns=["episode_index"], use_threads=False)[
        "episode_index"
    ]
    return bool(compute.any(compute.equal(column, number)).as_py())


def episode_row(path: Path, number: int, columns: Sequence[str]) -> Mapping[str, Any]:
    """What `meta/episodes` of a v3 dataset says of an episode in these columns."""
    parquet = package("pyarrow.parquet", EXTRA, path)
    compute = package("pyarrow.compute", EXTRA, path)
    wanted = ["episode_index", *columns]
    for file in sorted((path / "meta" / "episodes").glob("*/*.parquet")):
        if not file.is_file():
            raise _damaged(path, f"{file.name} is no regular file")
        table = parquet.read_table(file, columns=wanted)
        rows = table.filter(compute.equal(table["episode_index"], number)).to_pylist()
        if rows:
            return rows[0]
    raise _damaged(path, f"meta/episodes does not say where episode {number} is")


def columns_of_parquet(table: Any) -> Iterator[tuple[str, NDArray[Any]]]:
    """Columns of numbers and of lists of equally many numbers."""
    types = package("pyarrow.types", EXTRA, Path())
    for name in table.column_names:
        column, kind = table[name].combine_chunks(), table[name].type
        if types.is_integer(kind) or types.is_floating(kind) or types.is_boolean(kind):
            yield name, np.asarray(column.to_numpy(zero_copy_only=False), dtype=np.float64)
        elif types.is_list(kind) or types.is_fixed_size_list(kind) or types.is_large_list(kind):
            inner = kind.value_type
            if not (types.is_floating(inner) or types.is_integer(inner)):
                continue
            flat = np.asarray(column.flatten().to_numpy(zero_copy_only=False), dtype=np.float64)
            if len(table) and flat.size % len(table) == 0:
                width = flat.size // len(table)
                if 0 < width <= MAX_NUMBERS_A_ROW:
                    yield name, flat.reshape(len(table), width)


def texts_of_parquet(table: Any) -> Iterator[tuple[str, list[str]]]:
    """Columns of words."""
    types = package("pyarrow.types", EXTRA, Path())
    for name in table.column_names:
        if types.is_string(table[name].type) or types.is_large_string(table[name].type):
            yield name, [str(value) for value in table[name].to_pylist()]


def _feature_names(info: Mapping[str, Any]) -> dict[str, list[str]]:
    """Names of the numbers of a feature, where the dataset gives them plainly."""
    features = info.get("features")
    found: dict[str, list[str]] = {}
    for name, feature in features.items() if isinstance(features, dict) else ():
        names = _plain_names(feature.get("names") if isinstance(feature, dict) else None)
        if names is not None:
            found[name] = names
    return found


def _plain_names(given: Any) -> list[str] | None:
    """A list of names; also inside {"motors": …}, or as the index of each name."""
    if isinstance(given, dict) and len(given) == 1 and isinstance(next(iter(given.values())), list):
        given = next(iter(given.values()))
    if isinstance(given, dict):
        by_index = {index: name for name, index in given.items() if type(index) is int}
        given = [by_index.get(index) for index in range(len(given))]
    if isinstance(given, list) and all(isinstance(one, str) for one in given):
        return given
    return None


def info_of(path: Path) -> dict[str, Any]:
    """What the dataset says of itself. Raises DemonstrationError where it cannot be read."""
    file = path / INFO
    try:
        if file.stat().st_size > _MAX_INFO_BYTES:
            raise _damaged(path, f"{INFO} is too large")
        content = json.loads(file.read_bytes())
    except (OSError, ValueError, RecursionError) as error:
        raise _damaged(path, f"{INFO} cannot be read ({what_is_wrong(file, error)})") from error
    if not isinstance(content, dict):
        raise _damaged(path, f"{INFO} must hold an object")
    return content


def episode_number(part: str | None) -> int | None:
    """Which episode a part of a dataset is."""
    digits = (part or "").removeprefix("episode_")
    return int(digits) if digits.isdecimal() and len(digits) <= 9 else None


def _damaged(path: Path, reason: str) -> DemonstrationError:
    return DemonstrationError(
        f"{path}: expected a whole LeRobot dataset, but {reason}; copy or export it again."
    )
