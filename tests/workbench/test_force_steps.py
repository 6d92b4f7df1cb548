"""By how much the force changed at contact changes."""

from dataclasses import replace
from math import hypot

import pytest

from keyphase.demonstration import Demonstration
from keyphase.files.shipped import shipped
from keyphase.labeling.label import label
from keyphase.readers import read
from keyphase.segmentation import Parameters, segment
from keyphase.workbench.showing.force_steps import force_step, greatest_step


@pytest.fixture(scope="module")
def setup1() -> Demonstration:
    return read(shipped("data") / "setup1.npz")


@pytest.mark.parametrize("variant", ["evidence", "paper"])
def test_every_contact_that_was_found_has_a_step_and_nothing_else(
    setup1: Demonstration, variant: str
) -> None:
    labeling = label(segment(setup1, Parameters(variant=variant)))
    steps = [force_step(one, labeling) for one in labeling.boundaries]

    assert [step is not None for step in steps] == [
        one.contact_change for one in labeling.boundaries
    ]
    lengths = [hypot(*step) for step in steps if step is not None]
    assert greatest_step(labeling) == max(lengths) > 1.0


def test_without_force_there_is_no_step(setup1: Demonstration) -> None:
    silent = replace(setup1, force_N=None, torque_Nm=None)

    assert greatest_step(label(segment(silent))) is None
