"""The recording in the scene of one page: path, marks, ground, tool, and where it is seen from.

It holds no logic: it draws what it is told and reports clicks. A document of the same recording
changes colours and a few small things; only another recording builds the stage anew.
"""

from collections.abc import Callable
from dataclasses import dataclass, replace

import viser

from keyphase.demonstration import Array
from keyphase.robot.pose import Placement
from keyphase.web.scene.camera import Camera
from keyphase.web.scene.dressing import Dressing
from keyphase.web.scene.palette import DARK, LIGHT, Theme
from keyphase.web.scene.recording.floor import Floor
from keyphase.web.scene.recording.ground_shadow import GroundShadow
from keyphase.web.scene.recording.marks import EVER, draw_forces, draw_gaussians
from keyphase.web.scene.recording.path import ScenePath
from keyphase.web.scene.recording.path_geometry import MIN_SIZE_M, Path, path_of
from keyphase.web.scene.recording.tail import Tail
from keyphase.web.scene.recording.viewpoint import WITH_ROBOT_M, Viewpoint, viewpoint_of
from keyphase.workbench.desks.desk_state import DeskState
from keyphase.workbench.playback import Playhead
from keyphase.workbench.scene_choices import FIRST_HIDDEN, PARTS

_OWN = tuple(part for part in PARTS if part not in ("robot", "shadows"))
"""The parts that are shown and hidden here."""

_DRAWN = (*(part for part in _OWN if part not in ("parts", "grid", "spread")), "path")
"""What is drawn here and anew for each recording."""


@dataclass(frozen=True, eq=False)
class _Standing:
    """What stands in the scene for one recording."""

    shown: DeskState
    path: Path
    view: Viewpoint
    tube: ScenePath
    tool: viser.FrameHandle
    tail: Tail
    base: Placement | None


class Stage:
    """One page's recording; `robot_base` says where a robot stands beside the path, if one does."""

    def __init__(
        self,
        client: viser.ClientHandle,
        camera: Camera,
        select_at: Callable[[float], None],
        robot_base: Callable[[], Placement | None],
        shadow: GroundShadow | None,
    ) -> None:
        self._client, self._camera = client, camera
        self._select_at, self._robot_base = select_at, robot_base
        self._dressing = Dressing(client)
        self._floor = Floor(client, shadow)
        self._standing: _Standing | None = None
        self._selected: tuple[int, int] | None = None
        self._theme: Theme = LIGHT
        self._hidden = FIRST_HIDDEN
        self._drawn: tuple[object, ...] = ()
        self._playhead = Playhead()
        self._in_view: tuple[str, float, float] | None = None
        self._covered: Viewpoint | None = None
        self._covered_floor: tuple[Array, float, Placement | None] | None = None
        self._dressing.dress(LIGHT)

    def show_document(self, shown: DeskState) -> None:
        """Draw what the document of the recording has become.

        Most moves of a slider change no segment, and then nothing is drawn: a frame of the scene
        would only delay the timeline's.
        """
        standing, drawn = self._standing, _seen_of(shown)
        another = standing is None or standing.shown.demonstration is not shown.demonstration
        if not another and drawn == self._drawn:
            return
        self._drawn = drawn
        if another:
            self.clear()
        self._draw(shown, None if another else standing)

    def clear(self) -> None:
        """Nothing of a recording is seen; another one is on its way."""
        with self._client.atomic():
            self._standing = None
            for part in _DRAWN:
                self._client.scene.remove_by_name(f"/{part}")
            self._floor.clear()
        self._client.flush()

    def show_selection(self, stretch: tuple[int, int] | None) -> None:
        """Draw the segments from the first to the last selected as they are, the rest faintly."""
        if stretch == self._selected:
            return
        self._selected = stretch
        if self._standing is not None:
            with self._client.atomic():
                self._standing.tube.select(stretch)
                self._draw_forces(self._standing)
            self._client.flush()

    def show_range(self, recording: str, from_s: float, to_s: float) -> None:
        """Draw what of a recording lies in this time, its path with what explains it."""
        self._in_view = recording, from_s, to_s
        if self._standing is not None:
            with self._client.atomic():
                if self._limit(self._standing):
                    self._draw_marks(self._standing)
            self._client.flush()

    def show_playhead(self, playhead: Playhead) -> None:
        """Put the frame where the tool was, and its tail behind it."""
        self._playhead = playhead
        if self._standing is None:
            return
        demonstration = self._standing.shown.demonstration
        index = demonstration.index_at(playhead.time_s)
        with self._client.atomic():
            self._standing.tool.position = demonstration.position_m[index]
            if demonstration.orientation_wxyz is not None:
                self._standing.tool.wxyz = demonstration.orientation_wxyz[index]
            if "frame" not in self._hidden:
                self._standing.tail.follow(demonstration, playhead.time_s)

    def show_parts(self, hidden: frozenset[str]) -> None:
        """Hide these parts and show the others."""
        self._dressing.cast_shadows("shadows" not in hidden)
        self._hidden = hidden
        self._place_parts()
        self.show_playhead(self._playhead)

    def cover(
        self, view: Viewpoint, ground_m: Array, size_m: float, base: Placement | None, of: object
    ) -> None:
        """Hide the recording: something else is to be seen there, from `view`.

        It is of that size, above a ground whose middle is `ground_m` (3,), and belongs to a robot
        at `base`, if to one.
        """
        self._covered = view
        self._place_parts()
        self._covered_floor = ground_m, size_m, base
        self._draw_covered_floor()
        self._camera.look(self._covered, of)

    def uncover(self) -> None:
        """Show the recording again."""
        self._covered = None
        self._place_parts()
        if self._standing is not None:
            self._draw_floor(self._standing)
            self._camera.look(self._standing.view, self._standing.shown.demonstration)

    def stand_anew(self) -> None:
        """The robot stands elsewhere, has appeared or gone: ground at its feet, another view."""
        standing, base = self._standing, self._robot_base()
        if standing is not None and standing.base != base:
            self._draw(standing.shown, None)

    def show_theme(self, dark: bool) -> None:
        """Draw light or dark."""
        theme = DARK if dark else LIGHT
        if theme is self._theme:
            return
        self._theme = theme
        self._dressing.dress(theme)
        self._draw_covered_floor()
        if self._standing is not None:
            self._standing.tail.paint(theme)
            self._draw_floor(self._standing)
            self._draw_forces(self._standing)

    def _draw(self, shown: DeskState, standing: _Standing | None) -> None:
        """Put what was found into what stands there, built first if nothing does."""
        with self._client.atomic():
            standing = replace(standing, shown=shown) if standing else self._build(shown)
            self._standing = standing
            standing.tube.color(shown.labeling)
            self._draw_marks(standing)
        self._client.flush()

    def _build(self, shown: DeskState) -> _Standing:
        self._place_parts()
        base, demonstration = self._robot_base(), shown.demonstration
        path = path_of(demonstration, MIN_SIZE_M if base is None else WITH_ROBOT_M)
        tool = self._client.scene.add_frame(
            "/frame/tool",
            axes_length=0.13 * path.size_m,
            axes_radius=0.55 * path.radius_m,
            origin_radius=1.6 * path.radius_m,
            position=demonstration.position_m[0],
        )
        tube = ScenePath(self._client, path, self._select_at)
        tube.select(self._selected)
        tail = Tail(self._client, path.radius_m, self._theme)
        standing = _Standing(shown, path, viewpoint_of(path, base), tube, tool, tail, base)
        self._standing = standing
        self._limit(standing)
        self.show_playhead(self._playhead)
        self._draw_floor(standing)
        if self._covered is None:
            self._camera.look(standing.view, demonstration)
        return standing

    def _limit(self, standing: _Standing) -> bool:
        return standing.tube.limit(*self._range_of(standing))

    def _range_of(self, standing: _Standing) -> tuple[float, float]:
        """From when to when the recording is drawn."""
        if self._in_view is None or self._in_view[0] != standing.shown.recording.id:
            return EVER
        return self._in_view[1:]

    def _place_parts(self) -> None:
        for part in _OWN:
            visible = part not in self._hidden and (part == "grid" or self._covered is None)
            self._client.scene.add_frame(f"/{part}", show_axes=False, visible=visible)

    def _draw_floor(self, standing: _Standing) -> None:
        if self._covered is None:
            self._floor.draw_below(self._theme, standing.path, standing.base)

    def _draw_covered_floor(self) -> None:
        if self._covered is not None and self._covered_floor is not None:
            self._floor.draw(self._theme, *self._covered_floor)

    def _draw_marks(self, standing: _Standing) -> None:
        in_view = self._range_of(standing)
        draw_gaussians(self._client, standing.shown.labeling, standing.path, in_view)
        self._draw_forces(standing)

    def _draw_forces(self, standing: _Standing) -> None:
        draw_forces(
            self._client,
            standing.shown.labeling,
            standing.path,
            self._theme,
            self._selected,
            self._range_of(standing),
        )


def _seen_of(shown: DeskState) -> tuple[object, ...]:
    """What of a document is seen in the scene; equal where it would look the same."""
    labeling = shown.labeling
    cuts = tuple((b.time_s, b.origin, b.contact_change) for b in labeling.boundaries)
    gaussians = tuple((g.mean_time_s, g.sigma_time_s) for g in labeling.segmentation.gaussians)
    return labeling.segments, cuts, gaussians
