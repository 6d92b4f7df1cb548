"""Labels that others left in recordings are read, compared and taken over."""

import json

import h5py
import numpy as np
import pyarrow as pa
import pyarrow.parquet as pq
import pytest
from lerobot_datasets import dataset
from segmented_recordings import EDGES_S, NAMES, RATE_HZ, item, moving, with_segment_file

from keyphase.auditing import UNLABELLED, GivenSegment, audit, given_labels, taken_over
from keyphase.auditing.given import tiling
from keyphase.cli import main
from keyphase.errors import ExportError
from keyphase.files.parts import with_part
from keyphase.labeling.segment_file import read_segment_file
from keyphase.readers import read
from keyphase.segmentation import segment
from keyphase.writers import SegmentedRecording, planned_export


@pytest.fixture(scope="module")
def labeled_dataset(tmp_path_factory):
    """A LeRobot dataset whose first episode somebody labelled."""
    path = dataset(tmp_path_factory.mktemp("audit"))
    files = [with_segment_file(path.parent, with_part(path, "episode_0"))]
    items = [SegmentedRecording.of_file(file) for file in files]
    output = path.parent / "labelled"
    ((written,),) = planned_export(items, "lerobot", output).write()
    (output / "recipe.toml").write_text((path.parent / "recipe.toml").read_text())
    return written


def edges(given):
    return [segment.start_s for segment in given.segments]


def test_language_rows_come_back_as_they_were_written(labeled_dataset):
    recording = with_part(labeled_dataset, "episode_0")
    given = given_labels(recording, read(recording))
    assert "subtask" in given.source
    assert [segment.label for segment in given.segments] == list(NAMES)
    np.testing.assert_allclose(edges(given), EDGES_S[:-1], atol=0.5 / RATE_HZ)


def test_an_episode_without_labels_says_so(labeled_dataset):
    recording = with_part(labeled_dataset, "episode_1")
    with pytest.raises(ExportError, match="there are none"):
        given_labels(recording, read(recording))


def test_a_word_for_each_frame_is_read_as_segments(tmp_path):
    path = dataset(tmp_path)
    file = path / "data/chunk-000/file-000.parquet"
    table = pq.read_table(file)
    words = ["grasp"] * 100 + ["insert"] * 653
    pq.write_table(table.append_column("primitive", pa.array(words)), file)
    recording = with_part(path, "episode_0")
    given = given_labels(recording, read(recording))
    assert [(s.start_s, s.label) for s in given.segments] == [(0.0, "grasp"), (2.0, "insert")]


def test_reassemble_segments_are_read_in_the_clock_of_the_demonstration(tmp_path):
    path = tmp_path / "assembly.h5"
    time, position, wxyz, force = moving()
    with h5py.File(path, "w") as file:
        file["robot_state/pose"] = np.hstack([position, wxyz])
        for name in ("force", "torque"):
            file[f"robot_state/compensated_base_{name}"] = force
            file[f"timestamps/compensated_base_{name}"] = 1.7e9 + time
        file["timestamps/pose"] = 1.7e9 + time
        for i, (start, end) in enumerate([(0.5, 2.0), (2.0, 4.0)]):
            file[f"segments_info/{i}/start"] = 1.7e9 + start
            file[f"segments_info/{i}/end"] = 1.7e9 + end
            file[f"segments_info/{i}/text"] = f"step {i}"
    (tmp_path / "recipe.toml").write_text('preset = "reassemble"\n[wrench]\nsign = 1\n')
    given = given_labels(path, read(path))
    assert [s.label for s in given.segments] == [UNLABELLED, "step 0", "step 1", UNLABELLED]
    np.testing.assert_allclose(edges(given), [0.0, 0.5, 2.0, 4.0], atol=1e-6)


def test_overlapping_stretches_become_a_tiling(tmp_path):
    demonstration = item(tmp_path).demonstration()
    named = [GivenSegment(1.0, 3.0, "a"), GivenSegment(2.0, 9.0, "b")]
    given = tiling(demonstration, "by hand", named)
    assert given.segments == (
        GivenSegment(0.0, 1.0, UNLABELLED),
        GivenSegment(1.0, 2.0, "a"),
        GivenSegment(2.0, 5.0, "b"),
    )


def test_taken_over_labels_are_the_labeling_whatever_was_found(tmp_path):
    demonstration = item(tmp_path).demonstration()
    given = tiling(
        demonstration, "by hand", [GivenSegment(0.0, 1.7, "one"), GivenSegment(1.7, 5.0, "two")]
    )
    labeling = taken_over(segment(demonstration), given)
    assert [(s.start_s, s.label) for s in labeling.segments] == [(0.0, "one"), (1.7, "two")]
    assert not labeling.inapplicable


def test_an_audit_counts_what_both_have_and_where_they_differ(labeled_dataset):
    audited = audit(with_part(labeled_dataset, "episode_0"))
    result = audited.comparison
    assert len(result.shared) + len(result.only_first_s) == 3
    assert any(abs(pair.first_s - 1.0) < 0.05 for pair in result.shared)
    assert 0.0 < result.f1 <= 1.0


def test_the_command_writes_segment_files_to_be_corrected(labeled_dataset, tmp_path, capsys):
    with pytest.raises(SystemExit) as done:
        main(["audit", str(labeled_dataset), "--json", "--output", str(tmp_path)])
    assert done.value.code == 1
    said = capsys.readouterr()
    (one,) = json.loads(said.out)
    assert [name for *_, name in one["segments"]] == list(NAMES)
    assert said.err.count("there are none") == 2
    (file,) = tmp_path.glob("*.segments.json")
    assert [s.label for s in read_segment_file(file).segments] == list(NAMES)
