"""A robot drawn in the scene: one frame for each link that is seen, moved by whoever knows where.

The links' frames are set directly; viser's own URDF viewer is slower than the page draws.
"""

from typing import Literal

import numpy as np
import trimesh
import viser

from keyphase.demonstration import Array
from keyphase.robot.carried_links import CarriedLinks
from keyphase.robot.description import RobotDescription
from keyphase.robot.pose import Placement
from keyphase.robot.shapes import LinkShape
from keyphase.web.scene.palette import Rgb

Look = Literal["solid", "faded", "ghost"]
"""As it is; grey where it is not where it should be; hardly seen beside what is not its own."""

GREY: Rgb = (150, 150, 150)

_OPACITY: dict[Look, float | None] = {"solid": None, "faded": 0.35, "ghost": 0.12}

UNSEEN = 2e-6
"""Metres, or parts of a quaternion, that nobody sees a link move by."""

PLAIN: Rgb = (190, 192, 192)
"""Where a description gives no colour."""


class RobotFigure:
    """Links and meshes under one base frame; not for several threads at once."""

    def __init__(self, client: viser.ClientHandle, robot: RobotDescription, root: str) -> None:
        self._scene = client.scene
        self._base = client.scene.add_frame(root, show_axes=False)
        self._links: dict[str, viser.FrameHandle] = {}
        self._meshes: list[tuple[viser.MeshHandle, Rgb]] = []
        self._shown: Array | None = None
        self._look: Look = "solid"
        self._carriers: dict[str, str] = {}
        self._known: dict[RobotDescription, CarriedLinks] = {}
        names: dict[str, str] = {}
        seen = {shape.link for shape in robot.shapes}
        for link in _outwards(robot, seen):
            carrier = _carrier(robot, link, seen)
            names[link] = f"{names.get(carrier, root)}/{link}"
            self._carriers[link] = carrier
            self._links[link] = self._scene.add_frame(names[link], show_axes=False)
            self._add_meshes(names[link], [s for s in robot.shapes if s.link == link])

    @property
    def links(self) -> tuple[str, ...]:
        """The links that are seen."""
        return tuple(self._links)

    @property
    def visible(self) -> bool:
        """Whether any of it is drawn."""
        return self._base.visible

    @visible.setter
    def visible(self, visible: bool) -> None:
        self._base.visible = visible

    def stand(self, base: Placement) -> None:
        """Put the robot's base there, in the scene's frame."""
        self._base.position, self._base.wxyz = base.position_m, base.orientation_wxyz

    def pose(self, robot: RobotDescription, joints_rad: Array) -> None:
        """Take a posture (J,) of `robot`, whose links these are; those that stay send nothing."""
        if robot not in self._known:
            self._known[robot] = CarriedLinks(robot, self._carriers)
        poses = self._known[robot].poses(joints_rad)
        before = self._shown if self._shown is not None else np.full_like(poses, np.nan)
        moved = ~(np.abs(poses - before) < UNSEEN)
        shifted, turned = moved[:, :3].any(axis=1), moved[:, 3:].any(axis=1)
        handles = list(self._links.values())
        for row in np.flatnonzero(shifted).tolist():
            handles[row].position = poses[row, :3]
        for row in np.flatnonzero(turned).tolist():
            handles[row].wxyz = poses[row, 3:]
        sent = np.repeat(np.stack([shifted, turned], axis=1), [3, 4], axis=1)
        self._shown = np.where(sent, poses, before)

    def be(self, look: Look) -> None:
        """Look like that."""
        if look == self._look:
            return
        self._look = look
        for mesh, color in self._meshes:
            mesh.color = color if look == "solid" else GREY
            mesh.opacity = _OPACITY[look]
            mesh.cast_shadow = look == "solid"

    def _add_meshes(self, name: str, shapes: list[LinkShape]) -> None:
        """One mesh for each colour, in the link's frame."""
        by_color: dict[Rgb, list[trimesh.Trimesh]] = {}
        for shape in shapes:
            mesh = shape.mesh.copy()
            mesh.apply_transform(shape.origin)
            by_color.setdefault(_color(shape.mesh), []).append(mesh)
        for number, (color, meshes) in enumerate(by_color.items()):
            vertices, faces = _joined(meshes)
            handle = self._scene.add_mesh_simple(
                f"{name}/{number}", vertices, faces, color=color, receive_shadow=True
            )
            self._meshes.append((handle, color))


def _carrier(robot: RobotDescription, link: str, seen: set[str]) -> str:
    """The next link towards the root that is seen; nothing where there is none."""
    model, frame = robot.model, robot.frames[link]
    while frame > 0:
        frame = model.frames[frame].parentFrame
        name = str(model.frames[frame].name)
        if name in seen and robot.frames[name] == frame:
            return name
    return ""


def _outwards(robot: RobotDescription, seen: set[str]) -> list[str]:
    """The links that are seen, each after the one that carries it."""
    order: list[str] = []
    waiting = [link for link in robot.links if link in seen]
    while waiting:
        ready = [link for link in waiting if _carrier(robot, link, seen) in ("", *order)]
        order += ready
        waiting = [link for link in waiting if link not in ready]
    return order


def _joined(meshes: list[trimesh.Trimesh]) -> tuple[Array, np.ndarray]:
    starts = np.cumsum([0, *(len(mesh.vertices) for mesh in meshes[:-1])])
    vertices = np.concatenate([np.asarray(mesh.vertices) for mesh in meshes])
    faces = [np.asarray(mesh.faces) + at for mesh, at in zip(meshes, starts, strict=True)]
    return vertices, np.concatenate(faces)


def _color(mesh: trimesh.Trimesh) -> Rgb:
    """The colour of the whole mesh as a screen shows it; descriptions tell light, not colours."""
    material = getattr(mesh.visual, "material", None)
    linear = getattr(material, "main_color", getattr(mesh.visual, "main_color", None))
    if linear is None:
        return PLAIN
    part = np.asarray(linear[:3], dtype=np.float64) / 255.0
    seen = np.where(part <= 0.0031308, 12.92 * part, 1.055 * part ** (1 / 2.4) - 0.055)
    red, green, blue = np.round(255.0 * seen).astype(int).tolist()
    return red, green, blue
