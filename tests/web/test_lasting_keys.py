"""The keys of a folder's servers outlive them, and nobody else can read them."""

import os
from pathlib import Path

import pytest
from talking import StartServer, cookie, get

from keyphase.web.transport import lasting_keys
from keyphase.web.transport.access import COOKIE_LASTS_S
from keyphase.web.transport.lasting_keys import LastingKeys


@pytest.fixture(autouse=True)
def _own_state(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("XDG_STATE_HOME", str(tmp_path / "state"))


def _file(keys: LastingKeys, port: int) -> Path:
    return keys.folder / f"{port}.json"


def test_a_server_that_comes_back_is_on_its_port_and_knows_its_pages(
    own_copy: Path, start_server: StartServer
) -> None:
    first = start_server(own_copy)
    remembered = cookie(first)
    first.stop()
    second = start_server(own_copy)

    assert second.port == first.port
    assert second.link == first.link
    assert get(second, "/", remembered)[0].status == 200


def test_a_server_beside_it_has_a_port_and_keys_of_its_own(
    own_copy: Path, start_server: StartServer
) -> None:
    first, second = start_server(own_copy), start_server(own_copy)

    assert second.port != first.port
    assert second.access.token != first.access.token


def test_another_folder_has_other_keys(tmp_path: Path) -> None:
    keys = [LastingKeys(tmp_path / name).of(80) for name in "ab"]

    assert keys[0].token != keys[1].token
    assert len({*keys[0].__struct_fields__, keys[0].token, keys[0].looking_token}) == 4


def test_the_file_is_its_owners_only(tmp_path: Path) -> None:
    keys = LastingKeys(tmp_path)
    keys.of(80)

    assert _file(keys, 80).stat().st_mode & 0o777 == 0o600
    assert keys.folder.stat().st_mode & 0o777 == 0o700
    assert keys.folder.parent.stat().st_mode & 0o777 == 0o700


@pytest.mark.parametrize("mode", [0o644, 0o640, 0o604, 0o620])
def test_keys_that_others_could_read_or_change_are_keys_no_more(tmp_path: Path, mode: int) -> None:
    keys = LastingKeys(tmp_path)
    before = keys.of(80)
    _file(keys, 80).chmod(mode)

    assert keys.of(80).token != before.token
    assert _file(keys, 80).stat().st_mode & 0o777 == 0o600


@pytest.mark.parametrize(
    "data",
    [b"", b"{", b"[]", b'{"token":"","looking_token":""}', b"\xff", b"x" * 100_000],
)
def test_a_damaged_file_is_made_anew(tmp_path: Path, data: bytes) -> None:
    keys = LastingKeys(tmp_path)
    keys.of(80)
    _file(keys, 80).write_bytes(data)

    assert len(keys.of(80).token) == 43


def test_a_link_in_its_place_is_not_followed(tmp_path: Path) -> None:
    keys = LastingKeys(tmp_path)
    before = keys.of(80)
    moved = tmp_path / "elsewhere.json"
    _file(keys, 80).rename(moved)
    _file(keys, 80).symlink_to(moved)

    assert keys.of(80).token != before.token
    assert not _file(keys, 80).is_symlink()


def test_keys_end_with_their_cookies(tmp_path: Path) -> None:
    keys = LastingKeys(tmp_path)
    before = keys.of(80)
    old = _file(keys, 80).stat().st_mtime - COOKIE_LASTS_S - 1
    os.utime(_file(keys, 80), (old, old))

    assert keys.ports() == []
    assert keys.of(80).token != before.token


def test_old_keys_are_removed(tmp_path: Path) -> None:
    keys = LastingKeys(tmp_path)
    keys.of(80)
    old = _file(keys, 80).stat().st_mtime - COOKIE_LASTS_S - 1
    os.utime(_file(keys, 80), (old, old))
    keys.of(81)

    assert not _file(keys, 80).exists()


def test_the_port_used_last_comes_first(tmp_path: Path) -> None:
    keys = LastingKeys(tmp_path)
    for port, when in ((80, 0), (81, -10), (82, -5)):
        keys.of(port)
        now = _file(keys, port).stat().st_mtime
        os.utime(_file(keys, port), (now + when, now + when))

    assert keys.ports() == [80, 82, 81]


def test_where_nothing_can_be_kept_a_server_starts_all_the_same(
    own_copy: Path, tmp_path: Path, start_server: StartServer, monkeypatch: pytest.MonkeyPatch
) -> None:
    (tmp_path / "file").write_text("no folder")
    monkeypatch.setenv("XDG_STATE_HOME", str(tmp_path / "file"))
    server = start_server(own_copy)

    assert not lasting_keys.servers_folder().exists()
    assert get(server, "/", cookie(server))[0].status == 200
