"""For everyone: axe-core finds nothing, the timeline is in the tree, a finger hits."""

from collections.abc import Callable
from pathlib import Path

import pytest
from driver import KeyphasePage, Serve, Visit

AXE = Path(__file__).parents[2] / "node_modules" / "axe-core" / "axe.min.js"

_FOUND = """async (part) => {
  const { violations } = await axe.run(
    { include: [part], exclude: ["#viser"] },
    { resultTypes: ["violations"], iframes: false },
  );
  return violations.flatMap(({ id, nodes }) =>
    nodes.map(({ target, any }) => `${id}: ${target} ${any[0]?.message ?? ""}`));
}"""


def _tab(name: str) -> Callable[[KeyphasePage], None]:
    return lambda page: page.panel.get_by_role("tab", name=name).click()


def _select(page: KeyphasePage) -> None:
    page.click(page.middle_of(0))


def _unreadable_notes(page: KeyphasePage) -> None:
    page.page.evaluate(
        """() => {
          const { store } = keyphase;
          const notices = [{ text: "Dropped 2 rows.", severity: "warning" }];
          store.set({ document: { ...store.state.document, notices } });
        }"""
    )
    page.page.locator("#read-notices").click()


def _formats(page: KeyphasePage) -> None:
    page.press("Control+Shift+S")
    page.page.locator("#exporting[open]").wait_for()


def _done(page: KeyphasePage) -> None:
    page.change(lambda: page.press("Shift+K"))


def _stopped_replay(page: KeyphasePage) -> None:
    page.press("p")
    page.until("keyphase.state.replay?.current === 1")
    page.press("Escape")
    page.until("keyphase.state.replay.phase === 'over'")


STATES: dict[str, tuple[Callable[[KeyphasePage], None], str]] = {
    "as opened": (lambda page: page.settle(), "body"),
    "a segment selected": (_select, "body"),
    "why a boundary": (lambda page: page.press("."), "#why"),
    "commands": (lambda page: page.press("Control+k"), "#palette"),
    "keys": (lambda page: page.press("?"), "#keys"),
    "a menu": (lambda page: page.press("Shift+F10"), "#menu"),
    "naming": (lambda page: page.press("l"), "#rename"),
    "notes on reading": (_unreadable_notes, "#read-notices-list"),
    "recording": (_tab("Record"), "#panel"),
    "replay": (_tab("Replay"), "#panel"),
    "export": (_tab("Export"), "#panel"),
    "formats to export": (_formats, "#exporting"),
    "done": (_done, "body"),
    "a replay that was stopped": (_stopped_replay, "body"),
}
"""How each is reached, and the part of the page that differs from the first."""


@pytest.mark.parametrize("dark", [False, True], ids=["light", "dark"])
def test_axe_finds_nothing_in_any_state(
    folder: Path, serve: Serve, visit: Visit, dark: bool
) -> None:
    assert AXE.exists(), "axe-core is missing; `make page-scripts` installs it"
    page = visit(serve(folder), size=(1440, 900), dark=dark, scene=False)
    page.wait_for_document()
    page.page.evaluate(AXE.read_text())
    found: dict[str, list[str]] = {}
    for name, (reach, part) in STATES.items():
        reach(page)
        page.page.locator(part).wait_for()
        page.settle()
        found[name] = page.page.evaluate(_FOUND, part)
        for _ in range(2):
            page.press("Escape")
    assert {name: faults for name, faults in found.items() if faults} == {}


def test_axe_finds_nothing_where_no_recording_is_open(serve: Serve, visit: Visit) -> None:
    page = visit(serve(), scene=False)
    page.page.locator("#empty").wait_for()
    page.settle()
    page.page.evaluate(AXE.read_text())
    assert page.page.evaluate(_FOUND, "body") == []


def test_segments_and_boundaries_are_lists_that_arrows_walk(timeline: KeyphasePage) -> None:
    timeline.tab_to("at.getAttribute('aria-label') === 'Segments'")
    timeline.press("ArrowRight")
    timeline.press("ArrowRight")
    timeline.until("keyphase.state.selected === 1")
    timeline.settle()
    chosen = timeline.page.get_by_role("option", selected=True).and_(
        timeline.page.locator("[id^=outline-segment]")
    )
    segment = timeline.document["segments"][1]
    times = f"{segment['start_s']:.3f} s to {segment['end_s']:.3f} s"
    assert (chosen.text_content() or "").startswith(f"Segment 2, idle, {times}")
    assert "Segment 2" in timeline.text("#announcer")


def test_a_finger_beside_a_boundary_moves_it_and_a_tap_says_why_it_is_there(
    timeline: KeyphasePage,
) -> None:
    row = timeline.row("boundaries")
    x, y = timeline.x(timeline.document["boundaries"][1]["time_s"]), row.y + row.height / 2
    drag = """([x, y, to]) => {
      const surface = document.querySelector(".surface");
      const touch = (type, clientX) => surface.dispatchEvent(new PointerEvent(type,
        { pointerId: 1, pointerType: "touch", isPrimary: true, button: 0, clientX, clientY: y,
          bubbles: true }));
      surface.setPointerCapture = () => {};
      touch("pointerdown", x);
      for (let k = 1; k <= 5; k++) touch("pointermove", x + ((to - x) * k) / 5);
      touch("pointerup", to);
    }"""
    timeline.press("v")
    timeline.change(lambda: timeline.page.evaluate(drag, [x + 10, y, x + 50]))
    assert timeline.document["boundaries"][1]["origin"] == "user"
    x = timeline.x(timeline.document["boundaries"][2]["time_s"])
    timeline.page.evaluate(drag, [x + 10, y, x + 10])
    timeline.page.locator("#why", has_text="Boundary 3").wait_for()
    x, y = timeline.middle_of(0)
    timeline.page.evaluate(drag, [x, y, x])
    timeline.page.locator("#why").wait_for(state="hidden")


def test_two_fingers_zoom(timeline: KeyphasePage) -> None:
    row = timeline.row("force")
    pinch = """([x, y]) => {
      const surface = document.querySelector(".surface");
      const touch = (type, pointerId, clientX) => surface.dispatchEvent(new PointerEvent(type,
        { pointerId, pointerType: "touch", isPrimary: pointerId === 1, button: 0, clientX,
          clientY: y, bubbles: true }));
      surface.setPointerCapture = () => {};
      touch("pointerdown", 1, x - 50);
      touch("pointerdown", 2, x + 50);
      for (let k = 1; k <= 10; k++) {
        touch("pointermove", 1, x - 50 - 10 * k);
        touch("pointermove", 2, x + 50 + 10 * k);
      }
      touch("pointerup", 1, x - 150);
      touch("pointerup", 2, x + 150);
    }"""
    before = timeline.state("view")
    timeline.page.evaluate(pinch, [row.x + row.width / 2, row.y + row.height / 2])
    timeline.settle()
    after = timeline.state("view")
    assert after["to"] - after["from"] == pytest.approx(
        (before["to"] - before["from"]) / 3, rel=0.1
    )
