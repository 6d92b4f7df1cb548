"""Demonstrations of every shape, for the properties that hold for all of them."""

import numpy as np
from hypothesis import strategies as st
from hypothesis.extra.numpy import arrays

from keyphase.demonstration import Demonstration
from keyphase.logged import Event

_finite = st.floats(-1e6, 1e6, allow_nan=False, allow_infinity=False)
_json = st.recursive(
    st.none() | st.booleans() | st.integers(-(2**53), 2**53) | _finite | st.text(max_size=8),
    lambda inner: st.lists(inner, max_size=3) | st.dictionaries(st.text(max_size=8), inner),
    max_leaves=5,
)
_letters = st.characters(codec="utf-8", categories=("L", "N", "P", "S"), exclude_characters="/")
_words = st.text(_letters, min_size=1, max_size=8)
_names = st.sets(_words, max_size=2)


@st.composite
def demonstrations(draw: st.DrawFn) -> Demonstration:
    """Two to thirty samples, with or without each optional channel and metadata."""
    rows = draw(st.integers(2, 30))
    steps = draw(arrays(np.float64, rows, elements=st.floats(1e-4, 10.0)))

    def channel(width: int) -> np.ndarray | None:
        values = arrays(np.float64, (rows, width), elements=_finite)
        return draw(st.none() | values)

    seed = draw(st.none() | st.integers(0, 2**32 - 1))
    return Demonstration(
        name="recording",
        time_s=np.cumsum(steps),
        position_m=draw(arrays(np.float64, (rows, 3), elements=_finite)),
        orientation_wxyz=None if seed is None else random_orientations(rows, seed),
        force_N=channel(3),
        torque_Nm=channel(3),
        joints_rad=channel(draw(st.integers(1, 12))),
        gripper=draw(st.none() | arrays(np.float64, rows, elements=_finite)),
        channels={name: draw(arrays(np.float64, rows, elements=_finite)) for name in draw(_names)},
        events=draw(st.lists(st.builds(Event, _finite, _words), max_size=3).map(tuple)),
        wrench_estimated=draw(st.booleans()),
        metadata=draw(st.dictionaries(st.text(max_size=8), _json, max_size=3)),
    )


def random_orientations(rows: int, seed: int) -> np.ndarray:
    """Unit quaternions (rows, 4)."""
    raw = np.random.default_rng(seed).normal(size=(rows, 4))
    return raw / np.linalg.norm(raw, axis=1, keepdims=True)
