"""Robots for the tests of this folder."""

from collections.abc import Callable
from pathlib import Path

import pytest

from keyphase.robot.arm import Arm
from keyphase.robot.description import RobotDescription
from keyphase.robot.yumi import yumi

HINGE = (
    '<joint name="hinge" type="revolute"><parent link="base"/><child link="tool"/>'
    '<origin xyz="0 0 1"/><axis xyz="0 1 0"/><limit lower="-1" upper="2" velocity="3" effort="4"/>'
    "</joint>"
)


@pytest.fixture(scope="session")
def robot() -> RobotDescription:
    return yumi("r")


@pytest.fixture(scope="session")
def arm(robot: RobotDescription) -> Arm:
    return Arm(robot)


@pytest.fixture
def hinge() -> str:
    """The one joint of a small URDF."""
    return HINGE


@pytest.fixture
def urdf(tmp_path: Path) -> Callable[..., Path]:
    """Writes a URDF of two links, `base` and `tool`, with the given joints and visual."""

    def write(joints: str = HINGE, visual: str = "", more: str = "") -> Path:
        path = tmp_path / "robot.urdf"
        path.write_text(
            f'<robot name="small"><link name="base"/><link name="tool">{visual}</link>'
            f"{joints}{more}</robot>"
        )
        return path

    return write
