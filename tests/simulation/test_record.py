"""What the scripted operator records, and that the segmentation finds its phases."""

import hashlib

import numpy as np
import pytest
from right_segments import PHASES, segmented_right

from keyphase.errors import SimulationError
from keyphase.files.shipped import shipped
from keyphase.readers import read, save_npz
from keyphase.simulation import Disturbance, record
from keyphase.simulation.demonstrating import recording as recording_module

NAMES = ["setup1", "setup2"]
BUNDLED_SEED = 7


def digest(demonstration, folder) -> str:
    save_npz(demonstration, folder / "recording.npz")
    return hashlib.sha256((folder / "recording.npz").read_bytes()).hexdigest()


@pytest.mark.parametrize("name", NAMES)
def test_the_same_seed_gives_the_same_bytes(name, tmp_path) -> None:
    assert digest(record(name, seed=11), tmp_path) == digest(record(name, seed=11), tmp_path)


@pytest.mark.parametrize("name", NAMES)
def test_another_seed_gives_another_recording(name, recorded) -> None:
    first, second = recorded(name, 0), recorded(name, 1)
    assert len(first) != len(second) or not np.array_equal(first.position_m, second.position_m)


@pytest.mark.parametrize("name", NAMES)
def test_bundled_recordings_are_what_the_seed_gives(name) -> None:
    bundled, again = read(shipped("data") / f"{name}.npz"), record(name, seed=BUNDLED_SEED)
    made_by = {"recorder"}
    assert {k: v for k, v in bundled.metadata.items() if k not in made_by} == {
        k: v for k, v in again.metadata.items() if k not in made_by
    }
    # Another processor may round otherwise; the motion is the same.
    assert np.allclose(bundled.position_m, again.position_m, atol=1e-5)
    assert np.abs(bundled.force_N - again.force_N).mean() < 0.05


@pytest.mark.parametrize("name", NAMES)
def test_metadata_say_where_a_recording_comes_from(name, recorded) -> None:
    metadata = recorded(name, 0).metadata
    assert metadata["workcell"] == name
    assert metadata["seed"] == 0
    assert metadata["operator"] == "scripted"
    assert metadata["simulator"].startswith("MuJoCo ")
    assert metadata["disturbance"]["friction"] == 0.3
    assert len(metadata["joint_names"]) == recorded(name, 0).joints_rad.shape[1] == 7


@pytest.mark.parametrize("name", NAMES)
def test_phases_tile_the_recording_in_the_order_of_the_task(name, recorded) -> None:
    demonstration = recorded(name, 2)
    phases = demonstration.metadata["ground_truth"]["phases"]
    assert [phase["name"] for phase in phases] == PHASES[name]
    edges = [phase["start_s"] for phase in phases] + [phases[-1]["end_s"]]
    assert edges[0] == 0.0
    assert edges[-1] == pytest.approx(demonstration.end_s)
    assert (np.diff(edges) > 0.3).all()
    assert [p["end_s"] for p in phases[:-1]] == edges[1:-1]


@pytest.mark.parametrize("name", NAMES)
@pytest.mark.parametrize("seed", [0, 1, 2, 3])
def test_contact_onsets_are_where_the_force_changes(name, seed, recorded) -> None:
    demonstration = recorded(name, seed)
    for onset in demonstration.metadata["ground_truth"]["contact_changes_s"]:
        at = demonstration.index_at(onset)
        before = demonstration.force_N[at - 30 : at - 10].mean(axis=0)
        after = demonstration.force_N[at + 5 : at + 22].mean(axis=0)
        assert np.linalg.norm(after - before) > 1.0


@pytest.mark.parametrize("seed", [0, 1, 2, 3])
def test_the_snap_is_felt_after_the_touch_and_is_the_largest_step(seed, recorded) -> None:
    demonstration = recorded("setup1", seed)
    onsets = demonstration.metadata["ground_truth"]["contact_onsets_s"]
    assert 0.0 < onsets["snap"] - onsets["touch"] < 0.3
    upward = demonstration.force_N[:, 2]
    over_20ms = upward[5:] - upward[:-5]
    largest = demonstration.time_s[int(np.argmax(over_20ms[: demonstration.index_at(5.0)]))]
    assert onsets["snap"] - 0.02 <= largest <= onsets["snap"] + 0.06
    plunger = slice(demonstration.index_at(onsets["touch"]), demonstration.index_at(onsets["snap"]))
    assert 1.0 < upward[plunger].max() < 4.0, "the detent resists first"


def test_no_force_above_what_parts_stand(recorded) -> None:
    for name in NAMES:
        for seed in range(4):
            force = np.linalg.norm(recorded(name, seed).force_N, axis=1)
            assert force.max() < 25.0


def test_an_operator_who_failed_is_told(monkeypatch) -> None:
    def leads_nowhere(simulation, path, course):
        return []

    monkeypatch.setattr(recording_module, "lead", leads_nowhere)
    with pytest.raises(SimulationError, match="ended without: snapped on, slid together"):
        record("setup1", seed=0)


@pytest.mark.parametrize("name", NAMES)
def test_a_disturbed_world_is_recorded_as_such(name) -> None:
    disturbance = Disturbance(part_height_m=0.01, part_offset_m=(0.003, -0.003), friction=0.4)
    demonstration = record(name, seed=1, disturbance=disturbance)
    assert demonstration.metadata["disturbance"]["part_height_m"] == 0.01
    lowest = demonstration.position_m[:, 2].min()
    assert lowest - record(name, seed=1).position_m[:, 2].min() == pytest.approx(0.01, abs=2e-3)


@pytest.mark.parametrize("name", NAMES)
def test_the_bundled_recordings_give_the_phases_of_the_paper(name) -> None:
    assert segmented_right(name, BUNDLED_SEED)


@pytest.mark.slow
@pytest.mark.parametrize("name", NAMES)
def test_default_parameters_are_right_for_nearly_every_seed(name) -> None:
    """The first of the hundred that `accuracy_recording.py` counts."""
    assert sum(segmented_right(name, seed) for seed in range(8)) >= 7
