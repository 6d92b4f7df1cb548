"""Recording, the world of a replay, trials and the robot, as a page asks for them."""

from pathlib import Path

import pytest
from talking import Message, PageClient


def _greeted(page: PageClient, kind: str) -> Message:
    """What the page was told of a kind when it came, before or after its document."""
    heard = [message for message in page.heard if message["type"] == kind]
    return heard[0] if heard else page.wait_for(kind)


def test_a_page_is_greeted_with_all_controls(page: PageClient) -> None:
    record = _greeted(page, "record")
    settings = _greeted(page, "replay_settings")
    push = _greeted(page, "push")
    robot = _greeted(page, "robot")

    assert record["workcell"] is None
    assert {"setup1", "setup2"} <= {choice["name"] for choice in record["choices"]}
    assert settings["ranges"]["friction"][0] > 0
    assert not push["offered"]
    assert robot["arm"] == robot["arms"][0]


def test_what_is_chosen_of_a_replays_world_stays_and_the_rest_is_left(page: PageClient) -> None:
    page.send("replay_settings", workcell="setup2", friction=0.5)
    page.send("replay_settings", part_height_m=0.004, seed=7)

    chosen = page.wait_for("replay_settings", lambda m: m["part_height_m"] == 0.004)

    assert (chosen["workcell"], chosen["friction"], chosen["part_height_m"]) == (
        "setup2",
        0.5,
        0.004,
    )
    assert chosen["speed"] == 1.0


@pytest.mark.parametrize(
    ("wrong", "reason"),
    [({"friction": 40.0}, "friction"), ({"workcell": "garage"}, "garage"), ({"seed": 0.5}, "int")],
)
def test_a_world_that_cannot_be_is_refused(
    page: PageClient, wrong: dict[str, object], reason: str
) -> None:
    page.send("replay_settings", **wrong)

    assert reason in page.wait_for("refused")["text"]


def test_a_take_is_recorded_and_taken_back(page: PageClient, own_copy: Path) -> None:
    page.send("record", do="start", workcell="setup1")
    recording = page.wait_for("record", lambda m: m["recording"] and m["recorded_s"] > 0.1)
    page.send("record", do="stop")
    stopped = page.wait_for("record", lambda m: not m["recording"] and m["can_undo"])
    page.send("record", do="undo_take")
    undone = page.wait_for("record", lambda m: not m["can_undo"])

    assert recording["workcell"] == "setup1"
    assert recording["force_N"] is not None
    assert stopped["workcell"] is None
    assert undone["can_redo"]
    assert not own_copy.with_name("setup1_01.npz").exists()


def test_a_workcell_must_be_named_to_be_opened(page: PageClient) -> None:
    page.send("record", do="open")

    assert "name a workcell" in page.wait_for("refused")["text"]


def test_the_plan_is_written_as_a_behaviour_tree(page: PageClient) -> None:
    page.send("export", kind="behavior-tree")

    assert Path(page.wait_for("saved")["path"]).exists()


def test_a_page_of_a_replay_needs_one_that_is_over(page: PageClient) -> None:
    page.send("export", kind="page")

    assert "No replay is over" in page.wait_for("refused")["text"]


def test_another_arm_and_the_gizmo_of_the_robot_are_told(page: PageClient) -> None:
    arms = _greeted(page, "robot")["arms"]
    page.send("robot", arm=arms[-1], moving=True)
    told = page.wait_for("robot", lambda m: m["moving"])
    page.send("robot", arm="third")

    assert told["arm"] == arms[-1]
    assert "no other" in page.wait_for("refused")["text"]
