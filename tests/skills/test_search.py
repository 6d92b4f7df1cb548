"""A contact that gave way is told from a rim by its depth, and sought where it is missing."""

from pathlib import Path

import numpy as np
import pytest

from keyphase.demonstration import Demonstration
from keyphase.files.shipped import shipped
from keyphase.readers import read
from keyphase.segmentation import segment
from keyphase.skills.library import skills_of
from keyphase.skills.pressed import Press
from keyphase.skills.search import Search, before_touch, search_for

DOWN = np.array([0.0, 0.0, -1.0])


def pressed_in(depth_m: float, gives_way: bool) -> Demonstration:
    """Down at 30 mm/s; a touch at 1 s, then `depth_m` further in, with or without a detent."""
    time = np.arange(500) / 250
    gone = np.clip(0.03 * (time - 1.0), -0.03, depth_m)
    force = np.where(time > 1.0, 3.0, 0.0)
    if gives_way:
        force = np.where((gone > 0.6 * depth_m) & (gone < depth_m), 0.9, force)
    position = np.c_[np.zeros((len(time), 2)), -gone]
    return Demonstration("in", time, position, None, np.c_[np.zeros((len(time), 2)), force])


def its_search(demonstration: Demonstration) -> Search | None:
    return search_for(demonstration, 1.08, Press(DOWN, 3.0, np.zeros(3)))


def test_a_detent_asks_for_the_demonstrated_depth() -> None:
    found = its_search(pressed_in(0.0025, gives_way=True))
    assert found is not None
    assert found.depth_m == pytest.approx(0.0025, abs=3e-4)


@pytest.mark.parametrize(("depth_m", "gives_way"), [(0.0003, False), (0.0025, False), (0.02, True)])
def test_what_is_hard_soft_or_deep_is_not_sought(depth_m, gives_way) -> None:
    assert its_search(pressed_in(depth_m, gives_way)) is None


def test_of_the_bundled_recordings_only_the_snap_is_sought() -> None:
    sought = {}
    for name in ("setup1", "setup2"):
        demonstration = read(Path(shipped("data")) / f"{name}.npz")
        kept = [one for one in segment(demonstration).segments if not one.idle]
        sought[name] = [one.search is not None for one in skills_of(demonstration, kept)]
    assert sum(sought["setup1"]) == 1
    assert not any(sought["setup2"])


def test_the_spiral_grows_to_its_radius_and_stays_square_to_the_press() -> None:
    search = Search(0.002)
    way = np.array([search.aside(DOWN, time) for time in np.linspace(0.0, 5.0, 200)])
    assert np.linalg.norm(way, axis=1).max() == pytest.approx(search.radius_m, rel=0.01)
    assert np.abs(way @ DOWN).max() < 1e-12
    assert np.linalg.norm(way[0]) == 0.0


def test_a_touch_lasts_as_long_as_the_force_does() -> None:
    touch = before_touch(DOWN, np.zeros(3))
    for depth in np.linspace(0.0, 0.002, 20):
        touch = touch.step(np.array([0.0, 0.0, -depth]), np.array([0.0, 0.0, 3.0]))
    assert touch.depth_m(np.array([0.0, 0.0, -0.002])) > 0.0015
    for _ in range(20):
        touch = touch.step(np.zeros(3), np.zeros(3))
    assert touch.touched_m is None
