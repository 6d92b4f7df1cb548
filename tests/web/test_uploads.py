"""Files from a browser: streamed to disk under a safe name, refused where they are not ours."""

from pathlib import Path

import pytest
from hypothesis import given
from hypothesis import strategies as st
from talking import PageClient

from keyphase.errors import RequestError
from keyphase.shipped import shipped
from keyphase.web.uploads import MOST_BYTES, SUFFIXES, Upload, safe_name


def _send(page: PageClient, name: str, data: bytes, piece: int = 40_000) -> None:
    page.send("upload", name=name, size=len(data))
    for start in range(0, len(data), piece):
        page.send_raw(data[start : start + piece])


def test_a_recording_that_is_sent_is_saved_beside_the_others_and_opens(
    page: PageClient, own_copy: Path
) -> None:
    data = (shipped("data") / "setup1.npz").read_bytes()
    _send(page, "../../my take.npz", data)

    name = page.wait_for("uploaded")["name"]
    document = page.wait_for("document", lambda m: m["id"] == "2")

    assert name == "my_take.npz"
    assert (own_copy.parent / name).read_bytes() == data
    assert document["name"] == "my_take"


def test_a_name_that_is_taken_gets_a_number(page: PageClient, own_copy: Path) -> None:
    before = own_copy.read_bytes()
    _send(page, own_copy.name, before)

    assert page.wait_for("uploaded")["name"] == "synthetic_setup1_2.npz"
    assert own_copy.read_bytes() == before


def test_what_is_no_recording_is_taken_and_its_line_says_why(page: PageClient) -> None:
    _send(page, "attack.npz", b"\x80\x04cos\nsystem\n(S'touch hacked'\ntR.")
    page.wait_for("uploaded")

    line = page.wait_for("recordings", lambda m: len(m["items"]) == 2 and m["items"][1]["error"])

    assert "attack.npz" in line["items"][1]["error"]


@pytest.mark.parametrize("name", ["run.exe", "page.html", "script.js", "noname", "x.npz/..", ""])
def test_other_kinds_of_files_are_refused(page: PageClient, name: str) -> None:
    page.send("upload", name=name, size=10)

    assert "kinds" in page.wait_for("notice")["text"]


def test_too_large_a_file_is_refused_before_it_comes(page: PageClient) -> None:
    page.send("upload", name="x.npz", size=MOST_BYTES + 1)

    assert "500 MB" in page.wait_for("notice")["text"]


def test_more_than_was_announced_is_refused_and_leaves_nothing(
    page: PageClient, own_copy: Path
) -> None:
    page.send("upload", name="x.npz", size=5)
    page.send_raw(b"123456")

    assert "announced" in page.wait_for("notice")["text"]
    assert not list(own_copy.parent.glob(".upload-*"))


def test_a_piece_of_nothing_is_refused(page: PageClient) -> None:
    page.send_raw(b"123")

    assert "binary" in page.wait_for("notice")["text"]


def test_what_is_given_up_leaves_nothing(tmp_path: Path) -> None:
    upload = Upload(tmp_path, "x.npz", 10)
    upload.write(b"12345")
    upload.abandon()

    assert not list(tmp_path.iterdir())


@given(st.text(max_size=200), st.sampled_from(sorted(SUFFIXES)))
def test_any_name_becomes_plain(name: str, suffix: str) -> None:
    safe = safe_name(f"{name}x{suffix}")

    assert safe.isascii()
    assert not set(safe) & set("/\\ <>&\"'`$\0")
    assert not safe.startswith(".")
    assert len(safe) <= 90


@given(st.text(max_size=50))
def test_any_other_name_is_refused(name: str) -> None:
    with pytest.raises(RequestError):
        safe_name(name + ".svg")
