"""A replay as those who watch it are shown it."""

from dataclasses import dataclass

from keyphase.simulation.part_shapes import Shape
from keyphase.simulation.replay.result import ReplayResult
from keyphase.workbench.desks.desk_state import DeskState
from keyphase.workbench.replaying.plan import ReplayPlan
from keyphase.workbench.replaying.run import Phase, ReplayRun
from keyphase.workbench.replaying.settings import ReplaySettings


@dataclass(frozen=True, eq=False)
class Running:
    """A replay that runs, or that is over and still shown.

    goals   names of what counts as success
    result  None until it is over
    """

    number: int
    opened: DeskState
    settings: ReplaySettings
    plan: ReplayPlan
    run: ReplayRun
    shapes: tuple[Shape, ...]
    goals: tuple[str, ...]
    result: ReplayResult | None = None

    @property
    def phase(self) -> Phase:
        """Whether it runs, stands still, or is over."""
        return self.run.phase
