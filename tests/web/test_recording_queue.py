"""Several recordings in one page: the list, and what is known of each without opening it."""

import shutil
import threading
from pathlib import Path

import numpy as np
import pytest
from talking import PageClient, StartServer

from keyphase.printable import printable
from keyphase.workbench.desks.library import Library
from keyphase.workbench.desks.open_recording import OpenRecording
from keyphase.workbench.recordings import Recording, recording_at

MAX_STEPS = 5000
"""Answers of the server until others must have been looked at."""


@pytest.fixture
def three(own_copy: Path) -> list[Path]:
    """Two recordings and, between them, a file that is none."""
    broken = own_copy.with_name("broken.npz")
    broken.write_bytes(b"not an archive")
    again = own_copy.with_name("again.npz")
    shutil.copy(own_copy, again)
    return [own_copy, broken, again]


def test_the_first_is_open_and_the_others_are_looked_at_meanwhile(
    three: list[Path], start_server: StartServer
) -> None:
    with PageClient(start_server(*three)) as page:
        lines = page.wait_for(
            "recordings", lambda m: m["items"][2]["strip"] and m["items"][1]["error"]
        )["items"]

    assert [line["name"] for line in lines] == ["synthetic_setup1", "broken", "again"]
    assert lines[0]["strip"] == lines[2]["strip"]
    assert 0 < lines[2]["confidence"] <= 1
    assert sum(part["share"] for part in lines[2]["strip"]) == pytest.approx(1.0)


@pytest.fixture
def looked(monkeypatch: pytest.MonkeyPatch) -> list[str]:
    """Names of the recordings that were looked at without being opened, as they are."""
    names: list[str] = []
    look = Library.look

    def noted(library: Library, recording: Recording) -> OpenRecording:
        names.append(recording.name)
        return look(library, recording)

    monkeypatch.setattr(Library, "look", noted)
    return names


def test_what_is_open_is_not_looked_at_again(
    three: list[Path], start_server: StartServer, looked: list[str]
) -> None:
    with PageClient(start_server(*three)) as page:
        page.wait_for("recordings", lambda m: m["items"][2]["strip"])

    assert looked == ["broken", "again"]


def test_others_are_looked_at_when_there_is_time(
    three: list[Path], start_server: StartServer, looked: list[str]
) -> None:
    server = start_server()
    there_is_time = threading.Event()
    with PageClient(server) as page:
        page.wait_for("recordings")
        server.workbench.looking.may_look = there_is_time.is_set
        (view,) = server.workbench.views
        for path in three:
            view.add(path)
        page.wait_for("document", lambda m: m["name"] == "again")
        server.workbench.looking.begin()
        page.send("seek", time_s=0.1)
        page.wait_for("playhead")
        assert looked == []
        there_is_time.set()
        for step in range(MAX_STEPS):
            page.send("seek", time_s=0.2 + 0.001 * step)
            page.wait_for("playhead")
            if "broken" in looked:
                break
        assert "broken" in looked


def test_a_file_that_cannot_be_read_says_so_in_its_line_and_opens_nothing(
    three: list[Path], start_server: StartServer
) -> None:
    with PageClient(start_server(*three)) as page:
        page.wait_for("document")
        page.open(2)
        notice = page.wait_for("notice")

    assert "broken.npz" in notice["text"]


def test_another_recording_is_opened(three: list[Path], start_server: StartServer) -> None:
    with PageClient(start_server(*three)) as page:
        page.wait_for("document")
        page.open(3)
        document = page.wait_for("document", lambda m: m["id"] == page.id(3))
        recordings = page.wait_for("recordings", lambda m: m["current"] == page.id(3))

    assert document["name"] == "again"
    assert recordings["items"][2]["state"] == "automatic"


def test_work_goes_on_at_the_first_recording_that_is_not_done(
    three: list[Path], start_server: StartServer
) -> None:
    first = start_server(*three)
    with PageClient(first) as page:
        page.wait_for("document")
        page.send("done", done=True)
        page.wait_for("document", lambda m: m["state"] == "done")
        page.open(3)
        page.wait_for("document", lambda m: m["id"] == page.id(3))
        page.send("edit", edit={"kind": "add", "time_s": 0.4})
        page.wait_for("document", lambda m: m["edits"] == 1)
    first.stop()

    with PageClient(start_server(three[0], three[2])) as page:
        document = page.wait_for("document")

    assert document["name"] == "again"
    assert document["edits"] == 1


def test_what_was_done_is_known_before_anything_is_looked_at(
    three: list[Path], start_server: StartServer
) -> None:
    first = start_server(*three)
    with PageClient(first) as page:
        page.wait_for("document")
        page.send("done", done=True)
        page.wait_for("document", lambda m: m["state"] == "done")
    first.stop()

    lines = start_server(*three).workbench.recordings.recordings

    assert [line.state for line in lines] == ["done", "automatic", "automatic"]


def test_going_back_finds_the_edits(three: list[Path], start_server: StartServer) -> None:
    with PageClient(start_server(*three)) as page:
        page.wait_for("document")
        page.send("edit", edit={"kind": "add", "time_s": 0.4})
        page.wait_for("document", lambda m: m["edits"] == 1)
        page.open(3)
        page.wait_for("document", lambda m: m["id"] == page.id(3))
        page.open(1)

        assert page.wait_for("document", lambda m: m["id"] == page.id(1))["edits"] == 1


def test_an_unknown_recording_is_refused(page: PageClient) -> None:
    page.send("open", id="../../etc/passwd")

    assert "no such recording" in page.wait_for("refused")["text"]


def test_a_segment_file_for_each_that_can_be_read(
    three: list[Path], start_server: StartServer
) -> None:
    with PageClient(start_server(*three)) as page:
        page.wait_for("document")
        page.send("export", kind="json", scope="all")
        notice = page.wait_for("notice", lambda m: m["level"] == "info")

    assert notice["text"] == "2 of 3 recordings were written: keyphase segment file."
    assert three[2].with_name("again.segments.json").exists()


def test_without_recordings_the_page_is_empty_and_alive(start_server: StartServer) -> None:
    with PageClient(start_server()) as page:
        recordings = page.wait_for("recordings")
        page.send("replay", do="run")
        notice = page.wait_for("refused")

    assert recordings["items"] == []
    assert "No recording is open" in notice["text"]


def test_position_alone_has_no_error_and_no_threshold(
    tmp_path: Path, start_server: StartServer
) -> None:
    time = np.arange(0, 4, 0.01)
    position = np.stack([np.clip(time, 1, 2), np.clip(time, 2, 3), 0 * time], axis=1)
    path = tmp_path / "position_only.npz"
    np.savez(path, time_s=time, position_m=0.2 * position)

    with PageClient(start_server(path)) as page:
        document = page.wait_for("document")
        page.send(
            "signals", request=1, tracks=["error", "force", "speed"], from_s=0, to_s=4, width=9
        )
        header, _ = page.wait_for_signals()

    assert document["channels"] == ["position"]
    assert document["threshold"] is None
    assert [track["name"] for track in header["tracks"]] == ["speed"]


def test_names_of_any_bytes_can_be_told() -> None:
    path = Path(b"caf\xe9.npz".decode("utf-8", "surrogateescape"))

    assert printable(path.stem).encode("utf-8")
    assert recording_at(path).name == "caf?"


def test_a_recording_that_is_taken_out_gives_way_to_its_neighbour(
    three: list[Path], start_server: StartServer
) -> None:
    first, _, last = three
    server = start_server(first, last)
    with PageClient(server) as page:
        first_id = page.wait_for("document")["id"]
        server.workbench.remove(first)
        document = page.wait_for("document", lambda m: m["id"] != first_id)

    assert document["name"] == "again"
    assert [recording.path for recording in server.workbench.recordings.recordings] == [last]
