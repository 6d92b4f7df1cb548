"""A replay that is over as one page that opens without a server."""

import numpy as np
import viser

from keyphase.robot.yumi import yumi
from keyphase.simulation.replay.result import Frame, ReplayResult, ReplayState
from keyphase.simulation.replay.shared_page import with_summary
from keyphase.skills.execution.executor import STEP_S
from keyphase.web.scene.camera import Camera, LastCamera
from keyphase.web.scene.dressing import Dressing
from keyphase.web.scene.figures.robot_figure import RobotFigure
from keyphase.web.scene.palette import LIGHT
from keyphase.web.scene.recording.floor import Floor
from keyphase.web.scene.recording.ground_shadow import GroundShadow
from keyphase.web.scene.replaying.replay_scene import PartPoses, put_up
from keyphase.web.scene.replaying.seen_replay import seen_replay
from keyphase.web.transport.film import film_in
from keyphase.workbench.replaying.running import Running

FRAME_S = 0.04
"""Between two frames of a result."""


def film_of(server: viser.ViserServer, running: Running, shadow: GroundShadow | None) -> str:
    """The page's HTML. Nothing of it is seen by anybody while it is made."""
    result = running.result
    assert result is not None
    client, film = film_in(server)
    dressing = Dressing(client)
    dressing.dress(LIGHT)
    dressing.paint_sky(LIGHT)
    seen = seen_replay(running)
    Floor(client, shadow).draw(LIGHT, seen.ground_m, seen.size_m, seen.base)
    Camera(client, LastCamera()).point(seen.view.position_m, seen.view.look_at_m, None)
    robot = yumi()
    figure = None if seen.base is None else RobotFigure(client, robot, "/robot")
    drawn = put_up(client, running)
    drawn.label()
    for frame in result.frames:
        state = state_at(result, frame.time_s)
        if figure is not None:
            figure.pose(robot, np.asarray(state.sample.joints_rad))
        drawn.draw(state, parts_in(result, frame))
        film.insert_sleep(FRAME_S)
    page = film.as_html(dark_mode=False)
    return with_summary(page, result, running.plan.demonstration)


def state_at(result: ReplayResult, time_s: float) -> ReplayState:
    """The tick nearest to a time."""
    return result.states[min(round(time_s / STEP_S), len(result.states) - 1)]


def parts_in(result: ReplayResult, frame: Frame) -> PartPoses:
    """Where everything that is no link of the robot was."""
    poses = zip(result.bodies, frame.position_m, frame.orientation_wxyz, strict=True)
    return {name: (position, wxyz) for name, position, wxyz in poses}
