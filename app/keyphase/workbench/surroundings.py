"""What a view needs of the workbench it belongs to."""

from pathlib import Path
from typing import TYPE_CHECKING, Protocol

from keyphase.workbench.desks.library import Library
from keyphase.workbench.leading.takes import Takes
from keyphase.workbench.recording_list import RecordingList
from keyphase.workbench.tasks import Tasks

if TYPE_CHECKING:
    from keyphase.workbench.view import View


class Surroundings(Protocol):
    """The workbench, as its views see it."""

    library: Library
    recordings: RecordingList
    tasks: Tasks
    takes: Takes
    arms: tuple[str, ...]

    def find_view(self, page: str) -> "View":
        """The view of another page. Raises RequestError where there is none."""
        ...

    def view_changed(self, view: "View") -> None:
        """It looks at another recording."""
        ...

    def selection_changed(self) -> None:
        """A view has selected another segment."""
        ...

    def followers(self, page: str) -> tuple["View", ...]:
        """The views that follow a page."""
        ...

    def wake_clock(self) -> None:
        """A playhead has begun to run."""
        ...

    def remove(self, path: Path) -> None:
        """A recording less in the list."""
        ...
