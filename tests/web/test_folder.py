"""What the recordings of a folder share: vocabulary, parameters, and another's segmentation."""

import json
import shutil
from pathlib import Path

import pytest
from talking import Message, PageClient, StartServer

from keyphase.files.shipped import shipped


@pytest.fixture
def two(own_copy: Path) -> tuple[Path, Path]:
    """Two recordings in one folder."""
    return own_copy, Path(shutil.copy(shipped("data") / "setup1.npz", own_copy.parent))


def _name_first_segment(page: PageClient, label: str) -> Message:
    page.send("edit", edit={"kind": "label", "time_s": 0.05, "label": label})
    return page.wait_for("document", lambda m: m["segments"][0]["label"] == label)


def test_a_name_given_once_is_offered_in_the_whole_folder(
    two: tuple[Path, Path], start_server: StartServer
) -> None:
    with PageClient(start_server(*two)) as page:
        page.wait_for("document")
        named = _name_first_segment(page, "approach")
        page.open(2)
        other = page.wait_for("document", lambda m: m["id"] == page.id(2))
        page.send("forget_label", label="approach")
        forgotten = page.wait_for("document", lambda m: not m["labels"])

    assert [label["name"] for label in named["labels"]] == ["approach"]
    assert other["labels"] == named["labels"]
    assert forgotten["id"] == other["id"]


def test_an_accepted_proposal_is_no_word_of_the_vocabulary(page: PageClient) -> None:
    page.send("edit", edit={"kind": "add", "time_s": 0.4})
    proposal = page.wait_for("document", lambda m: m["edits"] == 1)["segments"][0]["label"]

    named = _name_first_segment(page, proposal)

    assert not named["segments"][0]["proposed"]
    assert named["labels"] == []


def test_a_name_has_one_colour_wherever_it_is_given(
    two: tuple[Path, Path], start_server: StartServer
) -> None:
    with PageClient(start_server(*two)) as page:
        before = page.wait_for("document")["segments"]
        page.send("edit", edit={"kind": "label", "time_s": before[1]["end_s"] - 0.01, "label": "x"})
        named = page.wait_for("document", lambda m: m["edits"] == 1)
        page.open(2)
        page.wait_for("document", lambda m: m["id"] == page.id(2))
        other = _name_first_segment(page, "x")

    assert named["segments"][1]["color"] == before[1]["color"]
    assert other["segments"][0]["color"] == before[1]["color"]


def test_the_vocabulary_is_there_after_a_restart(own_copy: Path, start_server: StartServer) -> None:
    first = start_server(own_copy)
    with PageClient(first) as page:
        page.wait_for("document")
        _name_first_segment(page, "approach")
    first.stop()

    with PageClient(start_server(own_copy)) as page:
        assert page.wait_for("document")["labels"][0]["name"] == "approach"


def test_before_parameters_are_spread_each_recording_says_what_would_change(
    two: tuple[Path, Path], start_server: StartServer
) -> None:
    with PageClient(start_server(*two)) as page:
        page.wait_for("document")
        page.send("set", parameter="force_threshold", value=1.0)
        page.wait_for("document", lambda m: m["undo"])
        page.send("spread", step="look")
        items = page.wait_for("spread", lambda m: len(m["items"]) == m["total"])["items"]
        page.open(2)
        other = page.wait_for("document", lambda m: m["id"] == page.id(2))

    assert [item["name"] for item in items] == ["synthetic_setup1", "setup1"]
    assert items[0]["own"]
    assert items[1]["goes_s"] or items[1]["moves_s"]
    assert other["parameters"]["force_threshold"] is None


def test_spread_parameters_hold_in_the_whole_folder_except_where_others_were_set(
    two: tuple[Path, Path], start_server: StartServer
) -> None:
    with PageClient(start_server(*two)) as page:
        page.wait_for("document")
        page.open(2)
        page.wait_for("document", lambda m: m["id"] == page.id(2))
        page.send("set", parameter="persistence", value=7.0)
        page.wait_for("document", lambda m: m["undo"])
        page.open(1)
        page.wait_for("document", lambda m: m["id"] == page.id(1))
        page.send("set", parameter="force_ratio", value=33.0)
        page.wait_for("document", lambda m: m["undo"])
        page.send("spread", step="apply")
        page.wait_for("notice", lambda m: m["level"] == "info")
        page.open(2)
        other = page.wait_for("document", lambda m: m["id"] == page.id(2))

    assert other["parameters"]["force_ratio"] == 33.0
    assert other["parameters"]["persistence"] == 7.0


def test_who_spread_parameters_follows_the_next_who_does(
    two: tuple[Path, Path], start_server: StartServer
) -> None:
    with PageClient(start_server(*two)) as page:
        page.wait_for("document")
        for recording, ratio in ((1, 33.0), (2, 44.0)):
            page.open(recording)
            if page.told["document"]["id"] != page.id(recording):
                page.wait_for("document", lambda m, at=recording: m["id"] == page.id(at))
            page.send("set", parameter="force_ratio", value=ratio)
            page.wait_for("document", lambda m: m["saved_at"])
            page.send("spread", step="apply")
            page.wait_for("notice", lambda m: m["level"] == "info")
        page.open(1)
        first = page.wait_for("document", lambda m: m["id"] == page.id(1))

    assert first["parameters"]["force_ratio"] == 44.0


def test_reset_is_automatic_whatever_the_folder_has(
    own_copy: Path, start_server: StartServer
) -> None:
    with PageClient(start_server(own_copy)) as page:
        page.wait_for("document")
        page.send("set", parameter="force_ratio", value=33.0)
        page.wait_for("document", lambda m: m["undo"])
        page.send("spread", step="apply")
        page.wait_for("notice", lambda m: m["level"] == "info")
        page.send("reset")

        page.wait_for("document", lambda m: m["parameters"]["force_ratio"] == 20.0)


def test_a_labeling_is_compared_with_the_automatic_one(page: PageClient) -> None:
    page.send("edit", edit={"kind": "add", "time_s": 0.4})
    page.wait_for("document", lambda m: m["edits"] == 1)
    page.send("compare", **{"with": "automatic"})

    comparison = page.wait_for("comparison")

    assert comparison["only_first_s"] == [pytest.approx(0.4, abs=0.01)]
    assert comparison["only_second_s"] == []
    assert 0 < comparison["f1"] < 1


def test_a_labeling_is_compared_with_a_segment_file_of_the_same_recording(
    page: PageClient,
) -> None:
    page.send("export", kind="json")
    page.wait_for("saved")
    page.send("compare")
    options = page.wait_for("comparison")["options"]
    page.send("compare", **{"with": options[1]})

    assert page.wait_for("comparison", lambda m: m["with"])["f1"] == 1.0


def test_anothers_segment_file_is_taken_over_in_one_step(page: PageClient) -> None:
    page.send("edit", edit={"kind": "add", "time_s": 0.4})
    theirs = page.wait_for("document", lambda m: m["edits"] == 1)
    page.send("export", kind="json")
    name = Path(page.wait_for("saved")["path"]).name
    page.send("undo")
    page.wait_for("document", lambda m: m["edits"] == 0)
    page.send("take_over", **{"from": name})
    taken = page.wait_for("document", lambda m: m["edits"] == 1)

    assert [b["time_s"] for b in taken["boundaries"]] == pytest.approx(
        [b["time_s"] for b in theirs["boundaries"]]
    )
    assert taken["undo"] == f"Take over “{name[:23]}…”"


def test_taking_over_the_programs_own_takes_all_edits_back(page: PageClient) -> None:
    before = page.heard[-1]
    page.send("edit", edit={"kind": "add", "time_s": 0.4})
    page.wait_for("document", lambda m: m["edits"] == 1)
    page.send("take_over", **{"from": "automatic"})

    assert page.wait_for("document", lambda m: m["edits"] == 2)["segments"] == before["segments"]


def test_only_what_is_offered_is_taken_over(page: PageClient) -> None:
    page.send("take_over", **{"from": "../x.segments.json"})

    assert "no such segment file" in page.wait_for("refused")["text"]


def test_a_segment_file_of_another_recording_is_refused(page: PageClient, own_copy: Path) -> None:
    page.send("export", kind="json")
    path = Path(page.wait_for("saved")["path"])
    content = json.loads(path.read_text())
    content["demonstration"]["sha256"] = "0" * 64
    other = own_copy.with_name("other.segments.json")
    other.write_text(json.dumps(content))
    page.send("compare", **{"with": other.name})

    assert "another recording" in page.wait_for("refused")["text"]


def test_only_files_that_are_offered_are_compared_with(page: PageClient) -> None:
    page.send("compare", **{"with": "../../../etc/passwd"})

    assert "no such segment file" in page.wait_for("refused")["text"]
