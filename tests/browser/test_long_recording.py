"""A recording of a million samples opens, zooms and pans."""

from pathlib import Path

import numpy as np
import pytest
from driver import Serve, Visit

from synthetic import setup1

SAMPLES = 1_000_000


@pytest.fixture
def million(tmp_path: Path) -> Path:
    """Setup 1 there and back, again and again, for more than an hour at 250 Hz."""
    one = setup1(5000, "real", forces=True).demonstration
    assert one.force_N is not None
    position = np.concatenate([one.position_m, one.position_m[::-1]])
    force = np.concatenate([one.force_N, one.force_N[::-1]])
    times = -(-SAMPLES // len(position))
    noise = np.random.default_rng(0).normal(0.0, 0.05, (SAMPLES, 3))
    np.savez(
        tmp_path / "million.npz",
        time_s=np.arange(SAMPLES) / one.rate_hz,
        position_m=np.tile(position, (times, 1))[:SAMPLES],
        force_N=np.tile(force, (times, 1))[:SAMPLES] + noise,
    )
    return tmp_path / "million.npz"


@pytest.mark.slow
def test_a_million_samples_open_zoom_and_pan(million: Path, serve: Serve, visit: Visit) -> None:
    page = visit(serve(million), scene=False)
    page.page.set_default_timeout(240_000)
    page.wait_for_document()
    picture = page.picture("million")
    band = page.row("segments")
    assert picture.count("#58A2F2", band) > 500
    row = page.row("position")
    middle = (row.x + row.width / 2, row.y + row.height / 2)
    page.page.mouse.move(*middle)
    for span in (1500, 400, 100, 30):
        page.page.mouse.wheel(0, -900)
        page.until(f"keyphase.state.view.to - keyphase.state.view.from < {span}")
    page.until("keyphase.state.fine && keyphase.state.fine.to - keyphase.state.fine.from < 100")
    page.settle()
    near = page.picture("million_near")
    assert near.count("#2f6be0", row, 40) > 300
    before = page.state("view")["from"]
    page.drag(middle, (middle[0] - 300, middle[1]))
    assert page.state("view")["from"] > before
    assert page.segments.count() < 60
