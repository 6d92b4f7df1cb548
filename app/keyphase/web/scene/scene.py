"""The 3D scene of a session: what stands in it, and what of it a change touches.

It holds no logic: it draws what it is told and reports clicks. A document of the same recording
changes colours and a few small things; only another recording builds the scene anew.
"""

import threading
from collections.abc import Callable
from dataclasses import dataclass, replace

import numpy as np
import viser

from keyphase.demonstration import Array
from keyphase.robot.pose import Placement
from keyphase.web.scene.ground import REACH, Ground
from keyphase.web.scene.ground_shadow import SUN_M, GroundShadow
from keyphase.web.scene.marks import draw_forces, draw_gaussians
from keyphase.web.scene.palette import DARK, LIGHT
from keyphase.web.scene.path import ScenePath
from keyphase.web.scene.path_geometry import LEAST_M, Path, path_of
from keyphase.web.scene.viewpoint import (
    FIELD_OF_VIEW_RAD,
    WITH_ROBOT_M,
    Viewpoint,
    viewpoint_of,
    viewpoint_with_robot,
)
from keyphase.workbench.desks.desk_state import DeskState
from keyphase.workbench.playback import Playhead
from keyphase.workbench.scene_choices import FIRST_HIDDEN, PARTS

_OWN = tuple(part for part in PARTS if part not in ("robot", "shadows"))
"""The parts that are shown and hidden here."""

_DRAWN = tuple(part for part in _OWN if part != "parts")
"""The parts that are drawn here and anew for each recording."""


_ABOVE_GROUND_M = 0.001
"""The grid lies so far above the ground, so that it is seen."""


@dataclass(frozen=True, eq=False)
class _Stage:
    """What stands in the scene for one recording."""

    opened: DeskState
    path: Path
    view: Viewpoint
    tube: ScenePath
    tool: viser.FrameHandle
    base: Placement | None


class Scene:
    """viser's scene. `on_click` is told the time at which a person clicked the path.

    `robot_base` says where a robot stands beside the path, if one does, and `shadow` what it
    throws on the ground. It may be told things from several threads: the views' own, and those of
    whoever moves the robot or borrows the scene.
    """

    def __init__(
        self,
        server: viser.ViserServer,
        on_click: Callable[[float], None],
        robot_base: Callable[[], Placement | None] = lambda: None,
        shadow: GroundShadow | None = None,
    ) -> None:
        self._server = server
        self._lock = threading.RLock()
        self._shadow = shadow
        self._on_click = on_click
        self._robot_base = robot_base
        self._stage: _Stage | None = None
        self._selected: int | None = None
        self._theme = LIGHT
        self._hidden = FIRST_HIDDEN
        self._drawn: tuple[object, ...] = ()
        self._cover: Viewpoint | None = None
        self._dress()
        server.on_client_connect(self._point_camera)

    def show_document(self, opened: DeskState) -> None:
        """Draw what the document of the current recording has become.

        Most moves of a slider change no segment, and then nothing is drawn: a frame of the scene
        would only delay the timeline's.
        """
        with self._lock:
            stage, drawn = self._stage, _seen_of(opened)
            another = stage is None or stage.opened.demonstration is not opened.demonstration
            if not another and drawn == self._drawn:
                return
            self._drawn = drawn
            self._draw(opened, None if another else stage)

    def show_selection(self, segment: int | None) -> None:
        """Draw the selected segment thicker."""
        with self._lock:
            if segment == self._selected:
                return
            self._selected = segment
            if self._stage is not None:
                self._stage.tube.select(segment)
                self._server.flush()

    def show_playhead(self, playhead: Playhead) -> None:
        """Put the frame where the tool was."""
        with self._lock:
            if self._stage is None:
                return
            demonstration = self._stage.opened.demonstration
            index = demonstration.index_at(playhead.time_s)
            with self._server.atomic():
                self._stage.tool.position = demonstration.position_m[index]
                if demonstration.orientation_wxyz is not None:
                    self._stage.tool.wxyz = demonstration.orientation_wxyz[index]

    def show_parts(self, hidden: frozenset[str]) -> None:
        """Hide these parts and show the others."""
        with self._lock:
            if ("shadows" in hidden) != ("shadows" in self._hidden):
                self._sun.cast_shadow = "shadows" not in hidden
            self._hidden = hidden
            covered = self._cover is not None
            for part in _OWN:
                visible = part not in hidden and (part == "grid" or not covered)
                self._server.scene.add_frame(f"/{part}", show_axes=False, visible=visible)

    def cover(self, middle_m: Array, size_m: float) -> None:
        """Hide the recording: something else is to be seen there, before a robot at the origin."""
        with self._lock:
            self._cover = viewpoint_with_robot(middle_m, size_m, Placement())
            self.show_parts(self._hidden)
            self._draw_ground(size_m, middle_m * [1.0, 1.0, 0.0])
            self._look(self._cover)

    def uncover(self) -> None:
        """Show the recording again."""
        with self._lock:
            self._cover = None
            self.show_parts(self._hidden)
            if self._stage is not None:
                self._draw_ground(self._stage.path.size_m, _ground_of(self._stage))
                self._look(self._stage.view)

    def stand_anew(self) -> None:
        """The robot stands elsewhere, has appeared or gone: ground at its feet, another view."""
        with self._lock:
            stage, base = self._stage, self._robot_base()
            if stage is None or stage.base == base:
                return
            if stage.base is None or base is None:
                self._draw(stage.opened, None)
                return
            self._stage = stage = replace(stage, base=base, view=viewpoint_of(stage.path, base))
            with self._server.atomic():
                self._draw_ground(stage.path.size_m, _ground_of(stage))
                self._draw_explained(stage)

    def show_theme(self, dark: bool) -> None:
        """Draw light or dark."""
        with self._lock:
            theme = DARK if dark else LIGHT
            if theme is not self._theme:
                self._theme = theme
                self._dress()
                if self._stage is not None:
                    self._draw_ground(self._stage.path.size_m, _ground_of(self._stage))
                    self._draw_explained(self._stage)

    def _draw(self, opened: DeskState, stage: _Stage | None) -> None:
        """Put what was found into what stands there, built first if nothing does."""
        with self._server.atomic():
            stage = stage or self._build(opened)
            stage.tube.color(opened.labeling)
            draw_gaussians(self._server, opened.labeling, stage.path)
            self._draw_explained(stage)
        self._server.flush()

    def _dress(self) -> None:
        """Light, colours of the panel, background."""
        self._server.gui.configure_theme(
            dark_mode=self._theme is DARK,
            show_logo=False,
            show_share_button=False,
            brand_color=self._theme.accent,
        )
        scene = self._server.scene
        scene.configure_default_lights(enabled=False)
        scene.configure_environment_map(None)
        scene.set_background_image(np.full((4, 4, 3), self._theme.sky, np.uint8), format="png")
        scene.add_light_ambient("/lights/ambient", intensity=2.1)
        self._sun = scene.add_light_directional(
            "/lights/sun",
            intensity=1.9,
            position=SUN_M,
            cast_shadow="shadows" not in self._hidden,
        )

    def _build(self, opened: DeskState) -> _Stage:
        for part in _DRAWN:
            self._server.scene.remove_by_name(f"/{part}")
        self.show_parts(self._hidden)
        base = self._robot_base()
        path = path_of(opened.demonstration, LEAST_M if base is None else WITH_ROBOT_M)
        tool = self._server.scene.add_frame(
            "/frame/tool",
            axes_length=0.13 * path.size_m,
            axes_radius=0.55 * path.radius_m,
            origin_radius=1.6 * path.radius_m,
            position=opened.demonstration.position_m[0],
        )
        tube = ScenePath(self._server, path, self._on_click)
        tube.select(self._selected)
        self._stage = _Stage(opened, path, viewpoint_of(path, base), tube, tool, base)
        self._draw_ground(path.size_m, _ground_of(self._stage))
        self._look(self._stage.view)
        return self._stage

    def _draw_ground(self, size_m: float, at_m: Array) -> None:
        """A picture of the ground, and the lines of a grid just above it."""
        base = Placement() if self._cover else self._robot_base()
        x, y, z = at_m.tolist()
        ground = Ground((x, y, z), REACH * size_m)
        cell, side = _round_length(size_m / 3), 2.0 * ground.half_m
        self._server.scene.add_image(
            "/grid/ground",
            ground.picture(self._theme, base, self._shadow),
            side,
            side,
            format="png",
            cast_shadow=False,
            receive_shadow=False,
            position=at_m,
        )
        self._server.scene.add_grid(
            "/grid/lines",
            side,
            side,
            cell_size=cell,
            section_size=5 * cell,
            cell_color=self._theme.cell,
            section_color=self._theme.section,
            plane_opacity=0.0,
            shadow_opacity=self._theme.shade,
            fade_distance=0.9 * ground.half_m,
            fade_strength=1.5,
            fade_from="origin",
            position=(x, y, z + _ABOVE_GROUND_M),
        )

    def _draw_explained(self, stage: _Stage) -> None:
        draw_forces(self._server, stage.opened.labeling, stage.path, self._theme)

    def _look(self, view: Viewpoint) -> None:
        if self._cover not in (None, view):
            return
        camera = self._server.initial_camera
        camera.fov = FIELD_OF_VIEW_RAD
        camera.position, camera.look_at = view.position_m, view.look_at_m
        for client in self._server.get_clients().values():
            self._point_camera(client)

    def _point_camera(self, client: viser.ClientHandle) -> None:
        view = self._cover or (self._stage and self._stage.view)
        if view is None:
            return
        with client.atomic():
            client.camera.fov = FIELD_OF_VIEW_RAD
            client.camera.position, client.camera.look_at = view.position_m, view.look_at_m


def _seen_of(opened: DeskState) -> tuple[object, ...]:
    """What of a document is seen in the scene; equal where it would look the same."""
    labeling = opened.labeling
    cuts = tuple((b.time_s, b.origin, b.contact_change) for b in labeling.boundaries)
    gaussians = tuple((g.mean_time_s, g.sigma_time_s) for g in labeling.segmentation.gaussians)
    return labeling.segments, cuts, gaussians


def _ground_of(stage: _Stage) -> Array:
    """Where the ground is: at the robot's feet, or where they would be if that is just below.

    It never hides the path, which may go below the robot's feet.
    """
    path = stage.path
    x, y = (0.5 * (path.low_m + path.high_m)[:2]).tolist()
    lowest = float(path.low_m[2])
    if stage.base is not None:
        height = min(stage.base.position_m[2], lowest - 2.0 * path.radius_m)
    elif 2.0 * path.radius_m <= lowest <= 0.6 * path.size_m:
        height = 0.0
    else:
        height = lowest - 0.08 * path.size_m
    return np.array([x, y, height])


def _round_length(length_m: float) -> float:
    """The nearest of 1, 2 and 5 times a power of ten."""
    steps = np.array([1.0, 2.0, 5.0, 10.0]) * 10.0 ** np.floor(np.log10(length_m))
    return float(steps[np.argmin(np.abs(np.log(steps / length_m)))])
