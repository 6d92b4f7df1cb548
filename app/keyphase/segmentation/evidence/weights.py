"""The fitted constants, as they stand in weights.json beside this file, with their provenance."""

from collections.abc import Mapping
from dataclasses import asdict, dataclass
from functools import lru_cache
from pathlib import Path
from typing import Any

import numpy as np

from keyphase.demonstration import Array

WEIGHTS_FILE = Path(__file__).with_name("weights.json")


@dataclass(frozen=True, eq=False)
class Line:
    """One logistic line: log-odds = bias + sum of weight (term - mean) / scale.

    names (T,) choose columns of a table of terms; mean, scale and weight (T,) go with them.
    """

    names: tuple[str, ...]
    mean: Array
    scale: Array
    weight: Array
    bias: float

    def contributions(self, terms: Array, columns: Mapping[str, int]) -> Array:
        """What each term adds (C, T), from a table (C, all terms) with its columns by name."""
        used = terms[:, [columns[name] for name in self.names]]
        return (used - self.mean) / self.scale * self.weight

    def log_odds(self, terms: Array, columns: Mapping[str, int]) -> Array:
        """Log-odds (C,)."""
        return self.contributions(terms, columns).sum(axis=1) + self.bias


@dataclass(frozen=True, eq=False)
class Calibration:
    """Probability = 1 / (1 + exp(-(slope z + offset))); `line` is the one that is automatic."""

    slope: float
    offset: float
    line: float


@dataclass(frozen=True, eq=False)
class Kinds:
    """What the recordings looked like that the weights were fitted on, family by family.

    families (F,); names (T,) of contact terms; centre (F, T) their mean over the likeliest
    candidates, spread (T,) of that mean among recordings; usual is the distance within which
    nine in ten recordings lie.
    """

    families: tuple[str, ...]
    names: tuple[str, ...]
    centre: Array
    spread: Array
    usual: float


@dataclass(frozen=True, eq=False)
class Weights:
    """Everything that was fitted."""

    step: Line
    state: Line
    motion: Line
    contact_calibration: Calibration
    motion_calibration: Calibration
    kinds: Kinds


def weights_from_json(content: Mapping[str, Any]) -> Weights:
    """Weights as a fit writes them."""
    kinds = content["kinds"]
    return Weights(
        _line(content["step"]),
        _line(content["state"]),
        _line(content["motion"]),
        Calibration(**content["calibration"]["contact"]),
        Calibration(**content["calibration"]["motion"]),
        Kinds(
            tuple(kinds["families"]),
            tuple(kinds["spread"]),
            np.array([list(centre.values()) for centre in kinds["families"].values()]),
            np.array(list(kinds["spread"].values())),
            kinds["usual"],
        ),
    )


def weights_as_json(weights: Weights, provenance: Mapping[str, Any]) -> dict[str, Any]:
    """Weights as JSON values, with where they come from."""
    kinds = weights.kinds
    spread = dict(zip(kinds.names, _short(kinds.spread), strict=True))
    families = {
        family: dict(zip(kinds.names, _short(centre), strict=True))
        for family, centre in zip(kinds.families, kinds.centre, strict=True)
    }
    return {
        "provenance": dict(provenance),
        "step": _line_as_json(weights.step),
        "state": _line_as_json(weights.state),
        "motion": _line_as_json(weights.motion),
        "calibration": {
            "contact": _calibration_as_json(weights.contact_calibration),
            "motion": _calibration_as_json(weights.motion_calibration),
        },
        "kinds": {"usual": round(kinds.usual, 4), "spread": spread, "families": families},
    }


def _line_as_json(line: Line) -> dict[str, Any]:
    columns = zip(
        line.names, _short(line.mean), _short(line.scale), _short(line.weight), strict=True
    )
    terms = {name: {"mean": m, "scale": s, "weight": w} for name, m, s, w in columns}
    return {"bias": round(line.bias, 4), "terms": terms}


def _calibration_as_json(calibration: Calibration) -> dict[str, float]:
    return {name: round(value, 4) for name, value in asdict(calibration).items()}


def _short(values: Array) -> list[float]:
    return [round(value, 4) for value in values.tolist()]


def _line(content: Mapping[str, Any]) -> Line:
    terms = content["terms"]
    mean, scale, weight = (
        np.array([term[key] for term in terms.values()]) for key in ("mean", "scale", "weight")
    )
    return Line(tuple(terms), mean, scale, weight, content["bias"])


@lru_cache(maxsize=1)
def shipped_weights() -> Weights:
    """The weights keyphase comes with."""
    import json

    return weights_from_json(json.loads(WEIGHTS_FILE.read_text(encoding="utf-8")))
