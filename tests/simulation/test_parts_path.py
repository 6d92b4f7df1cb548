"""Where the parts were along a recording, worked out again from the recording alone."""

from dataclasses import replace

import numpy as np
import pytest

from keyphase.files.shipped import shipped
from keyphase.readers import read
from keyphase.simulation.workcells.parts_path import parts_path
from keyphase.simulation.workcells.rim import OUTER_M
from keyphase.simulation.workcells.setup1 import HOUSING_POSITION_M, WALL_FACE_Y_M


@pytest.fixture(scope="module")
def setup1():
    return read(shipped("data") / "setup1.npz")


def test_the_parts_end_together_at_the_wall(setup1) -> None:
    path = parts_path(setup1)
    assert path is not None
    first, last = path.at(setup1.start_s), path.at(setup1.end_s)
    assert first["housing"][0][:2] == pytest.approx(HOUSING_POSITION_M, abs=1e-3)
    gap = last["held"][0] - last["housing"][0]
    assert gap[:2] == pytest.approx([0.0, 0.0], abs=1.5e-3)
    assert last["housing"][0][1] == pytest.approx(WALL_FACE_Y_M - OUTER_M / 2, abs=2e-3)


def test_the_held_part_stays_at_the_recorded_tool(setup1) -> None:
    path = parts_path(setup1)
    assert path is not None
    for time_s in np.linspace(setup1.start_s, setup1.end_s, 20).tolist():
        tool = setup1.position_m[setup1.index_at(time_s)]
        away = np.linalg.norm(path.at(time_s)["held"][0] - tool)
        assert away == pytest.approx(0.032, abs=3e-3)


def test_recordings_from_elsewhere_have_no_parts(setup1) -> None:
    assert parts_path(read(shipped("data") / "synthetic_setup1.npz")) is None
    for metadata in ({}, {"workcell": "setup9"}, {"disturbance": {"friction": "much"}}):
        other = {**setup1.metadata, **metadata} if metadata else {}
        assert parts_path(replace(setup1, metadata=other)) is None
