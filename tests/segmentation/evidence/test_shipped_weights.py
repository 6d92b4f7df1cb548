"""The constants that were fitted: readable, with provenance, their signs sensible."""

import json

import numpy as np

from keyphase.segmentation.evidence.fitting.fit import (
    HELD,
    MOTION_SIGNS,
    STATE_SIGNS,
    STEP_SIGNS,
)
from keyphase.segmentation.evidence.fitting.logistic import (
    CALIBRATED_AT,
    fitted_calibration,
    fitted_line,
)
from keyphase.segmentation.evidence.weights import (
    WEIGHTS_FILE,
    shipped_weights,
    weights_as_json,
    weights_from_json,
)


def test_the_file_says_where_it_comes_from():
    content = json.loads(WEIGHTS_FILE.read_text())
    assert content["provenance"]["command"].startswith("keyphase fit ")
    assert content["provenance"]["recordings"] > 0


def test_no_weight_has_a_sign_that_makes_no_sense():
    weights = shipped_weights()
    for line, signs in (
        (weights.step, STEP_SIGNS),
        (weights.state, {**STATE_SIGNS, **HELD}),
        (weights.motion, MOTION_SIGNS),
    ):
        for name, weight in zip(line.names, line.weight.tolist(), strict=True):
            assert weight * signs[name] >= 0.0, name


def test_weights_are_the_same_after_writing_and_reading():
    content = weights_as_json(shipped_weights(), {})
    assert weights_as_json(weights_from_json(content), {}) == content


def test_a_line_finds_the_weights_its_labels_were_drawn_from():
    rng = np.random.default_rng(1)
    terms = rng.normal(size=(20_000, 2))
    odds = 1.5 * terms[:, 0] - 0.5
    right = (rng.random(len(odds)) < 1.0 / (1.0 + np.exp(-odds))).astype(float)
    columns = {"tells": 0, "says nothing": 1}
    line = fitted_line(terms, columns, {"tells": 1, "says nothing": -1}, right, np.ones(len(odds)))
    np.testing.assert_allclose(line.weight, [1.5, 0.0], atol=0.08)
    calibrated = fitted_calibration(2.0 * odds, right, np.ones(len(odds)))
    np.testing.assert_allclose(calibrated, 0.5 * np.array(CALIBRATED_AT), atol=0.15)
