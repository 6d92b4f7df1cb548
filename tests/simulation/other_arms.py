"""Arms of others, written for the tests: six axes as URDF, seven as MJCF."""

from pathlib import Path

SIX = ("0 0 1", "0 1 0", "0 1 0", "0 0 1", "0 1 0", "0 0 1")
SEVEN = ("0 0 1", "0 1 0", "0 0 1", "0 1 0", "0 0 1", "0 1 0", "0 0 1")
LINKS_M = {6: (0.1, 0.15, 0.35, 0.15, 0.15, 0.06), 7: (0.1, 0.15, 0.2, 0.2, 0.2, 0.2, 0.06)}
"""From each joint to the one before it, straight up."""


def six_axis_urdf(folder: Path) -> Path:
    """A file of an arm with the links base, link_1 to link_6, and tool0; it has no inertias."""
    joints = "".join(
        f'<link name="link_{n}"/><joint name="axis_{n}" type="revolute">'
        f'<parent link="{"base" if n == 1 else f"link_{n - 1}"}"/><child link="link_{n}"/>'
        f'<origin xyz="0 0 {up}"/><axis xyz="{axis}"/>'
        '<limit lower="-3" upper="3" effort="50" velocity="3"/></joint>'
        for n, (axis, up) in enumerate(zip(SIX, LINKS_M[6], strict=True), start=1)
    )
    tool = (
        '<link name="tool0"/><joint name="flange" type="fixed"><parent link="link_6"/>'
        '<child link="tool0"/><origin xyz="0 0 0.08"/></joint>'
    )
    path = folder / "six.urdf"
    path.write_text(f'<robot name="six"><link name="base"/>{joints}{tool}</robot>')
    return path


def seven_axis_mjcf(folder: Path) -> Path:
    """A file of an arm with the site `grip`, and a finger that is no joint of the arm."""
    inside = (
        '<site name="grip" pos="0 0 0.1"/><body name="finger" pos="0 0.03 0.05">'
        '<joint name="finger" type="slide" axis="0 1 0" range="0 0.03"/>'
        '<geom type="box" size="0.005 0.005 0.02"/></body>'
    )
    for n, (axis, up) in reversed(list(enumerate(zip(SEVEN, LINKS_M[7], strict=True), start=1))):
        inside = (
            f'<body name="link_{n}" pos="0 0 {up}"><joint name="axis_{n}" axis="{axis}" '
            f'range="-170 170"/><geom type="capsule" fromto="0 0 0 0 0 0.05" size="0.03"/>'
            f"{inside}</body>"
        )
    path = folder / "seven.xml"
    path.write_text(f"<mujoco><worldbody>{inside}</worldbody></mujoco>")
    return path
