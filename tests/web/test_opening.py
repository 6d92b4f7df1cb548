"""The browser is opened without anything on its command line that opens the page for others."""

import re
import webbrowser
from pathlib import Path

import pytest
from talking import StartServer, get

from keyphase.web.transport import opening


@pytest.fixture
def opened(monkeypatch: pytest.MonkeyPatch) -> list[str]:
    addresses: list[str] = []
    monkeypatch.setattr(webbrowser, "open", lambda address: addresses.append(address))
    monkeypatch.setattr(opening, "_SNAPS", Path("/no/snaps"))
    return addresses


def _link_in(address: str) -> str:
    found = re.search(r'content="0;url=([^"]+)"', Path(address.removeprefix("file://")).read_text())
    assert found
    return found[1]


def test_the_command_line_shows_a_file_that_leads_to_the_page(
    start_server: StartServer, opened: list[str]
) -> None:
    server = start_server()

    assert server.open_browser()

    (address,) = opened
    link = _link_in(address)
    assert server.access.token not in address
    assert server.access.token not in link
    assert link not in address
    assert get(server, link.partition(str(server.port))[2])[0].status == 200
    assert get(server, link.partition(str(server.port))[2])[0].status == 403


def test_only_its_owner_can_read_the_file_and_it_goes_with_the_server(
    start_server: StartServer, opened: list[str]
) -> None:
    server = start_server()
    server.open_browser()
    file = Path(opened[0].removeprefix("file://"))

    assert file.stat().st_mode & 0o777 == 0o600
    assert file.parent.stat().st_mode & 0o777 == 0o700
    server.stop()
    assert not file.exists()


def test_where_no_private_file_can_be_made_no_browser_is_opened(
    start_server: StartServer,
    opened: list[str],
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    (tmp_path / "file").write_text("no folder")
    monkeypatch.setenv("XDG_STATE_HOME", str(tmp_path / "file"))

    assert not start_server().open_browser()
    assert opened == []
