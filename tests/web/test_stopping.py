"""The command that serves the page ends cleanly when it is told to."""

import signal
import subprocess
import sys
from pathlib import Path

import pytest
from talking import PageClient, StartServer


@pytest.mark.slow
@pytest.mark.parametrize("told", [signal.SIGINT, signal.SIGTERM])
def test_the_server_stops_without_a_word(own_copy: Path, told: signal.Signals) -> None:
    command = [sys.executable, "-c", "from keyphase.cli import main; main()"]
    with subprocess.Popen(
        [*command, "open", str(own_copy), "--no-browser"],
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        text=True,
    ) as server:
        assert server.stdout is not None
        link = server.stdout.readline()
        server.send_signal(told)
        rest, errors = server.communicate(timeout=20)

    assert link.startswith("http://127.0.0.1:")
    assert (rest, errors, server.returncode) == ("", "", 0)


def test_the_next_server_may_edit_what_the_first_one_let_go(
    own_copy: Path, start_server: StartServer
) -> None:
    start_server(own_copy).stop()
    with PageClient(start_server(own_copy)) as page:
        assert page.wait_for("document")["locked"] is None
