"""The words in which the page says why a boundary is there, and how names are shortened."""

from dataclasses import replace

import numpy as np
import pytest

from keyphase.files.shipped import shipped
from keyphase.labeling.label import label
from keyphase.labeling.labeling import Labeling
from keyphase.readers import read
from keyphase.segmentation import Boundary, Peak, segment
from keyphase.web.protocol.document_content import boundaries_of, ghosts, plan_of
from keyphase.web.protocol.document_messages import Ghost, Why
from keyphase.workbench.showing.short_labels import short_labels

PEAK = Peak(4.2, 4.21, 465.0, 80.0, (0.2, 0.1, 3.8), None, 9.0, "")


@pytest.fixture(scope="module")
def labeling() -> Labeling:
    return label(segment(read(shipped("data") / "synthetic_setup1.npz")))


def _why(labeling: Labeling, found: Boundary, threshold: float = 23.85) -> Why:
    segmentation = replace(labeling.segmentation, boundaries=(found,), threshold=threshold)
    one = label(replace(segmentation, segments=labeling.segments[:2]))  # type: ignore
    return boundaries_of(one)[0].why


def test_a_boundary_of_both_says_height_and_what_position_alone_says(labeling: Labeling) -> None:
    found = Boundary(4.2, "both", (4.19, 4.21), 0.99, True, PEAK, 4.149)

    why = _why(labeling, found)

    assert why.sentences == (
        "The error peaks at 465, 19.5 × the threshold.",
        "Position alone puts the boundary 51 ms earlier.",
    )
    assert why.times_threshold == pytest.approx(19.5, abs=0.01)
    assert [(step.name, step.value) for step in why.steps] == [
        ("Force x", 0.2),
        ("Force y", 0.1),
        ("Force z", 3.8),
    ]


def test_a_boundary_of_position_names_the_gaussians_that_meet(labeling: Labeling) -> None:
    found = next(b for b in labeling.segmentation.boundaries if b.origin == "position")

    sentences = _why(labeling, found).sentences

    assert sentences[0].startswith("Gaussian ")
    assert "% of the samples" in sentences[0]


def test_ghosts_are_what_comes_and_goes(labeling: Labeling) -> None:
    fewer = replace(labeling, boundaries=labeling.boundaries[1:])

    first = labeling.boundaries[0]
    assert ghosts(labeling, fewer) == (Ghost(first.time_s, first.origin, "goes"),)
    assert ghosts(fewer, labeling)[0].fate == "comes"
    assert ghosts(labeling, labeling) == ()


def test_the_plan_says_how_far_apart_its_entries_are(labeling: Labeling) -> None:
    plan = plan_of(labeling)
    demonstration = labeling.segmentation.demonstration
    first, second = (labeling.segments[entry.segment] for entry in plan[:2])
    gap = np.linalg.norm(
        demonstration.position_m[demonstration.index_at(second.start_s)]
        - demonstration.position_m[demonstration.index_at(first.end_s)]
    )

    assert plan[0].connect_mm is None
    assert (plan[1].connect_mm or 0.0) == pytest.approx(1e3 * gap, abs=1.0)


@pytest.mark.parametrize(
    ("name", "shorter", "shortest"),
    [
        ("Slide left 54 mm until contact", "Slide until contact", "Slide…"),
        ("Move forward 171 mm", "Move forward", "Move…"),
        ("Move left and down 56 mm", "Left and down", "Left…"),
        ("Move left and down until contact", "Move until contact", "Move…"),
        ("Rotate about z 30°", "Rotate about z", "Rotate…"),
        ("insert", "insert", "insert"),
        ("42 mm", "42 mm", "42 mm"),
    ],
)
def test_names_shorten_by_what_matters_least(name: str, shorter: str, shortest: str) -> None:
    assert short_labels(name) == (name, shorter, shortest)
