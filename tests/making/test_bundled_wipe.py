"""The bundled wipe: made again it is the same, and its line has something to change."""

import numpy as np
import pytest

from keyphase.files.shipped import shipped
from keyphase.making import make
from keyphase.readers import read, save_npz
from keyphase.segmentation import Parameters, Segmenter
from keyphase.segmentation.evidence.probability import log_odds, sigmoid
from keyphase.segmentation.evidence.telling.counts import HIGHEST, LOWEST


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
    """But for the last bit, in which processors differ."""
    save_npz(make("light-touch", 18).demonstration, tmp_path / "wipe.npz")
    made, bundled = np.load(tmp_path / "wipe.npz"), np.load(shipped("data") / "wipe.npz")
    assert made.files == bundled.files
    for name in ("time_s", "position_m", "orientation_wxyz", "force_N", "torque_Nm"):
        np.testing.assert_allclose(made[name], bundled[name], rtol=0, atol=1e-12)


def test_lowering_the_line_brings_the_light_touch(segmenter, touch_s):
    assert np.abs(contacts(segmenter) - touch_s).min() > 0.3
    assert np.abs(contacts(segmenter, 0.05) - touch_s).min() < 0.2


def test_dragging_the_line_over_its_track_changes_the_number_of_segments_three_times(segmenter):
    lines = sigmoid(np.linspace(log_odds(LOWEST), log_odds(HIGHEST), 49))
    counts = [len(segmenter.segment(Parameters(force_threshold=x)).segments) for x in lines]
    assert np.count_nonzero(np.diff(counts)) >= 3
