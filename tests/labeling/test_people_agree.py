"""Two people's segment files of a folder: how well they agree, and where they do not."""

import json

import pytest
from handmade import Person, demonstration, segmentation

from keyphase.cli import main
from keyphase.errors import LabelingError
from keyphase.labeling.comparing.agreement import agreement
from keyphase.labeling.edits import Label, Remove
from keyphase.labeling.segment_file import write_segment_file


@pytest.fixture
def folders(tmp_path):
    """Two recordings, labelled by two people of whom the second sees one otherwise."""
    first, second = tmp_path / "first", tmp_path / "second"
    for folder in (first, second):
        folder.mkdir()
    for name, edits in (("a", ()), ("b", (Label(5.0, "insert"), Remove(8.0)))):
        found = segmentation(made_from=demonstration(path=tmp_path / f"{name}.npz", name=name))
        write_segment_file(Person(found).labeling, first / f"{name}.segments.json")
        person = Person(found)
        person.makes(*edits)
        write_segment_file(person.labeling, second / f"{name}.segments.json")
    return first, second


def test_recordings_are_compared_by_name_and_together(folders):
    found = agreement(*folders)
    by_key = {one.key: one.comparison for one in found.recordings}
    assert (by_key["a"].f1, by_key["a"].same_label) == (1.0, 1.0)
    assert by_key["b"].f1 == pytest.approx(6 / 7)
    assert found.f1 == pytest.approx(14 / 15)
    assert found.same_label == pytest.approx(0.5 * (1.0 + by_key["b"].same_label))


def test_disagreements_say_where_and_what_each_says(folders):
    told = [(one.key, one.start_s, one.end_s) for one in agreement(*folders).disagreements]
    assert ("b", 8.0, 8.0) in told
    assert ("b", 4.0, 6.0) in told
    assert all(key == "b" for key, _, _ in told)


def test_what_only_one_has_and_what_is_of_another_recording_is_named(folders, tmp_path):
    first, second = folders
    (second / "a.segments.json").rename(second / "c.segments.json")
    other = segmentation(made_from=demonstration(path=tmp_path / "other.npz"))
    (tmp_path / "other.npz").write_bytes(b"another recording")
    other = segmentation(made_from=demonstration(path=tmp_path / "other.npz"))
    write_segment_file(Person(other).labeling, second / "b.segments.json")
    found = agreement(first, second)
    assert (found.only_first, found.only_second) == (("a",), ("c",))
    assert [key for key, _ in found.refused] == ["b"]
    assert found.f1 is None


def test_folders_that_share_nothing_are_refused(folders, tmp_path):
    (tmp_path / "empty").mkdir()
    with pytest.raises(LabelingError, match="share none"):
        agreement(folders[0], tmp_path / "empty")


def test_a_folder_that_is_missing_is_named_as_missing(folders, tmp_path):
    with pytest.raises(LabelingError, match="nowhere does not exist"):
        agreement(folders[0], tmp_path / "nowhere")
    with pytest.raises(LabelingError, match=r"a\.segments\.json is a file"):
        agreement(folders[0] / "a.segments.json", folders[1])


def test_the_command_prints_for_people_and_for_machines(folders, capsys):
    for extra, reads in (([], str), (["--json"], json.loads)):
        with pytest.raises(SystemExit) as ended:
            main(["agree", *map(str, folders), *extra])
        assert ended.value.code == 0
        assert reads(capsys.readouterr().out)


def test_disagreements_alone_are_rows_for_a_queue(folders, capsys):
    told = {}
    for extra in ("", "--json"):
        with pytest.raises(SystemExit):
            main(["agree", *map(str, folders), "--disagreements", *filter(None, [extra])])
        told[extra] = capsys.readouterr().out
    names, *rows = [line.split("\t") for line in told[""].splitlines()]
    assert names == ["recording", "start_s", "end_s", "first", "second"]
    assert ["b", "8.000", "8.000", "boundary", ""] in rows
    assert len(json.loads(told["--json"])) == len(rows)
