"""A MATLAB file is walked through before SciPy reads it: what lies about its size ends in words."""

import io
from contextlib import suppress
from pathlib import Path

import numpy as np
import pytest
import scipy.io
from hypothesis import given
from hypothesis import strategies as st

from keyphase.errors import DemonstrationError
from keyphase.readers import read
from keyphase.readers.mat_elements import plain_variables

LIMIT = 1 << 24


def written(compressed: bool) -> bytes:
    cells = np.empty((1, 2), dtype=object)
    cells[0, 0], cells[0, 1] = {"a": np.ones((3, 2))}, "word"
    values = {
        "numbers": np.arange(5.0),
        "complex": 1j * np.ones(4),
        "text": "hello",
        "nothing": np.zeros((0, 3)),
        "cells": cells,
        "nested": {"inner": {"q": np.eye(3)}, "empty": []},
        "bytes": np.int8([1, 2, 3]),
        "flags": np.array([True, False]),
    }
    stream = io.BytesIO()
    scipy.io.savemat(stream, values, do_compression=compressed)
    return stream.getvalue()


@pytest.mark.parametrize("compressed", [False, True])
def test_every_plain_variable_is_known(compressed: bool) -> None:
    names = ["numbers", "complex", "text", "nothing", "cells", "nested", "bytes", "flags"]
    assert plain_variables(written(compressed), LIMIT) == names


@given(st.integers(128, 1500), st.binary(min_size=1, max_size=8))
def test_whatever_stands_in_a_file_ends_in_words(at: int, junk: bytes) -> None:
    data = written(False)
    mutated = data[:at] + junk + data[at + len(junk) :]
    with suppress(ValueError):
        assert isinstance(plain_variables(mutated, LIMIT), list)


def test_cells_that_are_not_there_are_refused(tmp_path: Path) -> None:
    data = written(False)
    dimensions = np.array([1, 2], "<i4").tobytes()
    at = data.index(b"cells") - 16
    assert data[at : at + 8] == dimensions
    (tmp_path / "run.mat").write_bytes(
        data[:at] + np.array([1, 9], "<i4").tobytes() + data[at + 8 :]
    )
    with pytest.raises(DemonstrationError, match="another number of values than it says"):
        read(tmp_path / "run.mat")


def test_what_unpacks_to_more_than_the_limit_is_refused() -> None:
    with pytest.raises(ValueError, match="larger than the limit"):
        plain_variables(written(True), 64)
