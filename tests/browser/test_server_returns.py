"""A server that was killed and comes back is found again by the page that was left open."""

import os
import re
import shutil
import signal
import socket
import subprocess
import sys
from contextlib import closing
from pathlib import Path

from driver import KeyphasePage
from playwright.sync_api import Browser

from keyphase.files.shipped import shipped


def _open(recordings: Path, port: int) -> tuple[subprocess.Popen[str], str]:
    command = [sys.executable, "-c", "from keyphase.cli import main; main()", "open"]
    process = subprocess.Popen(
        [*command, str(recordings), "--no-browser", "--port", str(port)],
        stdout=subprocess.PIPE,
        text=True,
    )
    assert process.stdout is not None
    return process, process.stdout.readline().strip()


def _free_port() -> int:
    with closing(socket.create_server(("127.0.0.1", 0))) as listener:
        return listener.getsockname()[1]


def test_a_killed_server_that_returns_is_used_again_without_a_reload(
    chromium: Browser, tmp_path: Path
) -> None:
    for name in ("a", "b"):
        shutil.copy(shipped("data") / "synthetic_setup1.npz", tmp_path / f"{name}.npz")
    port = _free_port()
    server, link = _open(tmp_path, port)
    page = KeyphasePage(chromium.new_page())
    try:
        page.page.goto(link)
        page.wait_for_document()
        page.press("PageDown")
        page.until("keyphase.state.document.name === 'b'")
        page.page.evaluate("keyphase.actions.goTo(2)")
        page.until("keyphase.state.clock === 2")
        page.page.evaluate("window.neverReloaded = true")
        page.scene.wait_for_function("() => window.__viserMutable?.nodeRefFromName['/path/pieces']")
        os.kill(server.pid, signal.SIGKILL)
        server.wait()
        page.until("!keyphase.state.connected")
        page.page.locator("#banners .gone").wait_for()
        told = page.text("#banners")
        assert re.search(r"stopped\. Everything up to \d\d:\d\d:\d\d is saved", told)

        server, again = _open(tmp_path, port)
        assert again == link
        page.until("keyphase.state.connected && !keyphase.state.readOnly")
        page.until("keyphase.state.document.name === 'b' && keyphase.state.clock === 2")
        assert page.page.locator(".notice").count() == 0
        page.change(lambda: page.press("i"))
        assert page.document["name"] == "b"
        assert page.page.evaluate("window.neverReloaded")
        assert page.document["undo"]
        page.scene.wait_for_function("() => window.__viserMutable?.nodeRefFromName['/path/pieces']")
    finally:
        page.page.close()
        server.kill()
        server.wait()
