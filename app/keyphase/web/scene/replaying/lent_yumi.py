"""The YuMi for whoever moves it by its joints: the one that is in the scene, or one of our own."""

import viser

from keyphase.demonstration import Array
from keyphase.robot.pose import Placement
from keyphase.robot.yumi import yumi
from keyphase.web.scene.figures.robot_figure import RobotFigure
from keyphase.web.scene.page_robot import PageRobot


class LentYumi:
    """Stands at the origin, where workcells have it, between `take` and `give_back`."""

    def __init__(self, client: viser.ClientHandle, shown: PageRobot) -> None:
        self._client, self._shown = client, shown
        self._robot = yumi()
        self._own: RobotFigure | None = None
        self._figure: RobotFigure | None = None
        self._taken = False

    def take(self, runs: bool = True) -> None:
        """Take over the robot that is shown; one of our own where that is no YuMi.

        Where no YuMi `runs`, as in a world made from a recording, none is seen.
        """
        figure = self._shown.lend()
        self._taken, self._figure = True, None
        if not runs:
            figure.visible = False
            if self._own is not None:
                self._own.visible = False
            return
        if not set(figure.links) <= set(self._robot.links):
            figure.visible = False
            self._own = self._own or RobotFigure(self._client, self._robot, "/yumi")
            figure = self._own
        figure.stand(Placement())
        figure.visible = True
        self._figure = figure

    def pose(self, joints_rad: Array) -> None:
        """Take a posture (7,) of the right arm; nothing where no YuMi runs."""
        if self._figure is not None:
            self._figure.pose(self._robot, joints_rad)

    def give_back(self) -> None:
        """The robot that was shown follows the playhead again."""
        if not self._taken:
            return
        self._taken, self._figure = False, None
        if self._own is not None:
            self._own.visible = False
        self._shown.take_back()
