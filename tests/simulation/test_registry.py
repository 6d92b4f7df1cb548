"""Workcells by name: others add theirs, and it is replayed and tried like keyphase's own."""

from dataclasses import replace

import pytest

from keyphase.errors import SimulationError
from keyphase.simulation import register, workcell, workcell_names
from keyphase.simulation.workcells.registry import _added
from keyphase.simulation.workcells.setup1 import SETUP1


@pytest.fixture
def bench():
    cell = replace(SETUP1, name="bench", title="A bench")
    register(cell)
    yield cell
    del _added["bench"]


def test_a_workcell_from_outside_is_known_by_its_name(bench) -> None:
    assert workcell("bench") is bench
    assert workcell_names() == ("setup1", "setup2", "bench")


def test_registering_it_again_changes_nothing(bench) -> None:
    register(bench)
    assert workcell("bench") is bench


def test_a_name_that_is_taken_is_refused(bench) -> None:
    with pytest.raises(SimulationError, match="'setup2' is that of"):
        register(replace(bench, name="setup2"))


def test_an_unknown_workcell_is_refused_with_those_there_are() -> None:
    with pytest.raises(SimulationError, match="setup1, setup2, but is 'setup3'"):
        workcell("setup3")
