"""Six tables as their robots wrote them, read by recipes, against what others made of them."""

from pathlib import Path

import numpy as np
import pytest

from keyphase.demonstration import Demonstration
from keyphase.readers import read

RECIPES = Path(__file__).parent / "recipes"

PROCESSED = {
    "lund_yumi_leadthrough.csv": "lund_yumi/leadthrough.npz",
    "lund_two_hand_assembly_trial_2.csv": "lund_two_hand_assembly/trial_2.npz",
    "kuleuven_contour_a_1.dat": "kuleuven_contour/a_1.npz",
    "unnamed_arm_contact_trial_1.txt": "unnamed_arm_contact/trial_1.npz",
    "dfki_subject1_run1.tsv": "dfki_pick_and_place/subject1_run1.npz",
}

SINGLE_PRECISION = 1e-6
"""The processed archives hold 32-bit floats."""


def read_raw(real_data: Path, name: str) -> Demonstration:
    return read(real_data / "raw" / name, RECIPES / f"{Path(name).stem}.recipe.toml")


@pytest.mark.parametrize(("raw", "processed"), PROCESSED.items(), ids=PROCESSED.keys())
def test_a_table_gives_the_same_recording_as_its_archive(
    real_data: Path, raw: str, processed: str
) -> None:
    ours, theirs = read_raw(real_data, raw), read(real_data / processed)
    np.testing.assert_allclose(ours.time_s, theirs.time_s, atol=1e-9)
    for channel in ("position_m", "force_N", "torque_Nm"):
        one, other = getattr(ours, channel), getattr(theirs, channel)
        assert (one is None) == (other is None)
        if one is not None:
            np.testing.assert_allclose(one, other, rtol=SINGLE_PRECISION, atol=1e-7)
    assert (ours.orientation_wxyz is None) == (theirs.orientation_wxyz is None)
    if ours.orientation_wxyz is not None and theirs.orientation_wxyz is not None:
        cosines = np.abs(np.sum(ours.orientation_wxyz * theirs.orientation_wxyz, axis=1))
        np.testing.assert_allclose(cosines, 1.0, atol=SINGLE_PRECISION)


def test_a_tagged_bag_gives_pose_wrench_and_joints(real_data: Path) -> None:
    demonstration = read_raw(real_data, "iiwa_tagged.csv")
    assert demonstration.rate_hz == pytest.approx(100, rel=1e-2)
    assert len(demonstration) == 3012
    assert demonstration.joints_rad is not None
    assert demonstration.joints_rad.shape == (3012, 7)
    np.testing.assert_allclose(demonstration.position_m[0], [0.5, -0.3, 0.5], atol=1e-4)


def test_the_flange_of_the_iiwa_points_down_so_its_wrench_is_turned(real_data: Path) -> None:
    """Half a turn about y, as recorded: x and z of the force change sign in the base frame."""
    force = read_raw(real_data, "iiwa_tagged.csv").force_N
    assert force is not None
    np.testing.assert_allclose(force[0], [-0.3358, 0.3584, -1.3149], atol=1e-3)


def test_held_poses_and_uneven_rows_are_said(real_data: Path) -> None:
    notices = " ".join(read_raw(real_data, "kuleuven_contour_a_1.dat").notices)
    assert "The rows are irregular in time" in notices
    assert "position_m changes in only 164 of 2786 rows (about 30 Hz)" in notices
    assert "(about 199 Hz)" in notices


@pytest.mark.slow
def test_every_real_archive_is_read(real_data: Path) -> None:
    archives = sorted(real_data.glob("*/*.npz"))
    assert archives
    for archive in archives:
        assert len(read(archive)) > 100
