"""Many recordings at once: where their segment files go, and what happens to bad ones."""

import json
import os
import signal

import numpy as np
import pytest

from keyphase.batch.running import one_by_one
from keyphase.batch.segmenting import segment_all
from keyphase.demonstration import Demonstration
from keyphase.errors import KeyphaseError, ParameterError, SegmentFileError
from keyphase.labeling.segment_file import read_segment_file
from keyphase.readers import save_npz
from keyphase.segmentation.parameters import Parameters

pytestmark = pytest.mark.slow


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


def test_what_was_read_with_another_recipe_is_not_written_over(tmp_path):
    """Two arms in one table: the second is refused, not put in the place of the first."""
    rows = "".join(f"{i / 50},{i},5,1,{2 * i},5,1\n" for i in range(60))
    (tmp_path / "run.csv").write_text(f"t,lx,ly,lz,rx,ry,rz\n{rows}")
    written = []
    for arm in ("l", "r"):
        recipe = tmp_path / f"{arm}.toml"
        recipe.write_text(
            '[time]\ncolumn = "t"\nunit = "s"\n'
            f'[position]\ncolumns = ["{arm}x", "{arm}y", "{arm}z"]\nunit = "mm"\n'
        )
        report = segment_all([tmp_path / "run.csv"], tmp_path / "out", recipe=recipe, jobs=1)
        written.append((tmp_path / "out" / "run.segments.json").read_bytes())
    assert written[0] == written[1]
    (refused,) = report.refused
    assert "keyphase wrote it for run.csv as l.toml reads it" in refused.reason


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


def test_an_output_that_cannot_be_written_is_refused_before_any_work(tmp_path):
    path = record(tmp_path / "one.npz")
    (tmp_path / "out").write_text("in the way")
    with pytest.raises(SegmentFileError, match="cannot be made"):
        segment_all([path], tmp_path / "out", jobs=1)


def test_a_refusal_stands_in_the_manifest_and_is_tried_again(tmp_path):
    bad = tmp_path / "bad.npz"
    bad.write_bytes(b"no archive")
    for _ in range(2):
        assert len(segment_all([bad], tmp_path / "out", jobs=1).refused) == 1
    lines = (tmp_path / "out" / "keyphase-manifest.jsonl").read_text().splitlines()
    assert ["bad.npz" in json.loads(line)["refused"] for line in lines] == [True, True]


def test_a_threshold_of_the_published_error_is_refused_where_it_is_a_probability(tmp_path):
    path = record(tmp_path / "a.npz")
    with pytest.raises(ParameterError, match=r"a probability .* but is 2; .* variant paper"):
        segment_all([path], tmp_path / "out", parameters=Parameters(force_threshold=2))
    report = segment_all(
        [path], tmp_path / "out", parameters=Parameters(force_threshold=2, variant="paper")
    )
    assert not report.refused


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


def test_what_an_earlier_run_has_done_is_not_done_again(tmp_path):
    for name in ("a.npz", "b.npz"):
        record(tmp_path / "in" / name)
    first = segment_all([tmp_path / "in"], tmp_path / "out", jobs=1)
    again = segment_all([tmp_path / "in"], tmp_path / "out", jobs=1)
    assert [one.went_before for one in first.written] == [False, False]
    assert [one.went_before for one in again.written] == [True, True]


@pytest.mark.parametrize("change", ["recording", "parameters", "segment file", "again"])
def test_what_has_changed_since_is_done_again(tmp_path, change):
    path = record(tmp_path / "one.npz")
    segment_all([path], tmp_path / "out", jobs=1)
    parameters = Parameters(merge_tolerance_s=0.2) if change == "parameters" else Parameters()
    if change == "recording":
        save_npz(Demonstration("one", np.arange(9) / 9, np.zeros((9, 3))), path)
    if change == "segment file":
        (tmp_path / "out" / "one.segments.json").unlink()
    report = segment_all(
        [path], tmp_path / "out", parameters=parameters, jobs=1, again=change == "again"
    )
    assert [one.went_before for one in report.written] == [False]
    assert (tmp_path / "out" / "one.segments.json").is_file()


def test_a_manifest_torn_by_a_kill_costs_only_its_last_line(tmp_path):
    for name in ("a.npz", "b.npz"):
        record(tmp_path / "in" / name)
    segment_all([tmp_path / "in"], tmp_path / "out", jobs=1)
    manifest = tmp_path / "out" / "keyphase-manifest.jsonl"
    manifest.write_bytes(manifest.read_bytes()[:-20])
    again = segment_all([tmp_path / "in"], tmp_path / "out", jobs=1)
    assert [one.went_before for one in again.written] == [True, False]


def test_the_shards_together_are_all_and_none_twice(tmp_path):
    for number in range(5):
        record(tmp_path / "in" / f"{number}.npz")
    done = [
        {
            one.recording.name
            for one in segment_all(
                [tmp_path / "in"], tmp_path / "out", jobs=1, shard=f"{number}/3"
            ).written
        }
        for number in (1, 2, 3)
    ]
    assert sum(map(len, done)) == 5
    assert len(set().union(*done)) == 5


@pytest.mark.parametrize("shard", ["0/3", "4/3", "1", "a/b", "1/0"])
def test_a_shard_that_is_none_is_refused(tmp_path, shard):
    path = record(tmp_path / "one.npz")
    with pytest.raises(ParameterError, match="such as 3/16"):
        segment_all([path], tmp_path / "out", jobs=1, shard=shard)


def test_a_defect_in_one_recording_is_named_and_the_others_go_on(tmp_path, monkeypatch):
    import keyphase.readers

    for name in ("a.npz", "b.npz"):
        record(tmp_path / "in" / name)
    read = keyphase.readers.read

    def broken(path, recipe=None):
        if path.name == "a.npz":
            raise ZeroDivisionError("by chance")
        return read(path, recipe)

    monkeypatch.setattr(keyphase.readers, "read", broken)
    report = segment_all([tmp_path / "in"], tmp_path / "out", jobs=1)
    assert "a.npz: something is wrong inside keyphase" in report.refused[0].reason
    assert [one.recording.name for one in report.written] == ["b.npz"]


def negative_ends_its_worker(number):
    if number < 0:
        os.kill(os.getpid(), signal.SIGKILL)
    return number


def test_what_ends_its_worker_is_named_and_the_others_go_on():
    """As a library does over a damaged file, or the system where memory runs out."""
    todo = [1, 2, -3, 4]
    became = one_by_one(negative_ends_its_worker, todo, 2, lambda number: f"{number} ended it")
    assert list(became) == [1, 2, "-3 ended it", 4]
