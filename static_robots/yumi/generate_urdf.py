"""Write yumi.urdf from figures.py and the shells (whose hulls give the inertias).

python static_robots/yumi/generate_urdf.py [--to FILE]
"""

import argparse
from collections.abc import Iterator
from dataclasses import replace
from pathlib import Path
from xml.etree import ElementTree

import numpy as np
import trimesh
from figures import (
    BODY_HEIGHT_M,
    CHAIN,
    COLLISION,
    FINGER_ORIGIN_M,
    FINGER_STROKE_M,
    FLANGE_M,
    MASS_KG,
    SENSOR_HEIGHT_M,
    SENSOR_MASS_KG,
    SHOULDER,
    SHOULDERS,
    TOOL_POINT_M,
    Joint,
    Solid,
    Triple,
)

FOLDER = Path(__file__).parent
NOTHING: Triple = (0, 0, 0)
HALF_TURN: Triple = (0, 0, float(np.pi))
Element = ElementTree.Element


def main() -> None:
    """Write the description, by default beside this script."""
    parser = argparse.ArgumentParser(description="Write the YuMi's URDF.")
    parser.add_argument("--to", type=Path, default=FOLDER / "yumi.urdf", metavar="FILE")
    parser.parse_args().to.write_text(urdf(), encoding="utf-8")


def urdf() -> str:
    """The whole robot as XML."""
    robot = Element("robot", name="yumi")
    # MuJoCo reads no GLB, and would merge the sensor and tool frames into the hand.
    mujoco = ElementTree.SubElement(robot, "mujoco")
    _child(mujoco, "compiler", discardvisual="true", fusestatic="false", balanceinertia="true")
    robot.append(Element("link", name="yumi_base_link"))
    robot.append(fixed("yumi_body_joint", "yumi_base_link", "yumi_body", (0.0, 0.0, BODY_HEIGHT_M)))
    robot.append(link("yumi_body", "body"))
    for side in "rl":
        robot.extend(arm(side))
        robot.extend(hand(side))
    ElementTree.indent(robot)
    text = ElementTree.tostring(robot, encoding="unicode")
    return f'<?xml version="1.0" encoding="utf-8"?>\n{text}\n'


def arm(side: str) -> Iterator[Element]:
    """Seven joints and links from the body to the flange."""
    xyz, rpy = SHOULDERS[side]
    first = replace(SHOULDER, xyz_m=xyz, rpy_rad=rpy)
    parent = "yumi_body"
    for number, joint in enumerate((first, *CHAIN), start=1):
        name = f"yumi_link_{number}_{side}"
        yield revolute(f"yumi_joint_{joint.name}_{side}", parent, name, joint)
        yield link(name, f"link_{number}")
        parent = name


def hand(side: str) -> Iterator[Element]:
    """Flange, sensor, gripper with two fingers, and tool point."""
    flange, sensor, base = f"tool0_{side}", f"ft_{side}", f"gripper_{side}_base"
    yield fixed(f"{flange}_joint", f"yumi_link_7_{side}", flange, (0, 0, FLANGE_M), HALF_TURN)
    yield half_sensor(flange, visible=False)
    yield fixed(f"{sensor}_joint", flange, sensor, (0, 0, SENSOR_HEIGHT_M))
    yield half_sensor(sensor, visible=True)
    yield fixed(f"{base}_joint", sensor, base, NOTHING)
    yield link(base, "gripper")
    x, y, z = FINGER_ORIGIN_M
    right, left = f"gripper_{side}_finger_r", f"gripper_{side}_finger_l"
    yield sliding(f"gripper_{side}_joint", base, right, (x, -y, z), NOTHING)
    yield link(right, "finger")
    follower = sliding(f"gripper_{side}_joint_m", base, left, (x, y, z), HALF_TURN)
    _child(follower, "mimic", joint=f"gripper_{side}_joint")
    yield follower
    yield link(left, "finger")
    yield fixed(f"tcp_{side}_joint", base, f"tcp_{side}", (0, 0, TOOL_POINT_M))
    yield Element("link", name=f"tcp_{side}")


def link(name: str, shell: str) -> Element:
    """A link with the shell's mesh, its collision shapes and inertia."""
    element = Element("link", name=name)
    geometry = _child(_child(element, "visual"), "geometry")
    _child(geometry, "mesh", filename=f"shells/{shell}.glb")
    for solid in COLLISION.get(shell, ()):
        element.append(collision(solid))
    hull = _hull(shell)
    hull.density = MASS_KG[shell] / hull.volume
    _add_inertial(element, MASS_KG[shell], hull.center_mass, hull.moment_inertia)
    return element


def half_sensor(name: str, visible: bool) -> Element:
    """Half of the sensor's mass: its robot side on the flange, its tool side beyond."""
    element = Element("link", name=name)
    if visible:
        geometry = _child(_child(element, "visual"), "geometry")
        _child(geometry, "mesh", filename="shells/sensor.glb")
    mass, height, radius = SENSOR_MASS_KG / 2, SENSOR_HEIGHT_M / 2, 0.020
    across = mass * (3 * radius**2 + height**2) / 12
    inertia = np.diag([across, across, mass * radius**2 / 2])
    middle = -height / 2 if visible else height / 2
    _add_inertial(element, mass, np.array([0, 0, middle]), inertia)
    return element


def collision(solid: Solid) -> Element:
    """A box or a cylinder in the link's frame."""
    element = Element("collision")
    turn = (float(np.pi / 2), 0.0, 0.0) if solid.axis == "y" else NOTHING
    _child(element, "origin", xyz=_text(solid.centre_m), rpy=_text(turn))
    geometry = _child(element, "geometry")
    if len(solid.size_m) == 3:
        _child(geometry, "box", size=_text(solid.size_m))
    else:
        radius, length = solid.size_m
        _child(geometry, "cylinder", radius=_text([radius]), length=_text([length]))
    return element


def revolute(name: str, parent: str, child: str, joint: Joint) -> Element:
    """A joint about z with its limits."""
    element = _joint(name, "revolute", parent, child, joint.xyz_m, joint.rpy_rad)
    _child(element, "axis", xyz="0 0 1")
    lower, upper = np.radians(joint.range_deg)
    _child(
        element,
        "limit",
        lower=_text([lower]),
        upper=_text([upper]),
        velocity=_text([np.radians(joint.speed_deg_s)]),
        effort=_text([joint.torque_Nm]),
    )
    return element


def sliding(name: str, parent: str, child: str, xyz: Triple, rpy: Triple) -> Element:
    """A finger's slide; its position is the distance from the middle plane."""
    element = _joint(name, "prismatic", parent, child, xyz, rpy)
    _child(element, "axis", xyz="-1 0 0")
    _child(
        element,
        "limit",
        lower="0",
        upper=_text([FINGER_STROKE_M]),
        velocity="0.025",
        effort="20",
    )
    return element


def fixed(name: str, parent: str, child: str, xyz: Triple, rpy: Triple = NOTHING) -> Element:
    """A rigid connection."""
    return _joint(name, "fixed", parent, child, xyz, rpy)


def _joint(name: str, kind: str, parent: str, child: str, xyz: Triple, rpy: Triple) -> Element:
    element = Element("joint", name=name, type=kind)
    _child(element, "parent", link=parent)
    _child(element, "child", link=child)
    _child(element, "origin", xyz=_text(xyz), rpy=_text(rpy))
    return element


def _add_inertial(link: Element, mass: float, centre: np.ndarray, inertia: np.ndarray) -> None:
    element = _child(link, "inertial")
    _child(element, "origin", xyz=_text(centre, digits=4))
    _child(element, "mass", value=_text([mass]))
    entries = {"ixx": (0, 0), "iyy": (1, 1), "izz": (2, 2), "ixy": (0, 1), "ixz": (0, 2)}
    entries["iyz"] = (1, 2)
    _child(element, "inertia", **{k: _text([inertia[at]], digits=4) for k, at in entries.items()})


def _hull(shell: str) -> trimesh.Trimesh:
    scene = trimesh.load_scene(FOLDER / "shells" / f"{shell}.glb")
    return scene.to_mesh().convex_hull


def _child(parent: Element, tag: str, **attributes: str) -> Element:
    return ElementTree.SubElement(parent, tag, attributes)


def _text(values, digits: int = 16) -> str:
    return " ".join(f"{float(value) + 0.0:.{digits}g}" for value in values)


if __name__ == "__main__":
    main()
