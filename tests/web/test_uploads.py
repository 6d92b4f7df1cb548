"""Files from a browser: streamed to disk under a safe name, refused where they are not ours."""

import io
import json
import time
from pathlib import Path

import h5py
import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from talking import Message, PageClient, StartServer

from keyphase.errors import RequestError
from keyphase.files.shipped import shipped
from keyphase.workbench.uploads import SUFFIXES, Upload, safe_name


def _send(page: PageClient, name: str, data: bytes, piece: int = 40_000) -> None:
    page.send("upload", name=name, size=len(data))
    page.wait_for("upload_ready")
    for start in range(0, len(data), piece):
        page.send_raw(data[start : start + piece])


def _refusal(page: PageClient) -> str:
    return page.wait_for("upload_refused")["text"]


def _files(folder: Path) -> set[str]:
    return {path.name for path in folder.iterdir() if path.name != ".keyphase"}


def test_a_recording_that_is_sent_is_saved_beside_the_others_and_opens(
    page: PageClient, own_copy: Path
) -> None:
    data = (shipped("data") / "setup1.npz").read_bytes()
    _send(page, "../../my take.npz", data)

    name = page.wait_for("uploaded")["name"]
    document = page.wait_for("document", lambda m: m["name"] == "my_take")

    assert name == "my_take.npz"
    assert (own_copy.parent / name).read_bytes() == data
    assert document["id"] == page.id(2)


def test_a_name_that_is_taken_gets_a_number(page: PageClient, own_copy: Path) -> None:
    before = own_copy.read_bytes()
    _send(page, own_copy.name, before)

    assert page.wait_for("uploaded")["name"] == "synthetic_setup1_2.npz"
    assert own_copy.read_bytes() == before


@pytest.mark.parametrize("name", ["attack.npz", "attack.csv"])
def test_what_cannot_be_read_is_refused_with_the_reason_and_leaves_nothing(
    page: PageClient, own_copy: Path, name: str
) -> None:
    _send(page, name, b"\x80\x04cos\nsystem\n(S'touch hacked'\ntR.")

    reason = _refusal(page)

    assert name in reason
    assert ".upload-" not in reason
    assert _files(own_copy.parent) == {own_copy.name}


def test_an_archive_that_holds_a_pickle_is_refused_unread(page: PageClient, own_copy: Path) -> None:
    archive = io.BytesIO()
    np.savez(archive, time_s=np.array([{"a": "pickle"}], dtype=object))
    _send(page, "pickle.npz", archive.getvalue())

    assert "pickle.npz" in _refusal(page)
    assert _files(own_copy.parent) == {own_copy.name}


@pytest.mark.parametrize("name", ["run.exe", "page.html", "script.js", "noname", "x.npz/..", ""])
def test_other_kinds_of_files_are_refused(page: PageClient, name: str) -> None:
    page.send("upload", name=name, size=10)

    assert "none of these kinds" in _refusal(page)


def test_too_large_a_file_is_refused_before_it_comes(
    own_copy: Path, start_server: StartServer
) -> None:
    with PageClient(start_server(own_copy, upload_limit_bytes=3 << 20)) as page:
        page.wait_for("document")
        page.send("upload", name="x.npz", size=(3 << 20) + 1)

        assert "up to 3 MB" in _refusal(page)
        page.send("upload", name="x.npz", size=0)
        assert "is empty" in _refusal(page)


def test_more_than_was_announced_is_refused_and_leaves_nothing(
    page: PageClient, own_copy: Path
) -> None:
    _send(page, "x.npz", b"12345")
    _refusal(page)
    page.send("upload", name="x.npz", size=5)
    page.wait_for("upload_ready")
    page.send_raw(b"123456")

    assert "announced" in _refusal(page)
    assert _files(own_copy.parent) == {own_copy.name}


def test_who_may_only_look_cannot_send(own_copy: Path, start_server: StartServer) -> None:
    server = start_server(own_copy)
    with PageClient(server, server.access.looking_token) as page:
        page.wait_for("document")
        page.send("upload", name="x.npz", size=5)

        assert "looking" in page.wait_for("refused")["text"]


def test_a_page_that_leaves_while_it_sends_leaves_nothing(
    own_copy: Path, start_server: StartServer
) -> None:
    server = start_server(own_copy)
    with PageClient(server) as leaving, PageClient(server) as staying:
        leaving.wait_for("document")
        leaving.send("upload", name="x.npz", size=500)
        leaving.wait_for("upload_ready")
        leaving.send_raw(b"1" * 100)
        leaving.close()
        for _ in range(100):
            staying.send("seek", time_s=0.1)
            staying.wait_for("playhead")
            if len(server.sockets) == 1 and _files(own_copy.parent) == {own_copy.name}:
                break
            time.sleep(0.05)

    assert _files(own_copy.parent) == {own_copy.name}


def test_a_file_that_is_not_wanted_after_all_leaves_nothing_and_the_next_one_comes(
    page: PageClient, own_copy: Path
) -> None:
    page.send("upload", name="x.npz", size=500)
    page.wait_for("upload_ready")
    page.send_raw(b"1" * 100)
    page.send("upload_cancel")

    assert page.wait_for("upload_cancelled")["name"] == "x.npz"
    assert _files(own_copy.parent) == {own_copy.name}
    _send(page, "next.npz", own_copy.read_bytes())
    assert page.wait_for("uploaded")["name"] == "next.npz"


def test_a_file_that_is_whole_is_not_cancelled(page: PageClient, own_copy: Path) -> None:
    _send(page, "next.npz", own_copy.read_bytes())
    page.send("upload_cancel")

    assert page.wait_for("uploaded")["name"] == "next.npz"
    assert all(message["type"] != "upload_cancelled" for message in page.heard)


def test_a_piece_of_nothing_is_refused(page: PageClient) -> None:
    page.send_raw(b"123")

    assert "binary" in page.wait_for("refused")["text"]


def _exported(page: PageClient) -> tuple[Path, Message]:
    page.send("export", kind="json")
    path = Path(page.wait_for("saved")["path"])
    return path, json.loads(path.read_text())


def test_another_persons_segment_file_is_taken_beside_the_recording(page: PageClient) -> None:
    path, content = _exported(page)
    _send(page, "Anna's.segments.json", json.dumps(content).encode())

    uploaded = page.wait_for("uploaded")

    assert uploaded["compares"]
    assert uploaded["name"] == "Anna_s.segments.json"
    assert json.loads((path.parent / uploaded["name"]).read_text()) == content


def test_a_segment_file_of_another_recording_is_refused(page: PageClient) -> None:
    path, content = _exported(page)
    content["demonstration"]["sha256"] = "0" * 64
    _send(page, path.name, json.dumps(content).encode())

    assert "another recording" in _refusal(page)


def test_others_are_heard_while_a_large_file_comes(
    own_copy: Path, start_server: StartServer
) -> None:
    server = start_server(own_copy)
    piece = bytes(512 << 10)
    with PageClient(server) as sender, PageClient(server) as other:
        sender.wait_for("document")
        other.wait_for("document")
        sender.send("upload", name="large.npz", size=400 * len(piece))
        sender.wait_for("upload_ready")
        for number in range(400):
            sender.send_raw(piece)
            if number % 50 == 0:
                other.send("seek", time_s=number / 1000)
                other.wait_for("playhead", lambda m, at=number / 1000: m["time_s"] == at)

        assert "large.npz" in _refusal(sender)


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


def test_each_recording_of_a_file_of_many_comes_into_the_list(
    page: PageClient, tmp_path: Path
) -> None:
    path = tmp_path / "low_dim.hdf5"
    with h5py.File(path, "w") as file:
        for name in ("demo_0", "demo_1"):
            seen = file.create_group(f"data/{name}/obs")
            seen["robot0_eef_pos"] = np.linspace(0, 0.2, 90).reshape(30, 3)
            seen["robot0_eef_quat"] = np.tile([0.0, 0.0, 0.0, 1.0], (30, 1))
        file["data"].attrs["env_args"] = json.dumps({"env_kwargs": {"control_freq": 20}})
    _send(page, "low_dim.hdf5", path.read_bytes())

    document = page.wait_for("document", lambda m: m["name"].startswith("low_dim"))
    listed = page.wait_for("recordings", lambda m: len(m["items"]) == 3)

    assert document["name"].endswith("demo_0")
    assert listed["items"][2]["name"].endswith("demo_1")


def test_a_recipe_that_is_sent_reads_what_waited_for_one(page: PageClient, own_copy: Path) -> None:
    _send(page, "log.csv", b"t,a,b,c\n" + b"".join(b"%d,0.%d,0,0\n" % (i, i) for i in range(40)))
    page.wait_for("table")
    recipe = 'time = {column = "t", unit = "s"}\nposition = {columns = ["a", "b", "c"], unit = "m"}'
    _send(page, "recipe.toml", recipe.encode())

    assert page.wait_for("document", lambda m: m["name"] == "log")
    assert _files(own_copy.parent) == {own_copy.name, "log.csv", "recipe.toml"}


def test_a_recipe_never_takes_the_place_of_another(page: PageClient, own_copy: Path) -> None:
    own_copy.with_name("recipe.toml").write_text("# mine")
    _send(page, "recipe.toml", b'position = {columns = "p?", unit = "m"}\ntime = {rate_hz = 10}')

    assert "never replaced" in _refusal(page)
    assert own_copy.with_name("recipe.toml").read_text() == "# mine"
