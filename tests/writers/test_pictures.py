"""Pictures of a segmentation: what is in them, and that the same input gives the same bytes."""

import numpy as np
import pytest
from segmented_recordings import NAMES, saved

from keyphase.errors import ExportError
from keyphase.pictures import draw
from keyphase.pictures.path import rings
from keyphase.segmentation.segmentation import Gaussian


@pytest.fixture(scope="module")
def labeling(tmp_path_factory):
    return saved(tmp_path_factory.mktemp("drawn"))


def test_an_svg_has_the_names_and_is_the_same_each_time(labeling, tmp_path):
    draw(labeling, tmp_path / "one.svg")
    draw(labeling, tmp_path / "two.svg")
    text = (tmp_path / "one.svg").read_text()
    assert all(f"<!-- {name} -->" in text for name in NAMES)
    assert (tmp_path / "two.svg").read_text() == text


def test_a_pdf_is_the_same_each_time(labeling, tmp_path):
    draw(labeling, tmp_path / "one.pdf", "path")
    draw(labeling, tmp_path / "two.pdf", "path")
    assert (tmp_path / "one.pdf").read_bytes().startswith(b"%PDF")
    assert (tmp_path / "one.pdf").read_bytes() == (tmp_path / "two.pdf").read_bytes()


def test_a_timeline_has_a_bar_for_each_segment_and_a_line_for_each_boundary(labeling):
    segments, position, force = draw(labeling, what="timeline").axes
    assert [bar.get_x() for bar in segments.patches] == [s.start_s for s in labeling.segments]
    for axes in (position, force):
        lines = [line.get_xdata()[0] for line in axes.lines if len(line.get_xdata()) == 2]
        assert lines == [boundary.time_s for boundary in labeling.boundaries]


def test_ellipsoids_are_one_standard_deviation_along_their_axes():
    gaussian = Gaussian(1.0, 0.0, 1.0, np.array([1.0, 2.0, 3.0]), np.diag([0.01, 0.04, 0.09]))
    points = np.concatenate(rings(gaussian))
    np.testing.assert_allclose(np.ptp(points, axis=0) / 2, [0.1, 0.2, 0.3], rtol=1e-2)
    np.testing.assert_allclose((points.max(axis=0) + points.min(axis=0)) / 2, [1, 2, 3], atol=1e-3)


def test_another_ending_is_refused_with_those_there_are(labeling, tmp_path):
    with pytest.raises(ExportError, match=r"\.svg, \*\.pdf"):
        draw(labeling, tmp_path / "figure.gif")
