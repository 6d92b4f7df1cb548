"""The same lines serve one in plain numbers and a batch in arrays."""

from dataclasses import dataclass, replace

import numpy as np
import pytest
from numpy.testing import assert_array_equal

from keyphase.rotations.components import chosen, components, dot, functions, joined, larger, number
from keyphase.skills.changed import changed

BATCH = np.random.default_rng(0).normal(size=(5, 3))


@pytest.mark.parametrize("array", [BATCH[0], BATCH, BATCH[None]], ids=["one", "batch", "grid"])
def test_taken_apart_and_joined_nothing_changes(array) -> None:
    assert_array_equal(joined(components(array)), array)


def test_one_is_taken_apart_into_plain_numbers() -> None:
    assert all(type(part) is float for part in components(BATCH[0]))
    assert type(number(np.asarray(2.0))) is float


def test_a_part_of_one_and_a_part_of_a_batch_are_joined_for_the_batch() -> None:
    both = joined([*components(BATCH[0]), *components(BATCH)])
    assert_array_equal(both, np.concatenate([np.tile(BATCH[0], (5, 1)), BATCH], axis=1))


def test_a_batch_gives_what_each_one_gives() -> None:
    def formula(array):
        parts = components(array)
        root = functions(parts[0]).sqrt(larger(dot(parts, parts), 2.0))
        return joined([root, chosen(parts[0] > 0.0, parts[1], parts[2])])

    assert_array_equal(formula(BATCH), [formula(one) for one in BATCH])


def test_a_changed_value_is_what_replace_gives() -> None:
    @dataclass(frozen=True)
    class Value:
        kept: int
        other: int

    value = Value(1, 2)
    assert changed(value, other=3) == replace(value, other=3)
    assert value == Value(1, 2)
