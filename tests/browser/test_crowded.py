"""With sixty segments in view nothing is cut, covered or written over."""

import itertools
from pathlib import Path

import numpy as np
import pytest
from driver import KeyphasePage, LookAt

from synthetic import setup1

SEEDS = range(5000, 5012)
SIZES = [(1920, 1080), (1280, 720)]

_OVERLAPS = """selector => {
  const boxes = [...document.querySelectorAll(selector)]
    .filter(node => node.checkVisibility()).map(node => node.getBoundingClientRect());
  boxes.sort((a, b) => a.left - b.left);
  return boxes.slice(1).filter((box, k) =>
    box.left < boxes[k].right - 0.5 && box.top < boxes[k].bottom && boxes[k].top < box.bottom
  ).length;
}"""

_CUT = """() => [...document.querySelectorAll('[data-segment]')].filter(group => {
  const rect = group.querySelector('rect').getBoundingClientRect();
  return [...group.querySelectorAll('text')].some(text => {
    const box = text.getBoundingClientRect();
    return box.left < rect.left - 0.5 || box.right > rect.right + 0.5;
  });
}).length"""


@pytest.fixture(scope="module")
def crowded(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Twelve Setup 1 one after another, each beginning where the one before ended."""
    positions, forces = [], []
    end = np.zeros(3)
    for seed in SEEDS:
        one = setup1(seed, "real", forces=True).demonstration
        positions.append(one.position_m - one.position_m[0] + end)
        forces.append(one.force_N)
        end = positions[-1][-1]
    position = np.concatenate(positions)
    path = tmp_path_factory.mktemp("crowded") / "crowded.npz"
    time = np.arange(len(position)) / 250.0
    np.savez(path, time_s=time, position_m=position, force_N=np.concatenate(forces))
    return path


def test_sixty_segments_stay_readable(crowded: Path, look_at: LookAt) -> None:
    page = look_at(crowded)
    assert page.segments.count() > 50
    for size, dark in itertools.product(SIZES, (False, True)):
        page.resize(*size)
        page.set_theme(dark)
        page.picture(f"crowded_{'dark' if dark else 'light'}_{size[0]}")
        assert page.page.evaluate(_CUT) == 0
        for texts in (".boundary-time", ".peak-height", ".peak-reason", ".segment-label"):
            assert page.page.evaluate(_OVERLAPS, texts) == 0
        assert no_text_is_cut_in_chips(page)


def no_text_is_cut_in_chips(page: KeyphasePage) -> bool:
    return page.page.evaluate(
        """() => [...document.querySelectorAll('.chip-text b')].every(
             text => text.scrollWidth <= text.clientWidth + 1)"""
    )
