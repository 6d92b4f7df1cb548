"""Which recording a segment file is replayed over, and what is refused."""

import shutil
from pathlib import Path

import pytest
from replaying import bundled

from keyphase.errors import SegmentFileError
from keyphase.files.shipped import shipped
from keyphase.labeling.label import label
from keyphase.labeling.segment_file import write_segment_file
from keyphase.segmentation.end_condition import ConfigurationEnd
from keyphase.simulation.replay.input import planned_replay, with_configuration_ends


@pytest.fixture
def segment_file(tmp_path: Path) -> Path:
    path = tmp_path / "work" / "one.segments.json"
    path.parent.mkdir()
    write_segment_file(label(bundled("setup1")[2]), path)
    return path


def moved(segment_file: Path, folder: Path) -> Path:
    """The segment file where the path in it leads nowhere."""
    folder.mkdir(parents=True)
    return Path(shutil.move(segment_file, folder / segment_file.name))


def test_the_plan_comes_in_its_order(segment_file) -> None:
    planned = planned_replay(segment_file)
    expected = [segment.start_s for segment in label(bundled("setup1")[2]).segments if segment.kept]
    assert [segment.start_s for segment in planned.segments] == pytest.approx(expected)
    assert len(planned.demonstration) == len(bundled("setup1")[0])


def test_the_recording_is_found_beside_the_segment_file(segment_file, tmp_path) -> None:
    path = moved(segment_file, tmp_path / "far" / "away")
    beside = Path(shutil.copy(shipped("data") / "setup1.npz", path.parent))
    source = planned_replay(path).demonstration.source
    assert source is not None
    assert source.path.resolve() == beside.resolve()


def test_else_it_is_found_in_the_bundled_data(segment_file, tmp_path) -> None:
    path = moved(segment_file, tmp_path / "far" / "away")
    assert len(planned_replay(path).demonstration) == len(bundled("setup1")[0])


def test_another_recording_of_the_same_name_is_passed_over(segment_file, tmp_path) -> None:
    path = moved(segment_file, tmp_path / "far" / "away")
    shutil.copy(shipped("data") / "setup2.npz", path.parent / "setup1.npz")
    assert len(planned_replay(path).demonstration) == len(bundled("setup1")[0])


def test_a_recording_that_is_given_must_be_the_one_that_was_segmented(segment_file) -> None:
    with pytest.raises(SegmentFileError, match="has changed since"):
        planned_replay(segment_file, shipped("data") / "setup2.npz")


def test_a_recording_that_is_nowhere_is_refused(segment_file, tmp_path) -> None:
    path = moved(segment_file, tmp_path / "far" / "away")
    path.write_text(path.read_text().replace("setup1.npz", "nowhere.npz"))
    with pytest.raises(SegmentFileError, match=r"nowhere\.npz"):
        planned_replay(path)


def test_force_conditions_can_be_left_out(segment_file) -> None:
    segments = with_configuration_ends(planned_replay(segment_file).segments)
    assert all(segment.end_condition == ConfigurationEnd() for segment in segments)
