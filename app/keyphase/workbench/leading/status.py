"""How recording by hand stands."""

from dataclasses import dataclass

from keyphase.simulation.demonstrating.lead_through import LeadThroughState


@dataclass(frozen=True, eq=False)
class LeadThroughStatus:
    """What is to be shown: the running workcell, if one runs, and which takes can be undone."""

    workcell: str | None
    running: LeadThroughState | None
    can_undo: bool
    can_redo: bool

    @property
    def recording(self) -> bool:
        """Whether a take is being recorded."""
        return self.running is not None and self.running.recorded_s is not None
