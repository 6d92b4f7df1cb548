"""While a recording that was just opened is being drawn, the scene says so, and whose it is."""

import shutil
import threading
from pathlib import Path
from typing import Any

import pytest
from driver import KeyphasePage

from keyphase.web.server import PageServer

_NOTE = "#drawing-note:not(:empty)"
_ROBOT_SHOWN = "() => Boolean(window.__viserMutable.nodeRefFromName['/robot']?.visible)"


class _HeldJoints:
    """Joints of a recording are known only when the test lets go, or cannot be known at all."""

    def __init__(self, server: PageServer, monkeypatch: pytest.MonkeyPatch) -> None:
        self.let_go, self.fail = threading.Event(), False
        self._path = server.shared.paths.path
        monkeypatch.setattr(server.shared.paths, "known", lambda *_: None)
        monkeypatch.setattr(server.shared.paths, "path", self.path)

    def path(self, *asked: Any) -> Any:
        assert self.let_go.wait(60.0)
        if self.fail:
            raise RuntimeError("no joints")
        return self._path(*asked)


def test_the_scene_says_what_is_being_drawn_until_it_stands_there_or_cannot(
    scene_editor: KeyphasePage,
    scene_server: PageServer,
    folder: Path,
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    page, note = scene_editor, scene_editor.page.locator(_NOTE)
    page.wait_for_scene()
    note.wait_for(state="detached")
    joints = _HeldJoints(scene_server, monkeypatch)
    other = folder / "other.npz"
    shutil.copy(folder / "setup1.npz", other)
    scene_server.workbench.views[-1].add(other)

    note.wait_for()
    assert page.text(_NOTE) == "drawing other…"
    page.wait_for_scene()
    page.picture("drawing")
    joints.let_go.set()
    note.wait_for(state="detached")
    assert page.scene.evaluate(_ROBOT_SHOWN)

    joints.let_go.clear()
    joints.fail = True
    page.press("PageUp")
    page.page.locator(_NOTE, has_text="drawing setup1…").wait_for()
    joints.let_go.set()
    page.page.locator("#notices", has_text="no joints").wait_for()
    note.wait_for(state="detached")
