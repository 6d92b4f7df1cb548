"""The paper's method on recordings this project did not make."""

import json
from pathlib import Path

import numpy as np
import pytest

from keyphase.demonstration import Demonstration
from keyphase.scoring import read_truth, tally
from keyphase.segmentation import Parameters, Segmentation, segment

pytestmark = pytest.mark.slow

CHANNELS = ("time_s", "position_m", "orientation_wxyz", "force_N", "torque_Nm")


def segmented(real_data: Path, name: str) -> Segmentation:
    with np.load(real_data / f"{name}.npz") as file:
        recording = Demonstration(name, **{key: file[key] for key in CHANNELS if key in file})
    return segment(recording, Parameters(variant="paper"))


def events(real_data: Path, name: str) -> list[float]:
    truth = json.loads((real_data / "truth.json").read_text())
    return [time for time, _ in truth[name]["events"]]


def contacts(found: Segmentation) -> np.ndarray:
    return np.array([b.time_s for b in found.boundaries if b.contact_change])


def test_a_yumi_lead_through_at_10_hz_with_a_force_offset(real_data):
    found = segmented(real_data, "lund_yumi/leadthrough")
    np.testing.assert_allclose(contacts(found), [7.4, 12.8], atol=0.11)
    labels = [piece.label for piece in found.segments]
    assert labels[0] == "idle"
    assert labels[-1] == "idle"
    assert labels[1].startswith("Move down")
    assert labels[1].endswith("until contact")
    assert len(labels) <= 8


def test_steps_in_raw_sensor_noise(real_data):
    found = segmented(real_data, "unnamed_arm_contact/trial_1")
    np.testing.assert_allclose(contacts(found), [2.0, 4.05], atol=0.05)


@pytest.mark.parametrize("trial", [3, 4, 5])
def test_contact_impact_and_snap_of_a_two_hand_assembly(real_data, trial):
    name = f"lund_two_hand_assembly/trial_{trial}"
    found = contacts(segmented(real_data, name))
    for event in events(real_data, name):
        assert np.abs(found - event).min() < 0.08


def test_a_snap_assembly_has_few_and_sure_contact_changes(real_data):
    found = segmented(real_data, "hiro_snap_assembly/S05")
    assert 3 <= len(contacts(found)) <= 6
    mating = min(found.boundaries, key=lambda boundary: abs(boundary.time_s - 16.4))
    assert mating.time_s == pytest.approx(16.4, abs=0.15)
    assert mating.confidence > 0.9


def test_human_pick_and_place_is_cut_about_where_people_cut_it(real_data):
    truths = read_truth(real_data / "truth.json")
    counts = [
        tally(truth, [b.time_s for b in segmented(real_data, name).boundaries])
        for name, truth in truths.items()
        if name.startswith("dfki_pick_and_place/")
    ]
    found, false = sum(each.found for each in counts), sum(each.false for each in counts)
    assert found >= 86
    assert false <= 94


def test_two_minutes_of_peeling_repeat_their_strokes(real_data):
    found = segmented(real_data, "lasa_peeling/demo_1")
    human = events(real_data, "lasa_peeling/demo_1")
    times = np.array([boundary.time_s for boundary in found.boundaries])
    near = [np.abs(times - event).min() < 0.75 for event in human]
    assert np.mean(near) > 0.85
    assert len(times) < 2.2 * len(human)


def test_following_a_contour_in_steady_contact_makes_no_contact_change(real_data):
    names = sorted(path.stem for path in (real_data / "kuleuven_contour").glob("*.npz"))
    found = [len(contacts(segmented(real_data, f"kuleuven_contour/{name}"))) for name in names]
    assert sum(found) <= 1
