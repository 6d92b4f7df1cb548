"""Simulations and recordings shared by the tests of the simulation."""

from collections.abc import Callable
from functools import cache

import pytest

from keyphase.demonstration import Demonstration
from keyphase.simulation import record


@cache
def _recorded(name: str, seed: int) -> Demonstration:
    return record(name, seed=seed)


@pytest.fixture(scope="session")
def recorded() -> Callable[[str, int], Demonstration]:
    """A scripted recording of a workcell, made once per seed."""
    return _recorded
