"""LeRobot: what is added in a copy, read back with pyarrow, and that all else is as it was."""

import json

import numpy as np
import pyarrow.parquet as pq
import pytest
from lerobot_datasets import dataset, read_episodes, read_frames
from lerobot_exports import exported, items, trimmed
from segmented_recordings import EDGES_S, NAMES, RATE_HZ, item

from keyphase.errors import ExportError
from keyphase.writers import planned_export


@pytest.fixture(scope="module", params=["v3.0", "v2.1"])
def both(request, tmp_path_factory):
    """A dataset and its labelled copy."""
    path = dataset(tmp_path_factory.mktemp("lerobot"), request.param)
    return path, exported(path, path.parent / "out")


@pytest.fixture(scope="module")
def v3(tmp_path_factory):
    path = dataset(tmp_path_factory.mktemp("v3"), video=True)
    return path, exported(path, path.parent / "out")


def test_every_frame_of_an_episode_has_the_same_rows_and_unlabelled_ones_have_none(both):
    frames = read_frames(both[1])
    by_episode = {n: [] for n in range(3)}
    columns = frames["episode_index"].to_pylist(), frames["language_persistent"].to_pylist()
    for number, rows in zip(*columns, strict=True):
        by_episode[number].append(rows)
    assert all(rows == by_episode[0][0] for rows in by_episode[0])
    assert all(rows == [] for rows in by_episode[1])
    assert all(rows == [] for rows in frames["language_events"].to_pylist())
    subtasks = [row for row in by_episode[2][0] if row["style"] == "subtask"]
    assert tuple(row["content"] for row in subtasks) == NAMES
    assert {(r["role"], r["camera"], r["tool_calls"]) for r in by_episode[0][0]} == {
        ("assistant", None, None)
    }


def test_timestamps_are_the_frames_own_bit_by_bit(both):
    frames = read_frames(both[1])
    times = set(frames["timestamp"].to_numpy().tolist())
    rows = frames["language_persistent"][0].as_py()
    assert all(row["timestamp"] in times for row in rows)
    starts = [row["timestamp"] for row in rows if row["style"] == "subtask"]
    np.testing.assert_allclose(starts, EDGES_S[:-1], atol=0.5 / RATE_HZ)


def test_motions_say_what_segments_do_whatever_a_person_called_them(both):
    rows = read_frames(both[1])["language_persistent"][0].as_py()
    motions = [row["content"] for row in rows if row["style"] == "motion"]
    assert len(motions) == len(NAMES)
    assert not set(motions) & set(NAMES)
    assert "down" in motions[0]


def test_untouched_columns_are_byte_by_byte_as_they_were(both):
    before, after = map(read_frames, both)
    for name in before.column_names:
        assert after[name].type == before[name].type
        assert _bytes(after[name]) == _bytes(before[name])
    groups = [
        [pq.ParquetFile(file).num_row_groups for file in sorted((path / "data").rglob("*.parquet"))]
        for path in both
    ]
    assert groups[0] == groups[1]


def _bytes(column):
    """The numbers of a column as they lie in memory, without offsets of slices."""
    one = column.combine_chunks()
    flat = one.flatten() if hasattr(one, "flatten") and one.type.num_fields else one
    return flat.to_numpy(zero_copy_only=False).tobytes()


def test_the_info_names_the_new_columns_and_nothing_else_changed(both):
    before, after = (json.loads((path / "meta/info.json").read_text()) for path in both)
    language = {"dtype": "language", "shape": [1], "names": None}
    assert after["features"]["language_persistent"] == language
    assert after["features"]["language_events"] == language
    assert {**after, "features": before["features"]} == before


def test_sarm_knows_the_kept_stages_of_each_episode(v3):
    rows = read_episodes(v3[1])
    kept = [NAMES[0], NAMES[1], NAMES[3]]
    assert [row["sparse_subtask_names"] for row in rows] == [kept, None, kept]
    assert rows[0]["sparse_subtask_start_frames"] == [0, 50, 200]
    assert rows[0]["sparse_subtask_end_frames"] == [49, 124, 250]
    assert rows[0]["subtask_names"] == kept
    assert len(set(rows[0]["dense_subtask_names"])) == 3
    shares = json.loads((v3[1] / "meta/temporal_proportions_sparse.json").read_text())
    assert list(shares) == kept
    assert sum(shares.values()) == pytest.approx(1.0)


def test_progress_grows_to_one_and_stands_still_where_a_segment_was_dropped(both):
    table = pq.read_table(both[1] / "sarm_progress.parquet")
    numbers, progress = table["episode_index"].to_numpy(), table["progress_sparse"].to_numpy()
    assert progress.dtype == np.float32
    assert np.isnan(progress[numbers == 1]).all()
    one = progress[numbers == 0]
    assert (np.diff(one) >= 0).all()
    assert one[-1] == pytest.approx(1.0)
    assert one[124] == one[199] < one[201]


def test_idle_ends_are_trimmed_with_their_video(tmp_path):
    path = dataset(tmp_path, video=True)
    short = trimmed(path, tmp_path / "out")
    frames, rows = read_frames(short), read_episodes(short)
    assert [row["length"] for row in rows] == [150, 251, 150]
    assert frames["index"].to_pylist() == list(range(551))
    first = frames.slice(0, 150)
    assert first["frame_index"].to_pylist() == list(range(150))
    np.testing.assert_allclose(first["timestamp"].to_numpy(), np.arange(150) / RATE_HZ, atol=1e-6)
    state = read_frames(path)["observation.state"].to_pylist()[50:200]
    assert first["observation.state"].to_pylist() == state
    name = "videos/observation.images.top"
    assert rows[0][f"{name}/from_timestamp"] == pytest.approx(50 / RATE_HZ)
    assert rows[0][f"{name}/to_timestamp"] == pytest.approx((251 - 51) / RATE_HZ)
    assert {k: v for k, v in rows[1].items() if not is_new(k)} == {
        k: v for k, v in read_episodes(path)[1].items() if not is_new(k)
    }
    info = json.loads((short / "meta/info.json").read_text())
    assert info["total_frames"] == 551
    language = frames["language_persistent"][0].as_py()
    assert [row["content"] for row in language if row["style"] == "subtask"] == list(NAMES[1:3])
    assert language[0]["timestamp"] == 0.0


def is_new(column):
    """Columns of stages, and indices that move with the frames that are cut before."""
    return "subtask" in column or column.startswith("dataset_")


def test_each_frames_task_is_its_segment(tmp_path):
    path = dataset(tmp_path)
    written = exported(path, tmp_path / "out", "lerobot-tasks")
    tasks = pq.read_table(written / "meta/tasks.parquet").to_pydict()
    names = dict(zip(tasks["task_index"], tasks["task"], strict=True))
    frames = read_frames(written)
    assert [names[i] for i in frames["task_index"].to_pylist()[0:251:60]] == [
        *("approach", "insert", "insert"),
        *("wait", "retract"),
    ]
    assert set(frames["task_index"].to_pylist()[251:502]) == {0}
    assert [row["tasks"] for row in read_episodes(written)] == [
        list(NAMES),
        ["put it in"],
        list(NAMES),
    ]
    assert json.loads((written / "meta/info.json").read_text())["total_tasks"] == 5


def test_a_recording_of_another_format_is_refused(tmp_path):
    with pytest.raises(ExportError, match="expected a LeRobot dataset"):
        list(planned_export([item(tmp_path)], "lerobot", tmp_path / "out").write())


def test_a_dataset_is_never_written_into_itself(v3):
    path = v3[0]
    with pytest.raises(ExportError, match="never modified"):
        list(planned_export(items(path), "lerobot", path.parent).write())
