"""One parameter changed by its name, as controls change them."""

from dataclasses import replace

from keyphase.errors import RequestError
from keyphase.segmentation.parameters import Parameters, checked_for_variant


def with_parameter(parameters: Parameters, name: str, value: float | str | None) -> Parameters:
    """The parameters with one changed; whole numbers may come as 5.0.

    Raises RequestError for an unknown name, ParameterError for a value out of range.
    """
    if name not in Parameters.__dataclass_fields__:
        known = ", ".join(Parameters.__dataclass_fields__)
        raise RequestError(f"There is no parameter {name!r}; the parameters are {known}.")
    if name in ("gaussians", "seed") and isinstance(value, float) and value.is_integer():
        value = int(value)
    if name == "variant" and value != parameters.variant:
        # The thresholds' unit is another one.
        automatic = dict.fromkeys(_THRESHOLDS & Parameters.__dataclass_fields__.keys())
        parameters = replace(parameters, **automatic)
    return checked_for_variant(replace(parameters, **{name: value}))


_THRESHOLDS = {"force_threshold", "motion_threshold"}
