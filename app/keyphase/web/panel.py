"""viser's panel at the right: the parameters, what is shown, and the exports.

Every control speaks to the session and shows what the session says; it holds nothing itself.
"""

import functools
import math
import time
from collections.abc import Callable
from typing import Any, get_args

import viser

from keyphase.segmentation.parameters import Estimator, Parameters, Variant
from keyphase.web.protocol.dispatch import with_parameter
from keyphase.web.scene.views import View
from keyphase.workbench.opened import Opened
from keyphase.workbench.session import SETTLE_S, Session

AUTOMATIC = "automatic"
MOST_GAUSSIANS = 15

_DECADES = (0.0, 4.0)
_DECADE_MARKS = ((0.0, "1"), (1.0, "10"), (2.0, "100"), (3.0, "1000"), (4.0, "10⁴"))

_SLIDERS: dict[str, tuple[str, float, float, str]] = {
    "force_ratio": (
        "Ratio",
        100.0,
        0.5,
        "How many times its running 2 s median a peak of the error must exceed.",
    ),
    "min_distance_s": ("Min. distance, s", 2.0, 0.01, "Least time between two force peaks."),
    "persistence": (
        "Persistence",
        20.0,
        0.1,
        "How far the force must stay changed after a peak, in noise levels; bumps do not stay.",
    ),
    "merge_tolerance_s": (
        "Tolerance, s",
        1.0,
        0.01,
        "How far apart a force and a position boundary may be and still be one.",
    ),
}

_SHOWN: dict[str, tuple[str, str]] = {
    "gaussians": ("Gaussians", "Ellipsoids of one standard deviation."),
    "forces": ("Contact forces", "The change of force at each contact change, 1 cm per N."),
    "labels": ("Names", "Names of the segments."),
    "frame": ("Tool frame", "The tool at the playhead."),
    "grid": ("Ground", "The grid below the path."),
    "robot": ("Robot", "The robot, its tool at the playhead."),
    "parts": ("Parts", "The parts of the workcell it was recorded in."),
    "shadows": ("Shadows", "Slow where there is no graphics card."),
}


class Panel(View):
    """The panel of one session.

    `record_tab` and `replay_tab` are where the controls for these belong; none where nothing may
    be changed.
    """

    def __init__(
        self, server: viser.ViserServer, session: Session, *, read_only: bool = False
    ) -> None:
        self._gui = server.gui
        self._session = session
        self._changed_at: dict[str, float] = {}
        self._setters: dict[str, Callable[[Any], None]] = {}
        self._shown: dict[str, viser.GuiCheckboxHandle] = {}
        self._gui.main_panel.dock_right()
        self.tabs = self._gui.add_tab_group()
        self.segment_tab = self.tabs.add_tab("Segment")
        with self.segment_tab:
            self._add_segment_tab()
        self.record_tab = None if read_only else self.tabs.add_tab("Record")
        self.replay_tab = None if read_only else self.tabs.add_tab("Replay")
        with self.tabs.add_tab("Export"):
            self._add_export_tab()

    # -- showing what the session says

    def show_document(self, opened: Opened) -> None:
        """Put the parameters in force into the controls, but not into one being dragged."""
        parameters = opened.parameters
        automatic = opened.labeling.segmentation.threshold
        self._show("force_threshold", parameters.force_threshold or automatic)
        for name in ("variant", "estimator", *_SLIDERS):
            self._show(name, getattr(parameters, name))
        count = len(opened.labeling.segmentation.gaussians)
        self._show("gaussians", (parameters.gaussians, count))

    def show_parts(self, hidden: frozenset[str]) -> None:
        """Tick what is shown."""
        for name, checkbox in self._shown.items():
            _set(checkbox, name not in hidden)

    def _show(self, name: str, value: Any) -> None:
        moved = time.monotonic() - self._changed_at.get(name, -math.inf) < 0.9 * SETTLE_S
        if not moved and value is not None:
            self._setters[name](value)

    # -- hearing what a person does

    def _parameter(self, name: str, value: float | str | None) -> None:
        """A control was moved; viser does not say when it was let go, so the session waits."""
        self._changed_at[name] = time.monotonic()
        self._session.set_parameters(lambda p: with_parameter(p, name, value), held=True)
        self._session.settle_parameters()

    def _on_change(self, control: Any, act: Callable[[Any], None]) -> None:
        """Call `act` with the new value when a person changed the control, not when we did."""

        @control.on_update
        def _(event: viser.GuiEvent[Any]) -> None:
            if event.client is not None:
                self._safely(functools.partial(act, control.value))

    def _on_click(self, button: viser.GuiButtonHandle, act: Callable[[], object]) -> None:
        @button.on_click
        def _(_event: viser.GuiEvent[Any]) -> None:
            self._safely(act)

    def _safely(self, act: Callable[[], object]) -> None:
        try:
            act()
        except Exception as error:
            self._session.telling.report(error)

    # -- building

    def _add_segment_tab(self) -> None:
        with self._gui.add_folder("Force"):
            self._add_threshold()
            for name in ("force_ratio", "min_distance_s", "persistence"):
                self._add_slider(name)
        with self._gui.add_folder("Position"):
            self._add_gaussians()
            self._add_choice("variant", "Variant", get_args(Variant), _VARIANT_HINT)
            self._add_choice("estimator", "Boundary at", get_args(Estimator), _ESTIMATOR_HINT)
        with self._gui.add_folder("Combination"):
            self._add_slider("merge_tolerance_s")
        with self._gui.add_folder("Show", expand_by_default=False):
            for name in _SHOWN:
                self._add_shown(name)
        reset = self._gui.add_button("Reset to automatic", hint="All parameters as they were.")
        self._on_click(reset, lambda: self._session.change(Opened.reset_parameters))
        spread = self._gui.add_button(
            "Apply to all…",
            hint="Give these parameters to all recordings of the folder, after a look at what "
            "would change.",
        )
        self._on_click(spread, self._preview_spread)

    def _preview_spread(self) -> None:
        self._session.queue.preview_spread(self._session.current())

    def _add_threshold(self) -> None:
        """A slider in decades, for errors span many, and its value as a number below."""
        hint = "Normalized error a peak must exceed; more gives fewer boundaries."
        low, high = _DECADES
        slider = self._gui.add_multi_slider(
            "Threshold", low, high, 0.005, (1.0,), marks=_DECADE_MARKS, hint=hint
        )
        number = self._gui.add_number("", 10.0, min=0.001, max=1e9, step=0.1, hint=hint)
        self._on_change(slider, lambda v: self._parameter("force_threshold", _rounded(10 ** v[0])))
        self._on_change(number, lambda v: self._parameter("force_threshold", float(v)))

        def show(value: float) -> None:
            _set(slider, (round(min(max(math.log10(value), low), high), 3),))
            _set(number, _rounded(value))

        self._setters["force_threshold"] = show

    def _add_slider(self, name: str) -> None:
        label, high, step, hint = _SLIDERS[name]
        value = float(getattr(Parameters(), name))
        slider = self._gui.add_slider(label, 0.0, high, step, value, hint=hint)
        self._on_change(slider, lambda value: self._parameter(name, float(value)))

        def show(value: float) -> None:
            if value > slider.max:
                slider.max = value
            _set(slider, float(value))

        self._setters[name] = show

    def _add_gaussians(self) -> None:
        numbers = tuple(str(count) for count in range(1, MOST_GAUSSIANS + 1))
        dropdown = self._gui.add_dropdown(
            "Gaussians",
            (AUTOMATIC, *numbers),
            initial_value=AUTOMATIC,
            hint="How many Gaussians the movement is described by; automatic: by the BIC.",
        )
        self._on_change(
            dropdown,
            lambda v: self._parameter("gaussians", int(v) if v.isdigit() else None),
        )

        def show(value: tuple[int | None, int]) -> None:
            given, count = value
            automatic = AUTOMATIC if given else f"{AUTOMATIC} ({count})"
            more = (str(given),) if given and given > MOST_GAUSSIANS else ()
            options = (automatic, *numbers, *more)
            if dropdown.options != options:
                dropdown.options = options
            _set(dropdown, str(given) if given else automatic)

        self._setters["gaussians"] = show

    def _add_choice(self, name: str, label: str, choices: tuple[str, ...], hint: str) -> None:
        dropdown = self._gui.add_dropdown(label, choices, initial_value=choices[0], hint=hint)
        self._on_change(dropdown, lambda value: self._parameter(name, value))
        self._setters[name] = functools.partial(_set, dropdown)

    def _add_shown(self, name: str) -> None:
        label, hint = _SHOWN[name]
        checkbox = self._gui.add_checkbox(label, name not in self._session.hidden, hint=hint)
        self._on_change(checkbox, lambda visible: self._session.show(name, visible))
        self._shown[name] = checkbox

    def _add_export_tab(self) -> None:
        for label, kind, hint in _EXPORTS:
            button = self._gui.add_button(label, hint=hint)
            self._on_click(button, functools.partial(self._session.export, kind))


_VARIANT_HINT = (
    "evidence: a probability for every boundary; paper: thresholds and a mixture, as published."
)
_ESTIMATOR_HINT = (
    "Where between two Gaussians a boundary lies: equally far from both in time, or where the "
    "later one begins to weigh more."
)
_EXPORTS = (
    ("Segment file (JSON)", "json", "Boundaries, segments, end conditions and plan."),
    ("Table (CSV)", "csv", "One line for each segment."),
    ("All recordings (JSON)", "all", "A segment file beside each recording of the list."),
)


def _set(control: Any, value: Any) -> None:
    """Set a control where it shows something else."""
    if control.value != value:
        control.value = value


def _rounded(value: float) -> float:
    """Four figures: what a slider can place and a person can read."""
    return float(f"{value:.4g}")
