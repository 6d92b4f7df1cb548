"""A recording of five minutes, hundreds of segments, is opened, looked through and corrected."""

from pathlib import Path

import pytest
from driver import SEGMENT_COLORS, KeyphasePage, Serve, Visit

from long_recording import write_long

SAMPLES = 75_000
"""Five minutes at 250 Hz; `bench_page.py` opens a million."""


@pytest.fixture(scope="module")
def long(tmp_path_factory: pytest.TempPathFactory) -> Path:
    path = tmp_path_factory.mktemp("long") / "five_minutes.npz"
    write_long(path, SAMPLES)
    return path


def _span(page: KeyphasePage) -> float:
    view = page.state("view")
    return view["to"] - view["from"]


def test_five_minutes_open_zoom_pan_and_are_corrected(
    long: Path, serve: Serve, visit: Visit
) -> None:
    """Without its scene: drawing that in software takes minutes."""
    page = visit(serve(long), scene=False)
    page.page.set_default_timeout(120_000)
    page.wait_for_document()
    assert len(page.document["segments"]) > 150
    picture, band = page.picture("long"), page.row("segments")
    for color in SEGMENT_COLORS[:5]:
        assert picture.count(color, band) > 200

    _zoom_in(page)
    assert 2 < page.segments.count() < 150
    page.picture("long_zoomed")

    _pan(page)
    _drag_a_boundary(page)
    page.picture("long_corrected")


def _zoom_in(page: KeyphasePage) -> None:
    """With the wheel, to the minute around the pointer, which stays where it is."""
    row = page.row("position")
    at = (row.x + 0.5 * row.width, row.y + 0.5 * row.height)
    page.page.mouse.move(*at)
    page.until("keyphase.state.pointer !== null")
    time = page.state("pointer")
    while _span(page) > 60.0:
        before = _span(page)
        page.page.mouse.wheel(0, -400)
        page.until(f"keyphase.state.view.to - keyphase.state.view.from < {before}")
    page.settle()
    assert page.x(time) == pytest.approx(at[0], abs=2)


def _pan(page: KeyphasePage) -> None:
    row = page.row("position")
    y = row.y + 0.5 * row.height
    before, mouse = page.state("view")["from"], page.page.mouse
    mouse.move(row.x + 0.7 * row.width, y)
    mouse.down()
    page.settle()
    end = row.x + 0.3 * row.width
    mouse.move(end, y, steps=12)
    mouse.up()
    page.settle()
    assert page.state("view")["from"] == pytest.approx(before + 0.4 * _span(page), rel=1e-3)


def _drag_a_boundary(page: KeyphasePage) -> None:
    """It goes where it is dragged to, and is kept there with a mark of where it was."""
    view, boundaries = page.state("view"), page.document["boundaries"]
    middle = 0.5 * (view["from"] + view["to"])
    index = next(k for k, one in enumerate(boundaries) if one["time_s"] > middle)
    start, row = page.x(boundaries[index]["time_s"]), page.row("boundaries")
    y = row.y + 0.5 * row.height
    page.change(lambda: page.drag((start, y), (start + 12, y)))
    moved = page.document["boundaries"][index]
    assert moved["was_s"] == pytest.approx(boundaries[index]["time_s"])
    assert page.x(moved["time_s"]) == pytest.approx(start + 12, abs=10)
    assert page.boundaries.locator(f"xpath=self::*[@data-boundary='{index}']").count() == 1
    assert page.page.locator(".was-mark").count() == 1
