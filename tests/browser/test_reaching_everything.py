"""Everything is reached by the keyboard: Tab shows where it is, the palette has every command."""

import re
from pathlib import Path

import pytest
from driver import KeyphasePage, Serve, Visit

ROUTE = (
    "crumb",
    "badge",
    "command-field",
    "theme",
    "help",
    "add-recording",
    "queue-sort",
    "queue-rows",
    "least-certain",
    "next-recording",
    "viser",
    "tab-segment",
    "number",
    "Reset to automatic",
    "splitter",
    "play",
    "Split",
    "Merge",
    "Drop",
    "Label",
    "Tracks",
    "gutter-name",
    "chip",
    "drop-idle",
)
"""What Tab passes on its way through the page, by id, class or text."""

_FOCUSED = """() => {
  const node = document.activeElement;
  const style = getComputedStyle(node);
  const box = node.getBoundingClientRect();
  const drawn = style.outlineStyle !== "none" && style.outlineWidth !== "0px";
  return {
    name: `${node.id} ${node.className} ${node.textContent.slice(0, 40)}`,
    outlined: drawn || node.id === "viser",
    seen: box.width > 0 && box.height > 0 && box.left < innerWidth && box.top < innerHeight,
  };
}"""


@pytest.mark.parametrize("size", [(1920, 1080), (1280, 720)], ids=["1920x1080", "1280x720"])
def test_tab_reaches_every_part_and_shows_where_it_is(
    folder: Path, serve: Serve, visit: Visit, size: tuple[int, int]
) -> None:
    page = visit(serve(folder), scene=False, size=size)
    page.wait_for_document()
    page.until("keyphase.state.recordings.items.every(item => item.confidence !== null)")
    stops = []
    for _ in range(120):
        page.press("Tab")
        stops.append(page.page.evaluate(_FOCUSED))
        if "drop-idle" in stops[-1]["name"]:
            break
    page.picture(f"focus_{size[0]}")
    missed = [part for part in ROUTE if not any(part in stop["name"] for stop in stops)]
    assert missed == []
    assert [stop["name"] for stop in stops if not (stop["outlined"] and stop["seen"])] == []


def test_the_palette_has_every_command_of_the_sheet_of_keys(editor: KeyphasePage) -> None:
    editor.press("?")
    names = editor.page.locator("#keys section:not(:last-of-type) .line > span").all_inner_texts()
    editor.press("Escape")
    editor.page.locator("#keys").wait_for(state="hidden")
    assert len(names) > 40
    editor.press("Control+k")
    typed = editor.page.locator("#palette input")
    for name in names:
        typed.fill(name)
        listed = editor.page.locator("#palette li > span:first-child").all_inner_texts()
        assert name in listed
    editor.press("Escape")
    editor.page.locator("#palette").wait_for(state="hidden")


def test_every_button_says_what_it_does(editor: KeyphasePage) -> None:
    nameless = editor.page.evaluate(
        """() => [...document.querySelectorAll("button")].filter(node => node.checkVisibility() &&
          !(node.textContent.trim() || node.getAttribute("aria-label") || node.title))
          .map(node => node.outerHTML.slice(0, 100))"""
    )
    assert nameless == []


def test_the_list_is_one_stop_of_tab_and_a_recording_is_chosen_in_it_by_arrows(
    folder: Path, serve: Serve, visit: Visit
) -> None:
    page = visit(serve(folder), scene=False)
    page.wait_for_document()
    page.tab_to("at.id === 'queue-rows'")
    page.press("ArrowDown")
    page.press("Enter")
    page.until("keyphase.state.document.name === 'synthetic_setup1'")
    page.settle()
    assert page.page.evaluate("() => document.activeElement.id") == "queue-rows"
    page.press("Tab")
    assert page.page.evaluate("() => document.activeElement.id") == "least-certain"


def test_a_track_is_folded_and_hidden_by_keys(timeline: KeyphasePage) -> None:
    timeline.tab_to("at.closest('[data-gutter=force]')")
    timeline.press("Enter")
    timeline.settle()
    assert timeline.row("force").height == 20
    timeline.tab_to("at.textContent === 'Tracks'")
    timeline.press("Enter")
    timeline.page.locator("#menu").wait_for()
    while not re.match("Speed", timeline.text("#menu button:focus")):
        timeline.press("ArrowDown")
    timeline.press("Enter")
    timeline.until("keyphase.state.hidden.has('speed')")
    assert timeline.page.evaluate("() => document.activeElement.textContent") == "Tracks"


def test_how_fast_it_plays_is_chosen_by_keys_however_quickly(timeline: KeyphasePage) -> None:
    timeline.press("Control+k")
    timeline.page.keyboard.type("play slower")
    timeline.press("Enter")
    timeline.until("keyphase.state.playhead.speed === 0.5")

    # The next changes come before the server can have told of the one before.
    timeline.page.evaluate("() => { for (const _ of [1, 2]) keyphase.actions.togglePlay(); }")
    timeline.page.evaluate("() => { for (const _ of [1, 2]) keyphase.actions.changeSpeed(-1); }")
    timeline.until("keyphase.state.playhead.speed === 0.1")
    assert not timeline.state("playhead")["playing"]

    for key, speed in (("l", 1), ("l", 2), ("j", -1), ("j", -2)):
        timeline.press(f"Alt+{key}")
        timeline.until(f"keyphase.state.playhead.speed === {speed}")
    timeline.until("keyphase.state.clock === keyphase.state.document.start_s")
    timeline.press("Alt+k")
    timeline.until("keyphase.state.playhead.speed === 1 && !keyphase.state.playhead.playing")
    assert timeline.document["state"] == "automatic"


def test_what_is_drawn_anew_keeps_the_focus(editor: KeyphasePage) -> None:
    editor.press("n")
    editor.tab_to("at.closest('#why') && at.textContent.startsWith('Accept')")
    editor.change(lambda: editor.press("Enter"))
    focused = "() => document.activeElement.textContent || document.activeElement.className"
    assert editor.page.evaluate(focused).startswith(("Accept", "Next", "surface"))

    editor.page.locator("#drop-idle").focus()
    editor.change(lambda: editor.press("Enter"))
    assert editor.page.evaluate("() => document.activeElement.className") == "surface"
