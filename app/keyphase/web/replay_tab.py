"""The Replay tab of viser's panel: the world, the run, and what became of each skill."""

from collections.abc import Callable
from dataclasses import replace
from functools import partial
from typing import Any, get_args

import viser

from keyphase.web.replay_outcomes import outcome_table
from keyphase.web.scene.replay_view import ReplayView, Running
from keyphase.web.scene.views import View
from keyphase.workbench.opened import Opened
from keyphase.workbench.replay_session import ReplaySession
from keyphase.workbench.replay_settings import SPEEDS, WORKCELLS, EndBy, ReplaySettings
from keyphase.workbench.replay_trials import TrialsRun
from keyphase.workbench.telling import Telling

STEP, STOP = "Step", "Stop"

HIGHEST_MM = 20.0
FURTHEST_ASIDE_MM = 10.0

_WORKCELL_HINT = "The workcell the plan runs in."
_HEIGHT_HINT = "The table with all on it is higher than it was, mm."
_ASIDE_HINT = "The part to be met lies aside, mm."
_END_HINT = (
    "contact: skills that met a contact end at it again; configuration: all skills end at their "
    "demonstrated pose, whatever is touched."
)
_PUSH_HINT = "Arrows at the tool: drag them, and a spring pulls the tool along while it runs."
_STEER_HINT = "Step goes on until the skill that runs has ended. Esc stops at once."
_WORLDS_HINT = (
    "Each with parts up to 10 mm higher or lower and 5 mm aside, friction 0.2 to 0.6 and twice the "
    "sensor noise."
)
_SHARE_HINT = "The replay that is over as one page that opens without a server."
_EXPORTS = (
    ("Behaviour tree (XML)", "behavior tree", "For BehaviorTree.CPP, with its skills beside it."),
    ("Program listing", "program", "The plan as text that people read."),
    ("Skills (JSON)", "skills", "The skills as data."),
)
_NOTHING = "Run replays the plan: every kept segment, in its order."


class ReplayTab(ReplayView):
    """Controls of one replay session; add it inside a tab.

    `offer_push` shows the gizmo or hides it, `share` writes the replay as a page of its own.
    """

    def __init__(
        self,
        server: viser.ViserServer,
        session: ReplaySession,
        telling: Telling,
        offer_push: Callable[[bool], None],
        share: Callable[[], None],
    ) -> None:
        self._gui, self._session, self._telling = server.gui, session, telling
        with self._gui.add_folder("Workcell"):
            self._workcell = self._choice("Scene", WORKCELLS, "workcell", _WORKCELL_HINT)
            self._height = self._millimetres(
                "Part height", HIGHEST_MM, "part_height_m", _HEIGHT_HINT
            )
            self._aside = self._millimetres(
                "Part aside", FURTHEST_ASIDE_MM, "part_aside_m", _ASIDE_HINT
            )
            self._end_by = self._choice("End by", get_args(EndBy), "end_by", _END_HINT)
        with self._gui.add_folder("Run"):
            low, high = SPEEDS
            self._speed = self._gui.add_slider("Speed", low, high, 0.05, 1.0, hint="× real time.")
            self._on_change(self._speed, lambda value: self._configure(speed=float(value)))
            self._steer = self._gui.add_button_group("", ("Run", STEP, STOP), hint=_STEER_HINT)
            self._steer.on_click(lambda _event: self._safely(self._steered))
            push = self._gui.add_checkbox("Push gizmo", False, hint=_PUSH_HINT)
            self._on_change(push, offer_push)
        self._hint = self._gui.add_markdown(_NOTHING)
        self._table = self._gui.add_html("", visible=False)
        self._keep = self._button("Open its recording", session.keep, visible=False)
        self._leave = self._button("Close the replay", session.leave, visible=False)
        with self._gui.add_folder("Trials", expand_by_default=False):
            self._count = self._gui.add_slider("Worlds", 10, 200, 10, 20, hint=_WORLDS_HINT)
            self._button("Run trials", lambda: session.run_trials(int(self._count.value)))
            self._cancel = self._button("Cancel trials", session.cancel_trials, visible=False)
            self._trials = self._gui.add_markdown("")
        with self._gui.add_folder("Carry on elsewhere", expand_by_default=False):
            for label, kind, hint in _EXPORTS:
                self._button(label, partial(session.export, kind), hint=hint)
            self._share = self._button("Shareable replay (HTML)", share, hint=_SHARE_HINT)

    def show_settings(self, settings: ReplaySettings) -> None:
        """Show what was chosen."""
        _set(self._workcell, settings.workcell)
        _set(self._end_by, settings.end_by)
        _set(self._speed, settings.speed)
        _set(self._height, round(1e3 * settings.part_height_m, 3))
        _set(self._aside, round(1e3 * settings.part_aside_m, 3))

    def show_begun(self, running: Running) -> None:
        """A replay begins."""
        self.show_status(running)

    def show_status(self, running: Running) -> None:
        """What has ended so far, and what can be done now."""
        is_over = running.phase == "over"
        self._offer({"running": "Pause", "paused": "Go on", "over": "Again"}[running.phase])
        _put(self._keep, "visible", is_over and running.result is not None)
        _put(self._leave, "visible", is_over)
        self._show_table(outcome_table(running))

    def show_closed(self) -> None:
        """Nothing runs."""
        self._offer("Run")
        self._show_table("")
        for button in (self._keep, self._leave):
            _put(button, "visible", False)

    # -- hearing what a person does

    def show_trials(self, trials: TrialsRun) -> None:
        """How many worlds of the trials are done, or what came of them in one line."""
        _put(self._cancel, "visible", not trials.over)
        on_the_way = f"{trials.done} of {trials.count} worlds"
        _put(self._trials, "content", trials.outcome or "" if trials.over else on_the_way)

    def _steered(self) -> None:
        {
            STEP: self._session.next_skill,
            STOP: self._session.stop,
            "Pause": self._session.pause,
        }.get(self._steer.value, self._session.go_on)()

    def _offer(self, first: str) -> None:
        _put(self._steer, "options", (first, STEP, STOP))

    def _configure(self, **chosen: Any) -> None:
        self._session.configure(lambda settings: replace(settings, **chosen))

    # -- building

    def _choice(
        self, label: str, options: tuple[str, ...], name: str, hint: str
    ) -> viser.GuiDropdownHandle[Any]:
        dropdown = self._gui.add_dropdown(label, options, initial_value=options[0], hint=hint)
        self._on_change(dropdown, lambda value: self._configure(**{name: value}))
        return dropdown

    def _show_table(self, table: str) -> None:
        """Show the table; the hint what to do where there is none."""
        _put(self._table, "content", table)
        _put(self._table, "visible", bool(table))
        _put(self._hint, "visible", not table)

    def _millimetres(self, label: str, most: float, name: str, hint: str) -> Any:
        slider = self._gui.add_slider(f"{label}, mm", -most, most, 0.5, 0.0, hint=hint)
        self._on_change(slider, lambda value: self._configure(**{name: 1e-3 * float(value)}))
        return slider

    def _button(self, label: str, act: Callable[[], None], **look: Any) -> viser.GuiButtonHandle:
        button = self._gui.add_button(label, **look)

        @button.on_click
        def _(_event: viser.GuiEvent[Any]) -> None:
            self._safely(act)

        return button

    def _on_change(self, control: Any, act: Callable[[Any], None]) -> None:
        @control.on_update
        def _(event: viser.GuiEvent[Any]) -> None:
            if event.client is not None:
                self._safely(lambda: act(control.value))

    def _safely(self, act: Callable[[], None]) -> None:
        try:
            act()
        except Exception as error:
            self._telling.report(error)


class ReplayCloser(View):
    """Shows a replay no more when a person turns to another recording."""

    def __init__(self, session: ReplaySession) -> None:
        self._session = session

    def show_document(self, opened: Opened) -> None:
        """This recording is to be seen; its workcell is proposed."""
        running = self._session.running
        if running and running.opened.demonstration is not opened.demonstration:
            self._session.leave()
        self._session.propose(opened.demonstration)


def _set(control: Any, value: Any) -> None:
    if control.value != value:
        control.value = value


def _put(control: Any, name: str, value: Any) -> None:
    if getattr(control, name) != value:
        setattr(control, name, value)
