"""Every choice that shapes a segmentation, with the defaults that measured best."""

import math
from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any, Literal, get_args

from keyphase.errors import ParameterError
from keyphase.segmentation.own_methods import METHODS, OWN_VARIANTS

Mixture = Literal["keyphase", "scikit-learn"]
Turns = Literal["none", "clear", "all"]
Estimator = Literal["equal-distance", "weight-crossing"]
Engine = Literal["vectorised", "filterpy"]


@dataclass(frozen=True)
class Parameters:
    """The parameters of `segment`; the defaults need no tuning on most recordings.

    Raises ParameterError for a value out of its range.
    """

    variant: str = "evidence"
    """The method: a probability for every boundary, the paper's ("paper"), or a registered one."""
    force_threshold: float | None = None
    """Probability a contact change must reach, None: automatic. In variant paper the normalized
    error a peak must exceed, None: the chi-square level of one false alarm in a hundred
    demonstrations."""
    force_ratio: float = 20.0
    """How many times its running 2 s median a peak must exceed."""
    min_distance_s: float = 0.25
    """Least time between two peaks [s]."""
    persistence: float = 4.0
    """How far the force must stay changed after a peak, in noise levels."""
    process_noise_ratio: float = 1.0
    """R1 of the force filter, as a multiple of R2."""
    measurement_noise: float | None = None
    """R2 of the force channels [N^2]; None: estimated from the recording."""
    engine: Engine = "vectorised"
    """The filter: our own, or filterpy as its reference."""
    gaussians: int | None = None
    """Number of Gaussians; None: by the corrected BIC."""
    mixture: Mixture = "keyphase"
    """The paper's mixture: our own fit, or scikit-learn's as the paper literally describes it."""
    estimator: Estimator = "equal-distance"
    """Where in its interval a boundary lies."""
    seed: int = 0
    """Of the scikit-learn mixture's random starts."""
    merge_tolerance_s: float = 0.4
    """How far apart a force and a position boundary may be one [s]."""
    motion_threshold: float | None = None
    """Probability a boundary of motion must reach; None: automatic. Variant evidence only."""
    turns: Turns = "clear"
    """Which turns without a rest count beside a recorded force. Variant evidence only."""
    least_step_N: float | None = None
    """Least step of the force at a contact change [N]; None: from how the force wanders while the
    tool rests and touches nothing. Variant evidence only."""

    def __post_init__(self) -> None:
        for name, (low, high) in RANGES.items():
            _check_number(name, getattr(self, name), low, high)
        _check_choice("engine", self.engine, get_args(Engine))
        _check_choice("mixture", self.mixture, get_args(Mixture))
        if self.variant not in OWN_VARIANTS:
            _check_choice("variant", self.variant, METHODS.names)
        _check_choice("turns", self.turns, get_args(Turns))
        _check_choice("estimator", self.estimator, get_args(Estimator))


RANGES: dict[str, tuple[float, float]] = {
    "force_threshold": (1e-4, 1e9),
    "force_ratio": (0.0, 1e6),
    "min_distance_s": (0.0, 60.0),
    "persistence": (0.0, 1e6),
    "process_noise_ratio": (1e-6, 1e6),
    "measurement_noise": (1e-12, 1e12),
    "gaussians": (1, 200),
    "seed": (0, 2**31 - 1),
    "merge_tolerance_s": (0.0, 60.0),
    "motion_threshold": (0.0, 1.0),
    "least_step_N": (0.0, 1e6),
}
"""Least and greatest value of every number among the parameters."""

_AUTOMATIC = frozenset(
    {"force_threshold", "motion_threshold", "measurement_noise", "gaussians", "least_step_N"}
)
_WHOLE = frozenset({"gaussians", "seed"})


def checked_for_variant(parameters: Parameters) -> Parameters:
    """The parameters, where a person sets them: thresholds in the unit of their variant.

    What was stored is read as it is, since a variant may have been changed behind it. Raises
    ParameterError for a threshold over 1 where it is a probability.
    """
    line = parameters.force_threshold
    if parameters.variant == "evidence" and line is not None and line > 1.0:
        raise ParameterError(
            "force_threshold must be a probability from 0.0001 to 1 or automatic, but is "
            f"{line!r}; a threshold of the normalized error goes with variant paper."
        )
    return parameters


def parameters_before_variant(values: Mapping[str, Any]) -> dict[str, Any]:
    """Today's names of parameter values that were written before there was a choice of method.

    What is called variant there is the mixture; the method was the paper's.
    """
    today = {name: value for name, value in values.items() if name != "variant"}
    if "variant" in values:
        today["mixture"] = values["variant"]
    return {"variant": "paper", **today}


def _check_number(name: str, value: object, low: float, high: float) -> None:
    if value is None and name in _AUTOMATIC:
        return
    kind = int if name in _WHOLE else int | float
    is_number = isinstance(value, kind) and not isinstance(value, bool)
    if not (is_number and math.isfinite(value) and low <= value <= high):  # pyright: ignore
        what = "a whole number" if name in _WHOLE else "a number"
        raise ParameterError(
            f"{name} must be {what} from {low:g} to {high:g}"
            f"{' or automatic' if name in _AUTOMATIC else ''}, but is {value!r}."
        )


def _check_choice(name: str, value: object, choices: tuple[str, ...]) -> None:
    if value not in choices:
        raise ParameterError(f"{name} must be one of {', '.join(choices)}, but is {value!r}.")
