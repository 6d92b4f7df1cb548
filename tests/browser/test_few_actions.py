"""Correcting a recording takes few clicks and keys; a typed name counts as one."""

from driver import KeyphasePage

MAX_ACTIONS = 25


class Counted:
    """A page that counts what a person does to it."""

    def __init__(self, page: KeyphasePage) -> None:
        self.page = page
        self.actions = 0

    def key(self, key: str) -> None:
        self.actions += 1
        self.page.press(key)

    def type(self, text: str) -> None:
        self.actions += 1
        self.page.page.keyboard.type(text)

    def drag(self, start: tuple[float, float], end: tuple[float, float]) -> None:
        self.actions += 1
        self.page.change(lambda: self.page.drag(start, end))


def test_setup1_is_corrected_in_under_25_actions(timeline: KeyphasePage) -> None:
    person = Counted(timeline)
    names = {0: "Reach", 2: "Lower", 4: "Slide"}
    person.key("]")
    person.key("l")
    for segment, name in names.items():
        timeline.until(f"keyphase.state.renaming === {segment}")
        person.type(name)
        last = segment == max(names)
        timeline.change(lambda last=last: person.key("Enter" if last else "Tab"))
    assert [timeline.labels()[segment] for segment in names] == [*names.values()]

    first = timeline.document["boundaries"][0]["time_s"]
    row = timeline.row("boundaries")
    y = row.y + row.height / 2
    person.drag((timeline.x(first), y), (timeline.x(first) + 40, y))
    person.drag(timeline.middle_of(3), timeline.middle_of(4))
    assert timeline.segments.count() == 4
    timeline.change(lambda: person.key("i"))

    chips = [timeline.page.locator(".chip").nth(k).bounding_box() for k in (0, 1)]
    assert all(chips)
    left, right = chips[0], chips[1]
    person.drag(
        (left["x"] + 50, left["y"] + 18), (right["x"] + right["width"] - 6, right["y"] + 18)
    )
    timeline.change(lambda: person.key("Control+z"))
    person.key("Control+s")
    timeline.page.locator(".notice", has_text="Written to").wait_for()
    assert person.actions < MAX_ACTIONS
