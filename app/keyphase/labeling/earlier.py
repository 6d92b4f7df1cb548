"""Values written by versions that had one method only, read as what they meant then."""

from collections.abc import Mapping
from typing import Any, get_args

from keyphase.segmentation.parameters import Variant, parameters_before_variant


def parameters_as_meant(values: Mapping[str, Any]) -> Mapping[str, Any]:
    """Parameters of a file; those without a word on the variant had the paper's method."""
    return values if values.get("variant") in _VARIANTS else parameters_before_variant(values)


_VARIANTS = frozenset({*get_args(Variant), "evidence", "paper"})
