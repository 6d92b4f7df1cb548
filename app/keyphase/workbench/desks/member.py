"""Who looks at a desk."""

from typing import TYPE_CHECKING, Protocol

from keyphase.workbench.desks.desk_state import DeskState
from keyphase.workbench.telling import Level

if TYPE_CHECKING:
    from keyphase.workbench.desks.desk import Desk


class Member(Protocol):
    """Who looks at a desk. Told in the desk's thread, under its lock: not to be kept waiting.

    id, number  the page's id, and what other pages call it by
    """

    id: str
    number: int

    @property
    def is_here(self) -> bool:
        """Whether somebody has the page before them."""
        ...

    def tell(self, level: Level, text: str) -> None:
        """A line of text for this page alone."""
        ...

    def desk_opened(self, desk: "Desk", state: DeskState) -> None:
        """It is open, or was already when the member joined."""
        ...

    def desk_failed(self, desk: "Desk", error: Exception) -> None:
        """Its recording cannot be opened."""
        ...

    def desk_changed(self, desk: "Desk", state: DeskState) -> None:
        """It has another revision."""
        ...
