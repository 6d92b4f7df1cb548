"""An arm along a whole demonstration."""

from dataclasses import replace

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

from keyphase.demonstration import Demonstration
from keyphase.robot.arm import Arm
from keyphase.robot.description import load_description
from keyphase.robot.follow import JointPath, Unreached, follow, posture_at, tool_poses
from keyphase.robot.pose import Placement
from keyphase.robot.yumi import yumi

RATE_HZ = 250


def loop(
    centre=(0.42, -0.15, 0.20), radius=0.1, duration_s=4.0, turning=True, name="loop"
) -> Demonstration:
    """A tool that circles, bobs and turns."""
    time = np.arange(0, duration_s, 1 / RATE_HZ)
    circle = np.column_stack([np.cos(time), np.sin(time), 0.4 * np.sin(3 * time)])
    wxyz = None
    if turning:
        about_z = Rotation.from_rotvec(np.outer(0.8 * np.sin(0.7 * time), [0, 0, 1]))
        about_x = Rotation.from_rotvec(np.outer(np.pi + 0.3 * np.sin(time), [1, 0, 0]))
        wxyz = (about_z * about_x).as_quat(scalar_first=True)
    return Demonstration(name, time, np.array(centre) + radius * circle, wxyz)


@pytest.fixture(scope="module")
def within():
    """A demonstration the arm can follow."""
    return loop()


@pytest.fixture(scope="module")
def beyond():
    """A demonstration that leaves the arm's reach and comes back, twice."""
    return loop(centre=(0.5, -0.2, 0.15), radius=0.25, duration_s=8.0)


@pytest.fixture(scope="module")
def followed(arm, within):
    return follow(arm, within)


@pytest.fixture(scope="module")
def partly(arm, beyond):
    return follow(arm, beyond)


def fastest(path, rate_hz=RATE_HZ) -> np.ndarray:
    return np.max(np.abs(np.diff(path.joints_rad, axis=0)), axis=0) * rate_hz


def test_every_sample_within_reach_is_met_within_two_micrometres(arm, within, followed):
    assert followed.reached.all()
    assert followed.unreached == ()
    for joints, wanted in zip(followed.joints_rad[::25], tool_poses(within)[::25], strict=True):
        tool = arm.forward(joints)
        assert np.linalg.norm(tool[:3, 3] - wanted[:3, 3]) <= 2e-6
        assert tool[:3, :3] == pytest.approx(wanted[:3, :3], abs=2e-5)


def test_the_path_is_continuous(robot, followed):
    assert followed.joints_rad.shape == (1000, 7)
    assert (fastest(followed) < 0.5 * robot.speed_rad_s).all()


@pytest.mark.parametrize("fixture", ["followed", "partly"])
def test_joint_limits_are_never_passed_and_no_step_is_a_jump(robot, fixture, request):
    path = request.getfixturevalue(fixture)

    assert (path.joints_rad >= robot.lower_rad).all()
    assert (path.joints_rad <= robot.upper_rad).all()
    allowed = np.maximum(robot.speed_rad_s, 0.02 * RATE_HZ)
    assert (fastest(path) <= allowed * (1 + 1e-9)).all()


def test_stretches_out_of_reach_are_reported_with_time_and_distance(arm, beyond, partly):
    assert len(partly.unreached) == 2
    first, second = partly.unreached
    assert (first.start_s, beyond.end_s > second.end_s) == (0.0, True)
    for stretch in partly.unreached:
        rows = slice(beyond.index_at(stretch.start_s), beyond.index_at(stretch.end_s) + 1)
        missed = [
            np.linalg.norm(arm.forward(joints)[:3, 3] - wanted[:3, 3])
            for joints, wanted in zip(
                partly.joints_rad[rows], tool_poses(beyond)[rows], strict=True
            )
        ]
        assert stretch.distance_m == pytest.approx(max(missed))
        assert stretch.distance_m > 0.01
    assert 0.5 < partly.reached.mean() < 1
    assert (partly.distance_m[partly.reached] <= 2e-6).all()


def test_missed_samples_close_in_time_are_one_stretch():
    time = np.arange(10) * 0.04
    distance = np.array([0, 0.3, 0, 0.1, 0.2, 0, 0, 0, 0.4, 0])
    path = JointPath(time, np.zeros((10, 7)), distance, np.zeros(10))

    assert path.unreached == (Unreached(0.04, 0.16, 0.3, 0.0), Unreached(0.32, 0.32, 0.4, 0.0))


def test_an_arm_that_is_too_slow_lags_behind_and_says_so(urdf):
    hinge = Arm(load_description(urdf(), "tool"))
    time = np.arange(0, 0.5, 0.02)
    angles = np.clip(6.0 * time, 0, 1.5)
    half = angles / 2
    wxyz = np.column_stack([np.cos(half), 0 * half, np.sin(half), 0 * half])
    fast = Demonstration("fast", time, np.tile([0.0, 0, 1], (len(time), 1)), wxyz)

    path = follow(hinge, fast)

    assert fastest(path, 50) == pytest.approx([3.0])
    (late,) = path.unreached
    assert late.angle_rad == pytest.approx(0.75, abs=0.1)
    assert path.joints_rad[-1] == pytest.approx([1.5], abs=0.2)


def test_where_nothing_can_be_reached_all_of_it_is_reported(arm):
    path = follow(arm, loop(centre=(3.0, 0.0, 0.0), duration_s=0.2))

    (stretch,) = path.unreached
    assert (stretch.start_s, stretch.end_s) == (path.time_s[0], path.time_s[-1])
    assert 2.0 < stretch.distance_m < 3.0


def test_a_placement_brings_a_far_recording_within_reach(arm):
    far = loop(centre=(3.0, 1.0, -2.0), duration_s=0.4)

    path = follow(arm, far, Placement((-2.6, -1.15, 2.2)))

    assert path.reached.all()


def test_without_orientation_the_tool_points_down(arm):
    path = follow(arm, loop(turning=False, duration_s=1.0))

    assert path.reached.all()
    for joints in path.joints_rad[::50]:
        assert arm.forward(joints)[:3, 2] == pytest.approx([0, 0, -1], abs=2e-5)


def test_while_the_tool_rests_the_arm_rests(arm):
    still = Demonstration("still", np.arange(100) / RATE_HZ, np.tile([0.4, -0.1, 0.3], (100, 1)))

    path = follow(arm, still)

    assert path.reached.all()
    assert np.ptp(path.joints_rad, axis=0) == pytest.approx(np.zeros(7), abs=1e-9)


def test_after_a_round_trip_the_posture_has_not_drifted(arm):
    around = loop(duration_s=30.0, turning=False)
    turn = round(2 * np.pi * RATE_HZ)

    joints = follow(arm, around).joints_rad

    assert np.abs(joints[3 * turn] - joints[4 * turn]).max() < 0.02


def test_the_left_arm_follows_the_mirrored_path_alike(within, followed):
    mirrored = Rotation.from_matrix(
        np.diag([1, -1, 1]) @ tool_poses(within)[:, :3, :3] @ np.diag([1, -1, 1])
    ).as_quat(scalar_first=True)
    other_side = Demonstration("left", within.time_s, within.position_m * [1, -1, 1], mirrored)

    path = follow(Arm(yumi("l")), other_side)

    assert path.reached.all()
    signs = [-1, 1, -1, 1, -1, 1, -1]
    assert path.joints_rad == pytest.approx(followed.joints_rad * signs, abs=1e-3)


def test_a_given_posture_is_started_from(arm, within, followed):
    other = followed.joints_rad[0] + [0.4, 0.1, 0.1, 0, 0, 0.2, 0.3]

    path = follow(arm, within, start_rad=other)

    assert path.reached.all()
    assert np.abs(path.joints_rad[0] - followed.joints_rad[0]).max() > 0.05


def test_recorded_joints_are_started_from(arm, within, followed):
    other = followed.joints_rad[0] + [0.4, 0.1, 0.1, 0, 0, 0.2, 0.3]
    recorded = replace(within, joints_rad=np.tile(other, (len(within), 1)))

    path = follow(arm, recorded)

    assert path.joints_rad.tobytes() == follow(arm, within, start_rad=other).joints_rad.tobytes()
    assert path.joints_rad.tobytes() != followed.joints_rad.tobytes()


def test_recorded_joints_of_another_robot_are_ignored(arm, within, followed):
    six_axes = replace(within, joints_rad=np.zeros((len(within), 6)))

    assert follow(arm, six_axes).joints_rad.tobytes() == followed.joints_rad.tobytes()


def test_the_noise_of_a_recording_is_followed(arm, within):
    noise = np.random.default_rng(0).normal(0, 0.001, within.position_m.shape)

    path = follow(arm, replace(within, position_m=within.position_m + noise))

    assert path.reached.all()


def test_progress_is_heard_from_none_to_all(arm, within):
    heard: list[float] = []

    follow(arm, within, progress=heard.append)

    assert heard == sorted(heard)
    assert heard[0] < 0.2
    assert heard[-1] == 1.0


def test_the_same_demonstration_gives_the_same_joints(arm, within, followed):
    assert follow(arm, within).joints_rad.tobytes() == followed.joints_rad.tobytes()


def test_of_a_long_demonstration_some_poses_are_followed_and_every_sample_is_still_met(
    arm, within, monkeypatch
):
    monkeypatch.setattr("keyphase.robot.follow.MAX_FOLLOWED", 60)
    path = follow(arm, within)
    placement = Placement()

    postures = [posture_at(arm, within, path, time, placement) for time in within.time_s]

    assert len(path.time_s) <= 60
    assert all(reached for _, reached in postures)
    tools = np.array([arm.forward(joints)[:3, 3] for joints, _ in postures])
    np.testing.assert_allclose(tools, within.position_m, atol=2e-6)
    steps = np.abs(np.diff([joints for joints, _ in postures], axis=0)).max(axis=0)
    assert (steps * RATE_HZ <= arm.robot.speed_rad_s).all()


def test_stretches_out_of_reach_are_found_in_a_long_demonstration_too(
    arm, beyond, partly, monkeypatch
):
    monkeypatch.setattr("keyphase.robot.follow.MAX_FOLLOWED", 60)
    coarse = follow(arm, beyond).unreached

    assert len(coarse) == len(partly.unreached)
