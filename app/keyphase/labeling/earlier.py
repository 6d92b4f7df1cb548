"""Values written by versions that had one method only, read as what they meant then."""

from collections.abc import Mapping
from typing import Any

from keyphase.segmentation.parameters import parameters_before_variant

_MIXTURES = ("keyphase", "scikit-learn")
"""What was called variant before there was a choice of method."""


def parameters_as_meant(values: Mapping[str, Any]) -> Mapping[str, Any]:
    """Parameters of a file; those without a word on the method had the paper's."""
    earlier = values.get("variant", _MIXTURES[0]) in _MIXTURES
    return parameters_before_variant(values) if earlier and values else values
