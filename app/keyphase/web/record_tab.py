"""The Record tab of viser's panel: a workcell, its takes, and the force that is felt."""

import functools
import threading
import time
from collections.abc import Callable
from typing import Any

import numpy as np
import viser

from keyphase.simulation.workcells.registry import workcell
from keyphase.workbench.lead_through_session import (
    LeadThroughSession,
    LeadThroughStatus,
    LeadThroughView,
)
from keyphase.workbench.telling import Telling

WORKCELLS = ("setup1", "setup2")

FULL_BAR_N = 20.0
"""The force at which the bar is full."""

_SHOWN_EVERY_S = 0.1
_HINT = (
    "Drag the arrows and arcs at the tool: the robot follows, and stops where it meets something. "
    "Let go and it holds still."
)


class RecordTab(LeadThroughView):
    """Controls of one lead-through session; add it inside a tab."""

    def __init__(
        self, server: viser.ViserServer, session: LeadThroughSession, telling: Telling
    ) -> None:
        self._gui, self._session, self._telling = server.gui, session, telling
        self._shown_at = 0.0
        self._shown: tuple[object, ...] = ()
        self._lock = threading.RLock()
        self._workcell = self._gui.add_dropdown(
            "Workcell", WORKCELLS, initial_value=WORKCELLS[0], hint=_titles()
        )
        self._record = self._button("Record", self._record_or_stop, color="red")
        self._open = self._button("Open workcell", self._open_or_close)
        self._reset = self._button("Reset workcell", session.reset)
        self._recorded = self._gui.add_text("Recorded", "", disabled=True)
        self._force = self._gui.add_text("Force", "", disabled=True)
        self._bar = self._gui.add_progress_bar(0.0, color="orange")
        self._undo = self._button("Undo last take", session.undo_take)
        self._redo = self._button("Bring back take", session.redo_take)
        self._gui.add_markdown(_HINT)

    def show_status(self, status: LeadThroughStatus) -> None:
        """Show what can be done now; numbers ten times a second."""
        with self._lock:
            self._show_buttons(status)
            now = time.monotonic()
            if status.running is None or now - self._shown_at >= _SHOWN_EVERY_S:
                self._shown_at = now
                self._show_numbers(status)

    def _show_buttons(self, status: LeadThroughStatus) -> None:
        is_open = status.running is not None
        wanted = (is_open, status.recording, status.can_undo, status.can_redo)
        if wanted == self._shown:
            return
        self._shown = wanted
        if status.workcell is not None:
            _set(self._workcell, status.workcell)
        self._record.label = "Stop" if status.recording else "Record"
        self._open.label = "Close workcell" if is_open else "Open workcell"
        self._open.disabled = self._workcell.disabled = status.recording
        self._reset.disabled = status.recording or not is_open
        self._undo.disabled = status.recording or not status.can_undo
        self._redo.disabled = status.recording or not status.can_redo

    def _show_numbers(self, status: LeadThroughStatus) -> None:
        state = status.running
        force = 0.0 if state is None else float(np.linalg.norm(state.sample.force_N))
        seconds = None if state is None else state.recorded_s
        _set(self._force, "" if state is None else f"{force:.1f} N")
        _set(self._recorded, "" if seconds is None else f"{seconds:.1f} s")
        _set(self._bar, round(100.0 * min(force / FULL_BAR_N, 1.0)))

    def _record_or_stop(self) -> None:
        if self._session.status().recording:
            self._session.stop()
        else:
            self._session.record(self._workcell.value)

    def _open_or_close(self) -> None:
        if self._session.status().running is not None:
            self._session.close()
        else:
            self._session.open(self._workcell.value)

    def _button(self, label: str, act: Callable[[], None], **look: Any) -> viser.GuiButtonHandle:
        button = self._gui.add_button(label, **look)

        @button.on_click
        def _(_event: viser.GuiEvent[Any]) -> None:
            self._safely(act)

        return button

    def _safely(self, act: Callable[[], None]) -> None:
        try:
            act()
        except Exception as error:
            self._telling.report(error)


@functools.cache
def _titles() -> str:
    return "; ".join(f"{name}: {workcell(name).title}" for name in WORKCELLS)


def _set(control: Any, value: Any) -> None:
    if control.value != value:
        control.value = value
