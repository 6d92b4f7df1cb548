"""How unlike all that was fitted on a recording is: only what is known of it counts."""

import numpy as np

from keyphase.segmentation.evidence.contact_terms import CONTACT_TERMS
from keyphase.segmentation.evidence.probability import CONTACT_COLUMNS, unlike
from keyphase.segmentation.evidence.weights import shipped_weights

KINDS = shipped_weights().kinds


def candidates(count: int, **changed: float) -> np.ndarray:
    """Candidates (C, T) of a family, with some terms changed."""
    terms = np.zeros((count, len(CONTACT_TERMS)))
    for name, value in zip(KINDS.names, KINDS.centre[0], strict=True):
        terms[:, CONTACT_COLUMNS[name]] = changed.get(name, value)
    return terms


def far(terms: np.ndarray) -> float:
    return unlike(terms, np.zeros(len(terms)), KINDS)


def test_without_a_view_of_contact_as_a_state_nothing_is_said_of_free_space():
    assert far(candidates(12, over_core=30.0, separation=1.0)) > 0.2
    assert far(candidates(12, over_core=30.0, separation=0.0)) == 0.0


def test_few_candidates_lie_apart_by_chance():
    away = float(KINDS.centre[0, 0]) + 10.0 * float(KINDS.spread[0])
    assert 0.0 < far(candidates(5, stays_long=away)) < far(candidates(12, stays_long=away))
