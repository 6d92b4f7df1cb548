"""Which robot is shown: the YuMi with either arm, or one that a person names."""

from pathlib import Path

from keyphase.errors import RobotError
from keyphase.robot.description import RobotDescription, load_description
from keyphase.robot.yumi import yumi


def yumi_arms() -> tuple[RobotDescription, ...]:
    """The YuMi that comes with keyphase, its right arm first."""
    return yumi("r"), yumi("l")


def robot_arms(path: Path | None, tool_frame: str | None) -> tuple[RobotDescription, ...]:
    """The robot at `path` with the tool frame named; without a path the YuMi.

    Raises RobotError where one is named without the other, or the robot cannot be used.
    """
    if path is None and tool_frame is None:
        return yumi_arms()
    if path is None:
        raise RobotError(
            f"A tool frame belongs to a robot, but only the frame '{tool_frame}' was named; "
            "name the robot's URDF with --robot."
        )
    if tool_frame is None:
        raise RobotError(
            f"{path}: a robot needs a link that is its tool, but none was named; "
            "name it with --tool-frame."
        )
    return (load_description(path, tool_frame),)
