"""Tells the page, in the scene itself, whose recording stands in it.

A node without anything to see carries the recording's id in its name. viser's client hears of it
after all that was drawn before, so the page knows without another word from the server when it may
stop saying that a recording is being drawn (`page/js/scene/drawing_note.js`).
"""

import viser

ROOT = "/standing"


class StandingMark:
    """The mark in one page's scene; only the thread that draws that scene uses it."""

    def __init__(self, client: viser.ClientHandle) -> None:
        self._client = client
        self._recording: str | None = None
        self._node: viser.FrameHandle | None = None

    def begin(self, recording: str) -> None:
        """A recording, by its id, is about to be drawn; the one that stands is drawn further."""
        if recording != self._recording:
            self.clear()
            self._recording = recording

    def put(self) -> None:
        """All there is to draw of it is drawn, or cannot be."""
        if self._node is None and self._recording is not None:
            name = f"{ROOT}/{self._recording}"
            self._node = self._client.scene.add_frame(name, show_axes=False)
            self._client.flush()

    def clear(self) -> None:
        """No recording is to be seen."""
        if self._node is not None:
            self._node.remove()
        self._recording = self._node = None
