"""The shapes of the shells, link by link, each in its link's frame, metres.

Modelled by eye after photographs and the published joint origins; no manufacturer's geometry.
"""

from collections.abc import Callable, Mapping
from dataclasses import dataclass

import numpy as np
import trimesh
from distance_fields import (
    Array,
    Field,
    box,
    cut,
    cylinder,
    ellipsoid,
    half_space,
    prism,
    round_cone,
    union,
)
from meshing import mesh_of
from numpy.typing import ArrayLike
from scipy.interpolate import PchipInterpolator

Y, Z = np.array([0.0, 1.0, 0.0]), np.array([0.0, 0.0, 1.0])
UP_IN_BODY = 0.41492
"""Height of both shoulders over the body's frame (published)."""


@dataclass(frozen=True)
class Piece:
    """A mesh of one material."""

    mesh: trimesh.Trimesh
    material: str


def moulded(
    field: Field,
    low: ArrayLike,
    high: ArrayLike,
    faces: int,
    cell: float = 0.0014,
    material: str = "shell",
) -> Piece:
    """A piece from a signed distance within two corners."""
    return Piece(mesh_of(field, np.asarray(low), np.asarray(high), cell, faces), material)


def disc(
    start: ArrayLike, end: ArrayLike, radius: float, material: str, rim: float = 0.0015
) -> Piece:
    """A turned disc between two points with rounded rims."""
    start, along = np.asarray(start, float), np.subtract(end, start)
    height = float(np.linalg.norm(along))
    rim = min(rim, height / 2.01)
    turn = np.linspace(0, np.pi / 2, 4)
    lower = np.column_stack([radius - rim + rim * np.sin(turn), rim - rim * np.cos(turn)])
    upper = np.column_stack([radius - rim + rim * np.cos(turn), height - rim + rim * np.sin(turn)])
    mesh = trimesh.creation.revolve(np.vstack([[0, 0], lower, upper, [0, height]]), sections=40)
    mesh.apply_transform(trimesh.geometry.align_vectors(Z, along / height))
    mesh.apply_translation(start)
    return Piece(trimesh.graph.smooth_shade(mesh, angle=np.radians(40)), material)


def elbow(foot: float, hub: ArrayLike, hub_radius: float, length: float, neck: float) -> Field:
    """A link that rises from a flange and ends in a drum on the side -y of `hub`."""
    hub = np.asarray(hub, float)
    blend = 0.045 if foot > 0.045 else 0.035
    flange = cylinder((0, 0, 0), (0, 0, 0.03), foot, 0.006, foot * 0.93)
    drum = cylinder(hub - 0.006 * Y, hub - length * Y, hub_radius, 0.009)
    rise = round_cone(
        (0, -length * 0.35, 0.02), hub - Y * (length * 0.5 - 0.002), foot * 0.72, neck
    )
    body = union(flange, union(drum, rise, blend=blend), blend=blend)
    # The blend swells past the drum's face, which is flat on the robot.
    return cut(body, half_space(1, -length - 0.0005), blend=0.006)


def limb(drum: float, length: float, end: ArrayLike, end_radius: float, start: float) -> Field:
    """A link that starts as a drum below z = 0 and becomes a barrel along y."""
    end = np.asarray(end, float)
    middle = end[1] * 0.44
    socket = cylinder((0, 0, -length), (0, 0, -0.006), drum, 0.009)
    barrel = cylinder((end[0], middle, 0), end - 0.005 * Y, start, 0.008, end_radius)
    neck = round_cone(
        (0, 0, -length * 0.5), (end[0] * 0.85, middle + 0.03, -0.004), drum * 0.8, start * 0.86
    )
    blend = 0.045 if end_radius > 0.05 else 0.04
    body = union(socket, union(barrel, neck, blend=blend), blend=blend)
    return cut(body, half_space(2, -length - 0.0005), blend=0.006)


def link_1() -> list[Piece]:
    """Shoulder."""
    shell = elbow(0.060, (0.03, 0, 0.1), 0.0485, 0.078, 0.043)
    return [
        moulded(shell, (-0.065, -0.08, 0), (0.085, 0.065, 0.152), 3000),
        disc((0.03, -0.0765, 0.1), (0.03, -0.0805, 0.1), 0.036, "cap"),
        disc((0, 0, -0.006), (0, 0, 0.002), 0.053, "joint", 0.002),
    ]


def link_2() -> list[Piece]:
    """Upper arm."""
    shell = limb(0.048, 0.078, (-0.03, 0.17283, 0), 0.053, 0.040)
    return [
        moulded(shell, (-0.09, -0.05, -0.08), (0.05, 0.175, 0.056), 3000),
        disc((0, 0, -0.0765), (0, 0, -0.0805), 0.036, "cap"),
        disc((0, 0, -0.008), (0, 0, 0.008), 0.044, "joint", 0.002),
    ]


def link_3() -> list[Piece]:
    """Upper elbow."""
    shell = elbow(0.047, (-0.04188, 0, 0.07873), 0.0475, 0.079, 0.040)
    return [
        moulded(shell, (-0.093, -0.08, 0), (0.05, 0.05, 0.13), 3000),
        disc((-0.04188, -0.0775, 0.07873), (-0.04188, -0.0815, 0.07873), 0.034, "cap"),
        disc((0, 0, -0.006), (0, 0, 0.002), 0.043, "joint", 0.002),
    ]


def link_4() -> list[Piece]:
    """Forearm."""
    shell = limb(0.0475, 0.078, (0.0405, 0.16461, 0), 0.0445, 0.036)
    return [
        moulded(shell, (-0.05, -0.05, -0.08), (0.09, 0.167, 0.05), 3000),
        disc((0, 0, -0.0765), (0, 0, -0.0805), 0.034, "cap"),
        disc((0, 0, -0.008), (0, 0, 0.008), 0.043, "joint", 0.002),
    ]


def link_5() -> list[Piece]:
    """Wrist."""
    shell = elbow(0.040, (-0.027, 0, 0.10039), 0.0325, 0.068, 0.029)
    return [
        moulded(shell, (-0.062, -0.072, 0), (0.043, 0.043, 0.135), 2600),
        disc((-0.027, -0.0665, 0.10039), (-0.027, -0.0702, 0.10039), 0.023, "cap"),
        disc((0, 0, -0.006), (0, 0, 0.002), 0.037, "joint", 0.002),
    ]


def link_6() -> list[Piece]:
    """Hand."""
    pod = union(
        cylinder((0, 0, -0.062), (0, 0, -0.003), 0.0325, 0.012),
        ellipsoid((0.018, -0.018, -0.022), (0.049, 0.047, 0.043)),
        cylinder((0.027, -0.03, -0.004), (0.027, 0.0285, -0.002), 0.034, 0.005),
        blend=0.030,
    )
    return [
        moulded(pod, (-0.04, -0.07, -0.07), (0.075, 0.03, 0.035), 2600),
        disc((0, 0, -0.006), (0, 0, 0.026), 0.0205, "joint", 0.002),
    ]


def link_7() -> list[Piece]:
    """Tool flange."""
    return [disc((0, 0, -0.002), (0, 0, 0.0068), 0.0315, "joint", 0.0012)]


def sensor() -> list[Piece]:
    """Force/torque sensor; its frame is at the tool side."""
    return [
        disc((0, 0, -0.0122), (0, 0, -0.0066), 0.020, "sensor", 0.001),
        disc((0, 0, -0.0066), (0, 0, -0.0054), 0.0188, "joint", 0.0004),
        disc((0, 0, -0.0054), (0, 0, 0), 0.020, "sensor", 0.001),
    ]


def gripper() -> list[Piece]:
    """Gripper housing with the slot its jaws slide in."""
    housing = union(
        box((0, 0, 0.036), (0.040, 0.033, 0.036), 0.020),
        box((0, 0, 0.062), (0.036, 0.027, 0.026), 0.012),
        blend=0.02,
    )
    slot = box((0, 0, 0.092), (0.034, 0.0145, 0.012), 0.002)
    rails = box((0, 0, 0.084), (0.033, 0.0135, 0.0035), 0.001)
    shell = cut(housing, slot, blend=0.003)
    band = cut(
        lambda points: housing(points) - 0.0003,
        lambda points: 0.0007 - np.abs(points[:, 2] - 0.020),
    )
    return [
        moulded(shell, (-0.045, -0.037, 0), (0.045, 0.037, 0.092), 3000),
        moulded(band, (-0.041, -0.034, 0.018), (0.041, 0.034, 0.022), 500, 0.0006, "joint"),
        moulded(rails, (-0.035, -0.015, 0.08), (0.035, 0.015, 0.09), 300, 0.0009, "joint"),
    ]


def finger() -> list[Piece]:
    """One jaw: a slide beside the other jaw's, and a finger in the middle plane."""
    slide = box((0.012, 0, 0.003), (0.0225, 0.0060, 0.0045), 0.001)
    bar = box((-0.006, 0.0065, 0.028), (0.0045, 0.0085, 0.026), 0.003)
    pad = box((-0.0009, 0.0065, 0.040), (0.0013, 0.0065, 0.012), 0.0005)
    return [
        moulded(
            union(slide, bar, blend=0.004),
            (-0.012, -0.01, -0.003),
            (0.036, 0.017, 0.056),
            900,
            0.0009,
            "joint",
        ),
        moulded(pad, (-0.003, -0.002, 0.026), (0.001, 0.015, 0.054), 200, 0.0006, "rubber"),
    ]


def body() -> list[Piece]:
    """Torso with pedestal, arm rests and shoulders."""
    seats = [(np.array([0.05355, side * 0.0725, UP_IN_BODY]), _shoulder(side)) for side in (-1, 1)]
    shoulders = [
        cylinder(at - out * 0.11, at - out * 0.008, 0.058, 0.010, 0.064) for at, out in seats
    ]
    column = prism(_PROFILE, (-0.2, 0.2), 0.045, _waist)
    deck = prism(_DECK, (-0.185, 0.185), 0.014)
    rests = [prism(_REST, sides, 0.014) for sides in ((-0.195, -0.105), (0.105, 0.195))]
    torso = union(column, deck, *rests, blend=0.03)
    torso = union(torso, box((-0.13, 0, -0.075), (0.215, 0.135, 0.025), 0.012), blend=0.004)
    torso = union(torso, *shoulders, blend=0.035)
    foot = box((-0.13, 0, -0.096), (0.222, 0.142, 0.004), 0.002)
    return [
        moulded(torso, (-0.37, -0.21, -0.11), (0.14, 0.21, 0.485), 14000, 0.0028),
        *(disc(at - out * 0.009, at - out * 0.001, 0.057, "joint", 0.002) for at, out in seats),
        moulded(foot, (-0.36, -0.16, -0.1), (0.10, 0.16, -0.09), 300, 0.0018, "joint"),
    ]


def _shoulder(side: int) -> Array:
    # The published axis of joint 1, mirrored for the left arm.
    return np.array([0.8138, side * 0.3421, 0.4698])


def _waist(points: Array) -> Array:
    heights = [-0.1, 0.0, 0.08, 0.20, 0.34, 0.48]
    width = PchipInterpolator(heights, [0.80, 0.72, 0.63, 0.60, 0.59, 0.53])
    return width(np.clip(points[:, 2], heights[0], heights[-1]))


_PROFILE = [
    (-0.305, 0.015), (-0.316, 0.102), (-0.3, 0.37), (-0.282, 0.413), (-0.234, 0.426),
    (-0.026, 0.426), (0.0, 0.418), (-0.038, 0.387), (-0.159, 0.365), (-0.205, 0.28),
    (-0.194, 0.042), (-0.17, 0.015),
]  # fmt: skip
_DECK = [
    (-0.341, -0.036), (-0.341, 0.016), (-0.301, 0.016), (-0.122, -0.006), (-0.014, -0.024),
    (-0.014, -0.031), (-0.023, -0.036),
]  # fmt: skip
_REST = [
    (-0.341, -0.038), (-0.341, 0.006), (-0.061, -0.002), (0.108, -0.025), (0.112, -0.03),
    (0.111, -0.032), (0.059, -0.038),
]  # fmt: skip

SHELLS: Mapping[str, Callable[[], list[Piece]]] = {
    "body": body,
    "link_1": link_1,
    "link_2": link_2,
    "link_3": link_3,
    "link_4": link_4,
    "link_5": link_5,
    "link_6": link_6,
    "link_7": link_7,
    "sensor": sensor,
    "gripper": gripper,
    "finger": finger,
}
