"""What is exported is what was proved: the file alone does what the replay does."""

import pytest
from file_alone import both
from replaying import bundled, plan

from keyphase.simulation import Disturbance, workcell
from keyphase.skills.library import skills_of


@pytest.mark.parametrize(
    ("name", "height_m"), [("setup1", 0.007), ("setup2", -0.006), ("setup2", 0.03)]
)
def test_the_example_interpreter_does_what_the_replay_does(name, height_m, tmp_path) -> None:
    """The last one is out of reach of the guard: both must fail alike."""
    demonstration = bundled(name)[0]
    skills = skills_of(demonstration, plan(name))
    world = Disturbance(part_height_m=height_m)
    replayed, alone = both(workcell(name), skills, demonstration, world, tmp_path)
    assert alone == replayed
    assert len(alone[0]) > 1
