"""The browser is opened without anything on its command line that opens the page for others."""

import contextlib
import multiprocessing
import os
import re
import signal
import subprocess
import sys
import time
import webbrowser
from multiprocessing.connection import Connection
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


@pytest.mark.skipif(not Path("/proc/self/cmdline").exists(), reason="there is no /proc here")
def test_no_command_line_of_this_machine_shows_the_token(own_copy: Path, tmp_path: Path) -> None:
    """What every other user can read of what runs here, the browser among it."""
    browser = tmp_path / "browser"
    browser.write_text("#!/bin/sh\nsleep 60\n")
    browser.chmod(0o700)
    command = [sys.executable, "-c", "from keyphase.cli import main; main()", "open"]
    with subprocess.Popen(
        [*command, str(own_copy)],
        env={**os.environ, "BROWSER": f"{browser} %s &"},
        stdout=subprocess.PIPE,
        text=True,
    ) as process:
        try:
            assert process.stdout is not None
            token = process.stdout.readline().partition("token=")[2].strip()
            lines = _wait_for_command_line("keyphase-open.html")
            assert len(token) == 43
            assert not [line for line in lines if token in line or "?once=" in line]
            assert _seen_by_another_user(process.pid, token) == []
        finally:
            for pid in _children(process.pid):
                os.kill(pid, signal.SIGKILL)
            process.kill()


def _seen_by_another_user(process: int, token: str) -> list[str]:
    """What of it somebody without rights finds in /proc; only root can be somebody else."""
    if os.geteuid() != 0:
        return []
    context = multiprocessing.get_context("fork")
    here, there = context.Pipe()
    other = context.Process(target=_look_as_nobody, args=(there, process, token))
    other.start()
    # One that ends without a word is an error here, not a wait for ever.
    there.close()
    found = here.recv()
    other.join()
    return found


def _look_as_nobody(told: Connection, process: int, token: str) -> None:
    os.setgroups([])
    os.setgid(65534)
    os.setuid(65534)
    names = ("cmdline", "environ", "comm", "stat", "status", "maps", "mem")
    # Named, not listed: a process may be gone by the time its folder would be.
    running = [pid for pid in os.listdir("/proc") if pid.isdigit()]
    files = [Path("/proc", pid, name) for pid in running for name in names]
    private = [Path("/proc", str(process), name) for name in ("mem", "environ", "fd", "cwd")]
    found = [str(path) for path in private if os.access(path, os.R_OK)]
    for file in files:
        with contextlib.suppress(OSError):
            if token.encode() in file.read_bytes():
                found.append(str(file))
    told.send(found)


def _command_lines() -> list[str]:
    """And environments, which root at least can read."""
    lines = []
    running = [pid for pid in os.listdir("/proc") if pid.isdigit()]
    files = [Path("/proc", pid, name) for name in ("cmdline", "environ") for pid in running]
    for file in files:
        with contextlib.suppress(OSError):
            lines.append(file.read_bytes().replace(b"\0", b" ").decode(errors="replace"))
    return lines


def _wait_for_command_line(part: str) -> list[str]:
    for _ in range(400):
        lines = _command_lines()
        if any(part in line for line in lines):
            return lines
        time.sleep(0.05)
    raise AssertionError("no browser was started")


def _children(pid: int) -> list[int]:
    """The processes that were started by `pid`, which is this test's own."""
    found = []
    for file in (Path("/proc", one, "stat") for one in os.listdir("/proc") if one.isdigit()):
        with contextlib.suppress(OSError):
            fields = file.read_text().rpartition(")")[2].split()
            if int(fields[1]) == pid:
                found.append(int(file.parent.name))
    return found
