"""LeRobot datasets in the layouts v2.1 and v3.0, made with pyarrow as the format documents them."""

import json
from pathlib import Path
from typing import Any

import numpy as np
import pyarrow as pa
import pyarrow.parquet as pq
import pytest

from keyphase.errors import DemonstrationError, RecipeError
from keyphase.readers import find_recordings, parse_recipe, read
from keyphase.readers.formats.lerobot import names_in_lerobot

RECIPE = """
time = {column = "timestamp", unit = "s"}
force = {columns = "observation.wrench[*]", unit = "N"}
wrench = {frame = "base", sign = 1}
[position]
columns = ["observation.state.x", "observation.state.y", "observation.state.z"]
unit = "m"
"""
FEATURES = {
    "observation.state": {"dtype": "float32", "shape": [4], "names": ["x", "y", "z", "grip"]},
    "observation.wrench": {"dtype": "float32", "shape": [3], "names": None},
}


def episode(number: int, rows: int = 30) -> pa.Table:
    state = np.arange(rows * 4, dtype=np.float32).reshape(rows, 4) / 100 + number
    lists = lambda values: pa.FixedSizeListArray.from_arrays(values.ravel(), values.shape[1])  # noqa: E731
    return pa.table(
        {
            "observation.state": lists(state),
            "observation.wrench": lists(np.full((rows, 3), float(number), np.float32)),
            "timestamp": np.arange(rows, dtype=np.float32) / 30,
            "episode_index": np.full(rows, number, np.int64),
            "index": np.arange(rows, dtype=np.int64),
        }
    )


def info(folder: Path, **content: Any) -> None:
    (folder / "meta").mkdir(parents=True)
    known = {"fps": 30, "features": FEATURES, "chunks_size": 1000}
    (folder / "meta" / "info.json").write_text(json.dumps({**known, **content}))


@pytest.fixture
def v3(tmp_path: Path) -> Path:
    """Four episodes in one file, a row group each."""
    folder = tmp_path / "ds3"
    path = "data/chunk-{chunk_index:03d}/file-{file_index:03d}.parquet"
    info(folder, codebase_version="v3.0", total_episodes=4, data_path=path)
    (folder / "data" / "chunk-000").mkdir(parents=True)
    tables = [episode(number) for number in range(4)]
    with pq.ParquetWriter(folder / "data/chunk-000/file-000.parquet", tables[0].schema) as writer:
        for table in tables:
            writer.write_table(table)
    where = {"episode_index": range(4), "data/chunk_index": [0] * 4, "data/file_index": [0] * 4}
    (folder / "meta/episodes/chunk-000").mkdir(parents=True)
    pq.write_table(pa.table(where), folder / "meta/episodes/chunk-000/file-000.parquet")
    return folder


@pytest.fixture
def v21(tmp_path: Path) -> Path:
    """A file for each of two episodes."""
    folder = tmp_path / "ds21"
    path = "data/chunk-{episode_chunk:03d}/episode_{episode_index:06d}.parquet"
    info(folder, codebase_version="v2.1", total_episodes=2, data_path=path)
    (folder / "data" / "chunk-000").mkdir(parents=True)
    for number in range(2):
        pq.write_table(episode(number), folder / f"data/chunk-000/episode_{number:06d}.parquet")
    return folder


@pytest.mark.parametrize(("dataset", "count"), [("v3", 4), ("v21", 2)])
def test_a_dataset_is_a_list_of_episodes(
    dataset: str, count: int, request: pytest.FixtureRequest
) -> None:
    folder: Path = request.getfixturevalue(dataset)
    names = [found.path.name for found in find_recordings([folder.parent])]
    assert names == [f"{folder.name}#episode_{number}" for number in range(count)]


@pytest.mark.parametrize("dataset", ["v3", "v21"])
def test_an_episode_is_read_value_by_value(dataset: str, request: pytest.FixtureRequest) -> None:
    folder: Path = request.getfixturevalue(dataset)
    demonstration = read(f"{folder}#episode_1", parse_recipe(RECIPE, "r"))
    expected = np.arange(120, dtype=np.float32).reshape(30, 4)[:, :3] / 100 + 1
    np.testing.assert_allclose(demonstration.position_m, expected, rtol=1e-6)
    np.testing.assert_array_equal(demonstration.force_N, np.ones((30, 3)))
    np.testing.assert_allclose(demonstration.time_s, np.arange(30) / 30, atol=1e-6)


def test_a_recipe_in_the_folder_of_the_dataset_reads_it(v3: Path) -> None:
    (v3.parent / "recipe.toml").write_text(RECIPE)
    assert read(f"{v3}#episode_2").name == "ds3#episode_2"


def test_nothing_is_guessed_and_the_columns_are_named(v3: Path) -> None:
    with pytest.raises(RecipeError, match=r"observation\.state\.x.*observation\.wrench\[0\]"):
        read(f"{v3}#episode_0")


def test_a_pattern_that_leads_out_of_the_dataset_is_refused(v21: Path) -> None:
    content = json.loads((v21 / "meta/info.json").read_text())
    content["data_path"] = "../{episode_index}/../../etc/passwd"
    (v21 / "meta/info.json").write_text(json.dumps(content))
    with pytest.raises(DemonstrationError, match="is not a file in it"):
        read(f"{v21}#episode_0", parse_recipe(RECIPE, "r"))


def test_a_cut_file_is_refused(v21: Path) -> None:
    file = v21 / "data/chunk-000/episode_000000.parquet"
    file.write_bytes(file.read_bytes()[:200])
    with pytest.raises(DemonstrationError, match="expected a whole LeRobot dataset"):
        read(f"{v21}#episode_0", parse_recipe(RECIPE, "r"))


def test_a_file_that_git_lfs_has_not_fetched_is_named_with_what_to_do(v21: Path) -> None:
    file = v21 / "data/chunk-000/episode_000000.parquet"
    file.write_text("version https://git-lfs.github.com/spec/v1\noid sha256:4d7a\nsize 12345\n")
    with pytest.raises(DemonstrationError, match=r"episode_000000\.parquet .*: git lfs pull"):
        read(f"{v21}#episode_0", parse_recipe(RECIPE, "r"))


@pytest.mark.parametrize("names", [{"motors": ["x", "y"]}, ["x", "y"], {"y": 1, "x": 0}])
def test_features_are_named_however_a_dataset_writes_their_names(
    tmp_path: Path, names: object
) -> None:
    path = tmp_path / "named"
    (path / "meta").mkdir(parents=True)
    feature = {"dtype": "float32", "shape": [2], "names": names}
    info = {"features": {"observation.state": feature}, "total_episodes": 1}
    (path / "meta" / "info.json").write_text(json.dumps(info))
    assert names_in_lerobot(path, None) == ("observation.state.x", "observation.state.y")


def test_a_file_whose_description_of_a_column_is_damaged_ends_nothing(v3: Path) -> None:
    """pyarrow ends the whole program over such statistics, instead of raising."""
    file = v3 / "data/chunk-000/file-000.parquet"
    whole = b"\x15\x04\x19"  # INT64, then the encodings
    assert whole in file.read_bytes()
    file.write_bytes(file.read_bytes().replace(whole, b"\x15\x02\x19"))
    with pytest.raises(DemonstrationError, match="expected a whole LeRobot dataset"):
        read(f"{v3}#episode_1", parse_recipe(RECIPE, "r.toml"))


def test_more_episodes_than_there_are_bytes_to_tell_of_are_refused(v3: Path) -> None:
    told = json.loads((v3 / "meta/info.json").read_text())
    (v3 / "meta/info.json").write_text(json.dumps({**told, "total_episodes": 9_000_000}))
    with pytest.raises(DemonstrationError, match="9000000, more than meta/ has bytes"):
        read(f"{v3}#episode_1", parse_recipe(RECIPE, "r.toml"))
