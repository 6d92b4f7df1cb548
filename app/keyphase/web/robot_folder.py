"""The Robot folder of viser's panel: which arm follows, and where the robot stands."""

from collections.abc import Callable
from typing import Any

import viser

from keyphase.web.scene.robot_view import RobotView
from keyphase.workbench.telling import Telling

_ARM_HINT = "The tool that follows the recording."
_MOVE_HINT = "Show arrows and arcs at the robot's base; where it is dragged to is kept."
_PLACE_HINT = "Forget where the robot was dragged to: leave it, or put it where it reaches more."


class RobotFolder:
    """Controls of a robot in the scene; add it inside a tab."""

    def __init__(self, server: viser.ViserServer, robot: RobotView, telling: Telling) -> None:
        self._telling = telling
        gui = server.gui
        names = tuple(arm.robot.tool_frame for arm in robot.arms)
        with gui.add_folder("Robot", expand_by_default=False):
            self._arm = gui.add_dropdown("Tool", names, initial_value=names[0], hint=_ARM_HINT)
            self._move = gui.add_checkbox("Move robot", False, hint=_MOVE_HINT)
            place = gui.add_button("Place automatically", hint=_PLACE_HINT)
        self._arm.on_update(self._safely(lambda: robot.use_arm(names.index(self._arm.value))))
        self._move.on_update(self._safely(lambda: robot.offer_moving(self._move.value)))
        place.on_click(self._safely(robot.place_automatically))

    def _safely(self, act: Callable[[], None]) -> Callable[[Any], None]:
        def heard(_event: Any) -> None:
            try:
                act()
            except Exception as error:
                self._telling.report(error)

        return heard
