"""Where recordings stand in front of a robot, kept beside them."""

from pathlib import Path

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from keyphase.errors import LabelingError
from keyphase.robot.pose import Placement
from keyphase.workbench.placing.placements import forget_placement, save_placement, saved_placement

HALF_TURN = Placement((0.1, -0.2, 0.3), (0.0, 0.0, 0.0, 1.0))


def test_nothing_is_saved_at_first(tmp_path: Path) -> None:
    assert saved_placement(tmp_path / "a.npz", "yumi") is None


def test_what_was_saved_is_there_again(tmp_path: Path) -> None:
    save_placement(tmp_path / "a.npz", "yumi", HALF_TURN)
    assert saved_placement(tmp_path / "a.npz", "yumi") == HALF_TURN


def test_each_recording_and_each_robot_has_its_own(tmp_path: Path) -> None:
    save_placement(tmp_path / "a.npz", "yumi", HALF_TURN)
    save_placement(tmp_path / "a.npz", "other", Placement())
    assert saved_placement(tmp_path / "a.npz", "yumi") == HALF_TURN
    assert saved_placement(tmp_path / "a.npz", "other") == Placement()
    assert saved_placement(tmp_path / "b.npz", "yumi") is None


def test_it_can_be_forgotten(tmp_path: Path) -> None:
    save_placement(tmp_path / "a.npz", "yumi", HALF_TURN)
    forget_placement(tmp_path / "a.npz")
    assert saved_placement(tmp_path / "a.npz", "yumi") is None


@settings(max_examples=30)
@given(content=st.one_of(st.binary(max_size=60), st.just(b'{"version": 1, "robots": {"r": {}}}')))
def test_a_damaged_file_is_told_of_and_can_be_replaced(
    tmp_path_factory: pytest.TempPathFactory, content: bytes
) -> None:
    folder = tmp_path_factory.mktemp("damaged")
    save_placement(folder / "a.npz", "yumi", HALF_TURN)
    (folder / ".keyphase" / "a.npz.placement.json").write_bytes(content)
    with pytest.raises(LabelingError, match="place the robot again"):
        saved_placement(folder / "a.npz", "yumi")
    save_placement(folder / "a.npz", "yumi", HALF_TURN)
    assert saved_placement(folder / "a.npz", "yumi") == HALF_TURN
