"""One parameter changed by its name, as a page's controls ask for it."""

import pytest

from keyphase.errors import ParameterError, RequestError
from keyphase.segmentation.parameters import Parameters
from keyphase.workbench.desks.parameters import with_parameter


def test_a_threshold_is_taken_in_the_unit_of_its_variant_only() -> None:
    with pytest.raises(ParameterError, match="probability"):
        with_parameter(Parameters(), "force_threshold", 40.0)
    published = with_parameter(Parameters(variant="paper"), "force_threshold", 40.0)
    assert published.force_threshold == 40.0
    assert with_parameter(published, "variant", "evidence").force_threshold is None


def test_an_unknown_parameter_is_refused_with_those_there_are() -> None:
    with pytest.raises(RequestError, match="the parameters are variant, force_threshold"):
        with_parameter(Parameters(), "force", 1.0)
