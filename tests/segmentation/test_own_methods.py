"""Methods of other people's, registered by name."""

import pytest

from keyphase.errors import ParameterError
from keyphase.files.shipped import shipped
from keyphase.readers import read
from keyphase.segmentation import Parameters, segment
from keyphase.segmentation.own_methods import FoundBoundary, register_method

DEMONSTRATION = read(shipped("data") / "setup1.npz")


def test_segments_are_made_of_a_methods_boundaries() -> None:
    register_method("thirds", lambda *_: [FoundBoundary(4.0, True, 0.7), FoundBoundary(2.0)])
    found = segment(DEMONSTRATION, Parameters(variant="thirds"))
    assert [b.time_s for b in found.boundaries] == [2.0, 4.0]
    assert [b.contact_change for b in found.boundaries] == [False, True]
    assert found.boundaries[1].confidence == 0.7
    assert len(found.segments) == 3
    assert all(segment.label for segment in found.segments)


@pytest.mark.parametrize("name", ["paper", "evidence", "two words", ""])
def test_a_name_that_is_taken_or_no_word_is_refused(name: str) -> None:
    with pytest.raises(ParameterError, match="plain word"):
        register_method(name, lambda *_: [])


def test_a_variant_nobody_registered_is_refused_with_those_that_are() -> None:
    with pytest.raises(ParameterError, match="variant must be one of evidence, paper"):
        Parameters(variant="nobody_knows_it")


@pytest.mark.parametrize(
    "wrong", [FoundBoundary(-1.0), FoundBoundary(float("nan")), FoundBoundary(2.0, confidence=2.0)]
)
def test_what_no_boundary_can_be_is_refused(wrong: FoundBoundary) -> None:
    register_method("wrong", lambda *_: [wrong])
    with pytest.raises(ParameterError, match="must find boundaries within"):
        segment(DEMONSTRATION, Parameters(variant="wrong"))
