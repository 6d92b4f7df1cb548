"""What pages see when a document changes: through the websocket, as the page does."""

import itertools
from dataclasses import asdict
from pathlib import Path

import pytest
from talking import Message, PageClient, StartServer

from keyphase.segmentation.parameters import Parameters


def _boundaries(document: Message) -> list[float]:
    return [boundary["time_s"] for boundary in document["boundaries"]]


def _add(page: PageClient, time_s: float, event: int = 1) -> Message:
    page.send("edit", edit={"kind": "add", "time_s": time_s}, event=event)
    return page.wait_for("document", lambda m: m["cause"] and m["cause"]["event"] == event)


@pytest.fixture
def document(page: PageClient) -> Message:
    """The document the page was greeted with."""
    return next(m for m in page.heard if m["type"] == "document")


def test_segments_tile_the_recording(document: Message) -> None:
    segments = document["segments"]

    assert segments[0]["start_s"] == document["start_s"]
    assert segments[-1]["end_s"] == document["end_s"]
    for before, after in itertools.pairwise(segments):
        assert before["end_s"] == after["start_s"]
    assert [s["end_s"] for s in segments[:-1]] == _boundaries(document)


def test_parameters_are_all_told(document: Message) -> None:
    assert document["parameters"] == asdict(Parameters())
    assert document["threshold"] == document["automatic_threshold"]


def test_a_higher_threshold_gives_fewer_contact_changes(
    page: PageClient, document: Message
) -> None:
    contacts = [b for b in document["boundaries"] if b["contact_change"]]
    page.send("set", parameter="force_threshold", value=1.0, event=5)

    changed = page.wait_for("document", lambda m: m["cause"] and m["cause"]["event"] == 5)

    assert contacts
    assert not [b for b in changed["boundaries"] if b["contact_change"]]
    assert changed["threshold"] == 1.0


def test_the_cause_names_the_page_and_its_input(page: PageClient) -> None:
    hello = page.told["hello"]
    page.send("set", parameter="force_ratio", value=30.0, event=41)

    changed = page.wait_for("document", lambda m: m["cause"])

    assert changed["cause"] == {"event": 41, "client": hello["client"]}


def test_while_a_slider_is_held_ghosts_show_what_goes(page: PageClient, document: Message) -> None:
    page.send("set", parameter="force_threshold", value=1.0, held=True)
    ghost = page.wait_for("ghost", lambda m: m["boundaries"])

    gone = {g["time_s"] for g in ghost["boundaries"] if g["fate"] == "goes"}

    assert gone <= set(_boundaries(document))
    assert gone


def test_what_was_held_is_undone_in_one_step_once_let_go(
    page: PageClient, document: Message
) -> None:
    for value in (0.5, 0.6, 0.7):
        page.send("set", parameter="force_threshold", value=value, held=True)
    page.send("set", parameter="force_threshold", value=0.8, held=False)
    kept = page.wait_for("document", lambda m: m["undo"])
    page.send("undo")
    back = page.wait_for("document", lambda m: m["redo"])

    assert kept["undo"] == "Threshold 0.8"
    assert back["parameters"] == document["parameters"]
    assert _boundaries(back) == _boundaries(document)


def test_automatic_is_null(page: PageClient, document: Message) -> None:
    page.send("set", parameter="force_threshold", value=0.8)
    page.wait_for("document", lambda m: m["threshold"] == 0.8)
    page.send("set", parameter="force_threshold", value=None)

    page.wait_for("document", lambda m: m["threshold"] == document["automatic_threshold"])


@pytest.mark.parametrize(
    ("parameter", "value", "reason"),
    [
        ("force_threshold", -1.0, "force_threshold"),
        ("gaussians", 2.5, "whole number"),
        ("variant", "magic", "one of"),
        ("colour", 1.0, "no parameter"),
        ("force_ratio", "much", "a number"),
    ],
)
def test_a_value_that_cannot_be_is_refused_and_changes_nothing(
    page: PageClient, parameter: str, value: object, reason: str
) -> None:
    page.send("set", parameter=parameter, value=value)

    assert reason in page.wait_for("refused")["text"]
    assert not [m for m in page.heard if m["type"] == "document"][1:]


def test_an_edit_is_made_named_and_undone(page: PageClient, document: Message) -> None:
    added = _add(page, 0.4)
    page.send("undo")
    undone = page.wait_for("document", lambda m: m["redo"])
    page.send("redo")
    redone = page.wait_for("document", lambda m: m["revision"] > undone["revision"])

    assert len(_boundaries(added)) == len(_boundaries(document)) + 1
    assert added["undo"] == "Add boundary at 0.40 s"
    assert added["saved_at"]
    assert _boundaries(undone) == _boundaries(document)
    assert _boundaries(redone) == _boundaries(added)


def test_an_edit_that_cannot_be_made_is_refused(page: PageClient) -> None:
    page.send("edit", edit={"kind": "remove", "time_s": -5.0}, event=3)

    refused = page.wait_for("refused")

    assert (refused["request"], refused["event"]) == ("edit", 3)
    assert refused["text"]


def test_a_name_is_kept_while_thresholds_move(page: PageClient, document: Message) -> None:
    middle = 0.5 * document["segments"][0]["end_s"]
    page.send("edit", edit={"kind": "label", "time_s": middle, "label": "reach <b>"})
    page.send("set", parameter="force_threshold", value=1.0)

    changed = page.wait_for("document", lambda m: m["threshold"] == 1.0)

    assert changed["segments"][0]["label"] == "reach <b>"
    assert not changed["segments"][0]["proposed"]


def test_two_pages_see_the_same_document(page: PageClient) -> None:
    with PageClient(page.server) as other:
        other.wait_for("document")
        mine = _add(page, 0.4)
        theirs = other.wait_for("document", lambda m: m["revision"] == mine["revision"])

    assert theirs == mine


def test_a_server_started_again_knows_every_edit(own_copy: Path, start_server: StartServer) -> None:
    first = start_server(own_copy)
    with PageClient(first) as page:
        page.wait_for("document")
        edited = _add(page, 0.4)
    first.stop()

    with PageClient(start_server(own_copy)) as page:
        again = page.wait_for("document")

    assert again["segments"] == edited["segments"]
    assert again["undo"] == edited["undo"]


def test_the_second_server_on_a_recording_says_that_it_only_looks(
    page: PageClient, own_copy: Path, start_server: StartServer
) -> None:
    with PageClient(start_server(own_copy)) as second:
        document = second.wait_for("document")
        second.send("edit", edit={"kind": "add", "time_s": 0.4})
        refusal = second.wait_for("refused")
        second.send("set", parameter="force_ratio", value=40.0)
        second.wait_for("refused", lambda m: m["request"] == "set")

    assert document["locked"]
    assert any("looking only" in notice["text"] for notice in document["notices"])
    assert "Nothing can be changed" in refusal["text"]


def test_a_selected_segment_is_told_and_forgotten_when_it_is_gone(
    page: PageClient, document: Message
) -> None:
    last = len(document["segments"]) - 1
    page.send("select", segment=last)
    told = page.wait_for("selection", lambda m: m["segment"] == last)
    page.send("edit", edit={"kind": "merge", "from_s": 0.1, "to_s": document["end_s"] - 0.1})
    merged = page.wait_for("document", lambda m: len(m["segments"]) <= last)

    assert told["segment"] == last
    assert merged["selected"] is None


def test_there_is_no_segment_beyond_the_last(page: PageClient) -> None:
    page.send("select", segment=1000)

    assert "1000" in page.wait_for("refused")["text"]


def test_seeking_stays_inside_the_recording(page: PageClient, document: Message) -> None:
    page.send("seek", time_s=1e6)

    assert page.wait_for("playhead", lambda m: m["time_s"] > 0)["time_s"] == document["end_s"]


def test_playing_moves_the_playhead_to_the_end_and_stops(
    page: PageClient, document: Message
) -> None:
    page.send("play", playing=True, speed=100.0, loop=False)

    stopped = page.wait_for("playhead", lambda m: not m["playing"] and m["time_s"] > 0)

    assert stopped["time_s"] == document["end_s"]


def test_parts_of_the_scene_are_shown_and_hidden(page: PageClient) -> None:
    page.send("show", what="gaussians", visible=False)
    hidden = page.wait_for("shown", lambda m: not m["parts"]["gaussians"])
    page.send("show", what="ceiling", visible=False)

    assert hidden["parts"]["labels"]
    assert "ceiling" in page.wait_for("refused")["text"]


def test_a_segment_file_is_written_beside_the_recording(page: PageClient, own_copy: Path) -> None:
    page.send("export", kind="json")
    saved = Path(page.wait_for("saved")["path"])
    page.send("export", kind="csv")
    table = Path(page.wait_for("saved")["path"])

    assert saved == own_copy.with_name("synthetic_setup1.segments.json")
    assert saved.stat().st_size > 0
    assert table.read_text().count("\n") >= 5


def test_a_recording_can_be_marked_as_done(page: PageClient) -> None:
    page.send("done", done=True)
    page.wait_for("document", lambda m: m["state"] == "done")

    line = page.wait_for("recordings")["items"][0]

    assert line["state"] == "done"


def test_how_long_the_page_took_is_remembered(page: PageClient) -> None:
    page.send("latency", event=1, milliseconds=12.5)
    page.send("select", segment=0)
    page.wait_for("selection", lambda m: m["segment"] == 0)

    assert list(page.server.latencies_ms) == [12.5]


def test_a_page_that_comes_late_is_told_what_is_under_way(page: PageClient) -> None:
    with page.server.workbench.tasks.begin("reading") as task, PageClient(page.server) as late:
        task.at(0.5)
        assert late.wait_for("task", lambda m: m["fraction"] == 0.5)["name"] == "reading"


def test_the_end_of_one_task_ends_no_other(page: PageClient) -> None:
    tasks = page.server.workbench.tasks
    with tasks.begin("trials"):
        with tasks.begin("segmenting"):
            pass
        under_way = [task.name for task in tasks.under_way]

    assert under_way == ["trials"]
    assert not tasks.under_way
