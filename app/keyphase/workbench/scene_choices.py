"""What a page chose of its 3D scene: parts, theme, the robot beside the recording, gizmos."""

import threading
from collections.abc import Callable
from dataclasses import replace

from keyphase.errors import RequestError
from keyphase.workbench.placing.robot_choice import RobotChoice
from keyphase.workbench.watcher import Watcher

PARTS = (
    "path",
    "gaussians",
    "forces",
    "labels",
    "frame",
    "grid",
    "robot",
    "parts",
    "shadows",
    "spread",
)
"""Parts of the scene that can be shown and hidden."""

FIRST_HIDDEN = frozenset({"shadows", "spread"})
"""The spread is worked out from all finished recordings where it is wanted. Shadows halve the
frames a second where 3D is drawn in software; a page with a graphics card asks for them."""


class SceneChoices:
    """The choices of one page; `each` tells its watchers. For many threads."""

    def __init__(
        self, arms: tuple[str, ...], each: Callable[[Callable[[Watcher], None]], None]
    ) -> None:
        self.hidden = FIRST_HIDDEN
        self.dark = False
        self.push_offered = False
        self.in_view: tuple[str, float, float] | None = None
        self.robot = RobotChoice(arms, arms[0] if arms else "")
        self._each = each
        self._lock = threading.RLock()

    def greet(self, watcher: Watcher) -> None:
        """Tell one that has come what is chosen."""
        with self._lock:
            watcher.show_parts(self.hidden)
            watcher.show_theme(self.dark)
            watcher.show_robot(self.robot)
            watcher.show_push(self.push_offered)
            if self.in_view is not None:
                watcher.show_range(*self.in_view)

    def show(self, part: str, visible: bool) -> None:
        """Show or hide a part of the scene. Raises RequestError for no such part."""
        if part not in PARTS:
            raise RequestError(f"The scene has the parts {', '.join(PARTS)}, but no {part!r}.")
        with self._lock:
            self.hidden = self.hidden - {part} if visible else self.hidden | {part}
            self._each(lambda watcher: watcher.show_parts(self.hidden))

    def look_at(self, recording: str, from_s: float, to_s: float) -> None:
        """Draw what of a recording's path lies in this time."""
        with self._lock:
            self.in_view = recording, from_s, to_s
            self._each(lambda watcher: watcher.show_range(recording, from_s, to_s))

    def set_theme(self, dark: bool) -> None:
        """Draw the scene light or dark."""
        with self._lock:
            self.dark = dark
            self._each(lambda watcher: watcher.show_theme(dark))

    def choose_robot(self, *, arm: str | None = None, moving: bool | None = None) -> None:
        """Another arm, or whether the robot may be moved. Raises RequestError for no such arm."""
        if arm is not None and arm not in self.robot.arms:
            raise RequestError(f"There are the arms {', '.join(self.robot.arms)}, but no other.")
        with self._lock:
            chosen = self.robot if arm is None else replace(self.robot, arm=arm)
            self.robot = chosen if moving is None else replace(chosen, moving=moving)
            self._each(lambda watcher: watcher.show_robot(self.robot))

    def place_robot(self) -> None:
        """Forget where a person put the robot."""
        self._each(lambda watcher: watcher.place_robot())

    def offer_push(self, offered: bool) -> None:
        """Show or hide the gizmo that pushes the tool of a replay."""
        with self._lock:
            self.push_offered = offered
            self._each(lambda watcher: watcher.show_push(offered))
