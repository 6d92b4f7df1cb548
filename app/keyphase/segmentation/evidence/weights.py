"""The fitted constants, as they stand in weights.json beside this file, with their provenance."""

from collections.abc import Mapping
from dataclasses import dataclass
from functools import lru_cache
from pathlib import Path
from typing import Any

import numpy as np

from keyphase.demonstration import Array

WEIGHTS_FILE = Path(__file__).with_name("weights.json")

_NEAR_ZERO = 1e-6


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

    def holding(self, weights: Mapping[str, float]) -> "Line":
        """The line with further terms whose weights are given, for terms as they are."""
        count = len(weights)
        return Line(
            (*self.names, *weights),
            np.append(self.mean, np.zeros(count)),
            np.append(self.scale, np.ones(count)),
            np.append(self.weight, list(weights.values())),
            self.bias,
        )


@dataclass(frozen=True, eq=False)
class Calibration:
    """Probability of a score: log-odds (K,) at some ascending scores (K,), straight between them
    and nat for nat beyond; `line` is the probability that is automatic.
    """

    scores: tuple[float, ...]
    odds: tuple[float, ...]
    line: float

    def log_odds(self, scores: Array) -> Array:
        """Calibrated log-odds of scores (C,)."""
        at, odds = np.array(self.scores), np.array(self.odds)
        return np.interp(scores, at, odds) + scores - np.clip(scores, at[0], at[-1])

    def slope(self, scores: Array) -> Array:
        """By how much the terms of scores (C,) are stretched: from a score of zero to each."""
        away = np.where(np.abs(scores) < _NEAR_ZERO, _NEAR_ZERO, scores)
        return (self.log_odds(away) - self.log_odds(np.zeros(1))) / away


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
        _calibration(content["calibration"]["contact"]),
        _calibration(content["calibration"]["motion"]),
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


def _calibration_as_json(calibration: Calibration) -> dict[str, Any]:
    return {
        "scores": list(calibration.scores),
        "log_odds": [round(value, 4) for value in calibration.odds],
        "line": round(calibration.line, 4),
    }


def _calibration(content: Mapping[str, Any]) -> Calibration:
    return Calibration(tuple(content["scores"]), tuple(content["log_odds"]), content["line"])


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
