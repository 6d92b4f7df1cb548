"""Curves of the timeline, as a page asks for them."""

from talking import PageClient


def test_the_page_gets_what_it_asked_for(page: PageClient) -> None:
    page.send(
        "signals", request=9, tracks=["error", "position", "force"], from_s=1.0, to_s=2.0, width=50
    )

    header, series = page.wait_for_signals()

    assert header["request"] == 9
    assert [track["name"] for track in header["tracks"]] == ["error", "position", "force"]
    keys = [s["key"] for track in header["tracks"] for s in track["series"]]
    assert keys == ["error", "median", "x", "y", "z", "x", "y", "z"]
    for times, values in series:
        assert len(times) == len(values) <= 102
        assert times[0] <= 1.0
        assert times[-1] >= 2.0
