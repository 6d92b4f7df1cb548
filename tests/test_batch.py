"""Many recordings at once: where their segment files go, and what happens to bad ones."""

import json

import numpy as np
import pytest

from keyphase.commands.batch import segment_all
from keyphase.demonstration import Demonstration
from keyphase.errors import KeyphaseError, ParameterError, SegmentFileError
from keyphase.labeling.segment_file import read_segment_file
from keyphase.readers import save_npz
from keyphase.segmentation.parameters import Parameters


def record(path):
    """A tool that moves forward for two seconds and then up for two."""
    time = np.arange(400) / 100
    position = np.zeros((400, 3))
    position[:, 0] = 0.1 * np.minimum(time, 2.0)
    position[:, 2] = 0.1 * np.maximum(time - 2.0, 0.0)
    path.parent.mkdir(parents=True, exist_ok=True)
    save_npz(Demonstration(path.stem, time, position), path)
    return path


def test_names_follow_the_folder_given_or_the_files_own_name(tmp_path):
    record(tmp_path / "in" / "a" / "one.npz")
    record(tmp_path / "in" / "b" / "one.npz")
    alone = record(tmp_path / "elsewhere" / "deep" / "two.old.npz")
    report = segment_all([tmp_path / "in", alone], tmp_path / "out", jobs=1)
    assert [w.segment_file.relative_to(tmp_path / "out").as_posix() for w in report.written] == [
        "a/one.segments.json",
        "b/one.segments.json",
        "two.old.segments.json",
    ]
    for written in report.written:
        assert read_segment_file(written.segment_file).recording.samefile(written.recording)


def test_two_recordings_for_one_file_are_refused_before_any_work(tmp_path):
    record(tmp_path / "a" / "one.npz")
    record(tmp_path / "b" / "one.npz")
    with pytest.raises(SegmentFileError, match=r"one\.segments\.json"):
        segment_all([tmp_path / "a", tmp_path / "b"], tmp_path / "out", jobs=1)
    assert not (tmp_path / "out").exists()


def test_the_same_recording_named_twice_is_segmented_once(tmp_path):
    path = record(tmp_path / "one.npz")
    assert len(segment_all([path, tmp_path], tmp_path / "out", jobs=1).written) == 1


def test_a_bad_recording_is_reported_and_the_others_go_on(tmp_path):
    for name in ("a.npz", "c.npz"):
        record(tmp_path / "in" / name)
    (tmp_path / "in" / "b.npz").write_bytes(b"no archive")
    seen = []
    report = segment_all(
        [tmp_path / "in"], tmp_path / "out", jobs=2, progress=lambda *now: seen.append(now)
    )
    assert [w.recording.name for w in report.written] == ["a.npz", "c.npz"]
    assert [refusal.path.name for refusal in report.refused] == ["b.npz"]
    assert "b.npz" in report.refused[0].reason
    assert seen == [(0, 3), (1, 3), (2, 3), (3, 3)]


def test_a_missing_file_is_reported(tmp_path):
    report = segment_all([tmp_path / "nothing.npz"], tmp_path / "out", jobs=1)
    assert "no such file" in report.refused[0].reason


def test_parameters_reach_the_segmentation_and_the_file(tmp_path):
    path = record(tmp_path / "one.npz")
    parameters = Parameters(gaussians=3)
    report = segment_all([path], tmp_path / "out", parameters=parameters, jobs=1)
    assert read_segment_file(report.written[0].segment_file).parameters == parameters


def test_a_table_is_written_beside_where_asked(tmp_path):
    path = record(tmp_path / "one.npz")
    segment_all([path], tmp_path / "out", csv=True, jobs=1)
    assert (tmp_path / "out" / "one.segments.csv").read_text().startswith("id,start_s,end_s,label")


def test_one_after_another_or_several_at_once_gives_the_same_bytes(tmp_path):
    for name in ("a.npz", "b.npz"):
        record(tmp_path / "in" / name)
    segment_all([tmp_path / "in"], tmp_path / "out1", jobs=1)
    segment_all([tmp_path / "in"], tmp_path / "out2", jobs=2)
    for name in ("a.segments.json", "b.segments.json"):
        assert (tmp_path / "out1" / name).read_bytes() == (tmp_path / "out2" / name).read_bytes()


def test_an_output_that_cannot_be_written_is_reported(tmp_path):
    path = record(tmp_path / "one.npz")
    (tmp_path / "out").write_text("in the way")
    report = segment_all([path], tmp_path / "out", jobs=1)
    assert len(report.refused) == 1


def test_nothing_to_segment_and_no_jobs_are_refused(tmp_path):
    with pytest.raises(KeyphaseError, match="found none"):
        segment_all([tmp_path], tmp_path / "out")
    with pytest.raises(ParameterError, match="jobs"):
        segment_all([tmp_path], tmp_path / "out", jobs=0)


def test_real_recordings_are_segmented_and_refer_to_themselves(real_data, tmp_path):
    report = segment_all([real_data / "lund_yumi"], tmp_path, jobs=1)
    content = json.loads(report.written[0].segment_file.read_bytes())
    assert content["demonstration"]["name"] == "leadthrough"
    assert len(content["segments"]) > 2
    assert read_segment_file(report.written[0].segment_file).demonstration.rate_hz > 9
