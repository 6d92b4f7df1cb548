"""Whose each step of a recording was, so that undo can say whom it concerns.

Undo walks the one list of steps that all pages at a recording share. Where the step it takes back
was another page's, both are told; nothing is kept beyond the server's life.
"""

from collections.abc import Sequence

from keyphase.labeling.history import History, Step
from keyphase.workbench.desks.member import Member


class Authors:
    """The pages that made the steps of one recording since it was opened."""

    def __init__(self) -> None:
        self._pages: dict[int, str] = {}
        self._newest = -1

    def note(self, history: History, page: str | None) -> None:
        """What is new in the history was this page's; None: it was there before, or nobody's."""
        for step in history.steps:
            if step.number > self._newest and page is not None:
                self._pages[step.number] = page
        self._newest = max([self._newest, *(step.number for step in history.steps)])

    def tell_undone(self, step: Step | None, page: str, members: Sequence[Member]) -> None:
        """A page has taken a step back: say so where it was another's, there and here."""
        author = self._pages.get(step.number) if step else None
        if step is None or author in (None, page):
            return
        numbers = {one.id: f"page {one.number}" for one in members if one.is_here}
        for member in members:
            if member.id == page:
                whose = numbers.get(author, "a page that was closed or loaded again")
                member.tell("info", f"Took back “{step.name}” of {whose}; {_AGAIN}.")
            elif member.id == author:
                who = numbers.get(page, "another page").capitalize()
                member.tell("info", f"{who} took back your “{step.name}”; {_AGAIN}.")


_AGAIN = "Ctrl Shift Z makes it again"
