"""The bundled wipe: made again it is the same, and its line has something to change."""

import numpy as np
import pytest

from keyphase.files.shipped import shipped
from keyphase.making import make
from keyphase.readers import read, save_npz
from keyphase.segmentation import Parameters, Segmenter


@pytest.fixture(scope="module")
def segmenter():
    return Segmenter(read(shipped("data") / "wipe.npz"))


@pytest.fixture(scope="module")
def touch_s():
    return next(e.time_s for e in make("light-touch", 18).events if e.label == "contact made")


def contacts(segmenter, line=None):
    found = segmenter.segment(Parameters(force_threshold=line))
    return np.array([b.time_s for b in found.boundaries if b.contact_change])


def test_it_is_what_the_maker_makes(tmp_path):
    save_npz(make("light-touch", 18).demonstration, tmp_path / "wipe.npz")
    assert (tmp_path / "wipe.npz").read_bytes() == (shipped("data") / "wipe.npz").read_bytes()


def test_lowering_the_line_brings_the_light_touch(segmenter, touch_s):
    assert np.abs(contacts(segmenter) - touch_s).min() > 0.3
    assert np.abs(contacts(segmenter, 0.05) - touch_s).min() < 0.2


def test_dragging_the_line_changes_the_number_of_segments_three_times(segmenter):
    lines = np.linspace(0.02, 0.98, 49)
    counts = [len(segmenter.segment(Parameters(force_threshold=x)).segments) for x in lines]
    assert np.count_nonzero(np.diff(counts)) >= 3
