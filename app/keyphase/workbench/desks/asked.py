"""Who asks something of a desk, what they had seen, and whom to tell where it is refused."""

from collections.abc import Callable
from dataclasses import dataclass

from keyphase.workbench.desks.desk_state import Cause


@dataclass(frozen=True)
class Asked:
    """A request about a recording.

    page      id of the page that asks
    revision  of the recording, as the page saw it
    refuse    told why it was not done
    event     the page's own number of the request, if it has one
    """

    page: str
    revision: int
    refuse: Callable[[Exception], None]
    event: int | None = None

    @property
    def cause(self) -> Cause | None:
        """What the change is told with."""
        return None if self.event is None else Cause(self.page, self.event)
