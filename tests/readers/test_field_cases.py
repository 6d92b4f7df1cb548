"""Files as laboratories have them, kept beside the real recordings: each is read, or refused well.

Absent on most machines; where they are, what stands in the case's README is what is asked here.
"""

import re
from pathlib import Path

import numpy as np
import pytest
from rosbags.highlevel import AnyReader

from keyphase.demonstration import Demonstration
from keyphase.errors import KeyphaseError
from keyphase.oddities import oddities_of
from keyphase.readers import parse_recipe, read
from keyphase.readers.finding import parts_of
from keyphase.readers.proposing.proposal import propose

RECIPES = Path(__file__).parent / "recipes"


@pytest.fixture
def field(real_data: Path) -> Path:
    folder = real_data.parent / "cases" / "field"
    if not folder.is_dir():
        pytest.skip(f"field cases not found at {folder}, beside the real recordings")
    return folder


def odd_in(path: Path) -> str:
    return " ".join(odd.text for odd in oddities_of(read(path)))


def proposed(path: Path) -> list[Demonstration]:
    """Every recording in a table, by the recipe that is proposed for it."""
    text = propose(path).recipe_text()
    assert not re.search(r"^# (unit|columns|order|rate_hz) =", text, re.M)
    text = text.replace("# frame =", "frame =").replace("# sign =", "sign =")
    recipe = parse_recipe(text, "proposed")
    parts = parts_of(path, recipe)
    paths = [path.with_name(f"{path.name}#{part}") for part in parts] or [path]
    return [read(one, recipe) for one in paths]


@pytest.mark.parametrize(
    ("case", "told"),
    [
        ("01_dropout_zero_row", "has the place 0 0 0"),
        ("04_time_unit_slip", "were milliseconds read as seconds"),
        ("13_gap_called_idle", "1.51 s without data"),
        ("18_joints_move_pose_does_not", "the pose was not recorded"),
    ],
)
def test_what_no_sound_recording_has_is_told(field: Path, case: str, told: str) -> None:
    assert told in odd_in(field / case / "run.csv")


def test_a_stamp_in_two_columns_is_proposed_and_loses_no_row(field: Path) -> None:
    (found,) = proposed(field / "06_two_column_stamp" / "run.csv")
    assert len(found) == 300
    assert found.rate_hz == pytest.approx(50, rel=0.01)


def test_several_demonstrations_in_one_table_are_proposed_apart(field: Path) -> None:
    assert len(proposed(field / "07_several_demonstrations" / "run.csv")) == 3


def test_two_arms_in_one_table_are_proposed_as_two_recordings(field: Path) -> None:
    left, right = proposed(field / "20_two_arms_in_one_file" / "run.csv")
    assert not np.array_equal(left.position_m, right.position_m)


def test_every_binary_file_is_refused_in_a_sentence_that_names_what_it_is(field: Path) -> None:
    kinds = {"bag": "bag", "hdf5": "HDF5", "mat": "MATLAB", "mcap": "MCAP", "npy": "array"}
    kinds |= {"parquet": "Parquet", "pkl": "pickle"}
    for ending, kind in kinds.items():
        with pytest.raises(KeyphaseError, match=kind):
            read(field / "09_binary_files" / f"run.{ending}")


def test_the_bag_of_a_baxter_gives_what_rosbags_reads(real_data: Path) -> None:
    path = real_data / "raw" / "baxter_simulated.bag"
    found = read(path, RECIPES / "baxter_simulated.recipe.toml")
    places, forces = [], []
    with AnyReader([path]) as bag:
        for connection, _, raw in bag.messages():
            message = bag.deserialize(raw, connection.msgtype)
            if connection.topic == "/robot/limb/right/endpoint_state":
                p = message.pose.position
                places.append((p.x, p.y, p.z))
            elif connection.topic == "/wrench/filtered/right":
                f = message.wrench.force
                forces.append(np.linalg.norm((f.x, f.y, f.z)))
    assert found.force_N is not None
    assert found.rate_hz == pytest.approx(200)
    sizes = np.linalg.norm(found.force_N, axis=1)
    first = int(np.argmin(np.abs(np.array(forces) - sizes[0])))
    np.testing.assert_allclose(sizes[:200], forces[first : first + 200], atol=1e-9)
    extent = np.ptp(np.array(places), axis=0)
    np.testing.assert_allclose(np.ptp(found.position_m, axis=0), extent, atol=5e-4)
