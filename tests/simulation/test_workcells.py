"""What the workcells are, how disturbances change them, and when their task is done."""

import numpy as np
import pytest

from keyphase.errors import SimulationError
from keyphase.simulation import Disturbance, Reference, Simulation
from keyphase.simulation.workcells.course import Course
from keyphase.simulation.workcells.seating import seat_gap_m
from keyphase.simulation.workcells.setup1 import SETUP1
from keyphase.simulation.workcells.setup2 import BUTTONS, SETUP2

CELLS = (SETUP1, SETUP2)
both = pytest.mark.parametrize("cell", CELLS, ids=lambda cell: cell.name)


def rest(simulation: Simulation, seconds: float) -> None:
    here = simulation.here()
    for _ in range(round(seconds * 250)):
        simulation.step(here)


def place(simulation: Simulation, part: str) -> np.ndarray:
    return simulation.part_poses()[part][0]


@both
def test_parts_and_tool_rest_where_they_are_put(cell) -> None:
    simulation = cell.build()
    tool = simulation.here().position_m
    rest(simulation, 0.5)
    for part, (position, _) in simulation.part_poses().items():
        assert np.allclose(position, simulation.start_parts[part][0], atol=6e-4), part
    assert np.allclose(simulation.here().position_m, tool, atol=1e-4)


@both
def test_an_untouched_workcell_is_no_success(cell) -> None:
    simulation = cell.build()
    course = Course(cell)
    for _ in range(25):
        simulation.step(simulation.here())
        course.watch(simulation)
    assert tuple(course.checks(simulation)) == cell.goals(simulation)
    assert not any(course.checks(simulation).values())


@both
def test_higher_parts_are_higher(cell) -> None:
    simulation = cell.build(Disturbance(part_height_m=0.01))
    rise = place(simulation, "housing") - place(cell.build(), "housing")
    assert rise == pytest.approx([0.0, 0.0, 0.01])


@both
def test_moved_parts_are_aside_and_the_rest_stays(cell) -> None:
    simulation, nominal = cell.build(Disturbance(part_offset_m=(0.005, -0.004))), cell.build()
    moved = place(simulation, "housing") - place(nominal, "housing")
    assert moved == pytest.approx([0.005, -0.004, 0.0])
    assert np.array_equal(place(simulation, "held"), place(nominal, "held"))
    assert np.array_equal(place(simulation, "table"), place(nominal, "table"))


@both
def test_friction_reaches_table_and_parts(cell) -> None:
    simulation = cell.build(Disturbance(friction=0.55))
    for geom in ("table", "housing"):
        assert simulation.model.geom(geom).friction[0] == pytest.approx(0.55)


@both
def test_a_tilted_grasp_tilts_the_held_part(cell) -> None:
    nominal = cell.build().part_poses()["held"][1]
    tilted = cell.build(Disturbance(tilt_rad=0.02)).part_poses()["held"][1]
    angle = 2.0 * np.arccos(min(1.0, abs(float(nominal @ tilted))))
    assert angle == pytest.approx(0.02, rel=1e-3)


@both
def test_sensor_noise_grows_with_its_factor(cell) -> None:
    def spread(factor: float) -> float:
        simulation = cell.build(Disturbance(sensor_noise=factor))
        here = simulation.here()
        return float(np.std([simulation.step(here).force_N[0] for _ in range(200)]))

    assert spread(2.0) == pytest.approx(2.0 * spread(1.0), rel=0.2)


@pytest.mark.parametrize(
    "wrong",
    [
        {"part_height_m": 0.2},
        {"part_height_m": float("nan")},
        {"part_offset_m": (0.1, 0.0)},
        {"part_offset_m": (0.0,)},
        {"friction": -0.1},
        {"sensor_noise": -1.0},
        {"tilt_rad": 1.0},
        {"part_turn_rad": 2.0},
        {"mass": 0.0},
        {"sensor_bias_N": -1.0},
        {"sensor_drift": float("inf")},
    ],
)
def test_disturbances_nobody_built_for_are_refused(wrong) -> None:
    with pytest.raises(SimulationError, match=next(iter(wrong))):
        Disturbance(**wrong)


@both
def test_a_turned_part_is_turned_about_the_vertical(cell) -> None:
    turned = cell.build(Disturbance(part_turn_rad=0.1)).part_poses()["housing"][1]
    assert turned == pytest.approx([np.cos(0.05), 0.0, 0.0, np.sin(0.05)])


@both
def test_heavier_parts_weigh_more_and_the_held_one_does_not(cell) -> None:
    nominal, heavy = cell.build().model, cell.build(Disturbance(mass=10.0)).model
    assert heavy.body("housing").mass == pytest.approx(10.0 * nominal.body("housing").mass)
    assert heavy.body("held").mass == pytest.approx(nominal.body("held").mass)


def test_a_sensor_that_is_off_reads_too_much_by_that_and_another_seed_elsewhere() -> None:
    def mean(seed: int, bias_N: float) -> np.ndarray:
        simulation = SETUP1.build(Disturbance(sensor_bias_N=bias_N), seed)
        here = simulation.here()
        return np.mean([simulation.step(here).force_N for _ in range(25)], axis=0)

    offsets = [mean(seed, 1.0) - mean(seed, 0.0) for seed in (0, 1)]
    for offset in offsets:
        assert np.linalg.norm(offset) == pytest.approx(1.0, abs=0.02)
    assert np.linalg.norm(offsets[0] - offsets[1]) > 0.1


def lower(simulation: Simulation, by_m: float, seconds: float = 1.5) -> None:
    start = simulation.here()
    for fraction in np.linspace(0.0, 1.0, round(seconds * 250)):
        down = start.position_m - [0.0, 0.0, by_m * fraction]
        simulation.step(Reference(down, start.orientation_wxyz))
    rest_at = Reference(start.position_m - [0.0, 0.0, by_m], start.orientation_wxyz)
    for _ in range(50):
        simulation.step(rest_at)


def move_over_housing(simulation: Simulation, aside_m: float = 0.0) -> None:
    start = simulation.here()
    over = place(simulation, "housing") - place(simulation, "held") + [aside_m, 0.0, 0.0]
    over[2] = 0.0
    for fraction in np.linspace(0.0, 1.0, 375):
        goal = start.position_m + over * fraction
        simulation.step(Reference(goal, start.orientation_wxyz))
    for _ in range(150):
        simulation.step(Reference(start.position_m + over, start.orientation_wxyz))


def test_the_cap_snaps_onto_the_housing_and_stays_down_by_itself() -> None:
    simulation = SETUP1.build()
    move_over_housing(simulation)
    lower(simulation, seat_gap_m(simulation) + 0.002)
    assert SETUP1.checks(simulation)["seated"]
    assert simulation.data.joint("plunger").qpos[0] < -0.0024, "the plunger has flipped"


def test_a_light_touch_does_not_snap() -> None:
    simulation = SETUP1.build()
    move_over_housing(simulation)
    lower(simulation, seat_gap_m(simulation) - 0.0009)
    assert simulation.contact_forces()["touch"] > 0.5
    assert not SETUP1.checks(simulation)["seated"]


@pytest.mark.parametrize("aside_m", [0.006, 0.02])
def test_a_cap_beside_its_rim_is_not_seated_however_hard_it_is_pressed(aside_m) -> None:
    simulation = SETUP1.build()
    move_over_housing(simulation, aside_m)
    lower(simulation, seat_gap_m(simulation) + 0.004)
    assert not SETUP1.checks(simulation)["seated"]


def test_the_chamfer_takes_in_a_cap_that_is_two_millimetres_aside() -> None:
    simulation = SETUP1.build()
    move_over_housing(simulation, 0.002)
    lower(simulation, seat_gap_m(simulation) + 0.003)
    assert SETUP1.checks(simulation)["seated"]


def test_a_cap_that_is_not_turned_rests_on_the_rails() -> None:
    simulation = SETUP2.build()
    move_over_housing(simulation)
    lower(simulation, seat_gap_m(simulation) + 0.002)
    assert not SETUP2.checks(simulation)["seated"]
    assert seat_gap_m(simulation) > 0.005


def test_the_buttons_in_the_way_are_free_and_need_to_be_moved() -> None:
    simulation = SETUP2.build()
    before = {name: place(simulation, name) for name in BUTTONS}
    simulation.push(BUTTONS[0], [0.0, 4.0, 0.0])
    rest(simulation, 0.5)
    for name in BUTTONS:
        assert place(simulation, name)[1] > before[name][1] + 0.02
    assert SETUP2.checks(simulation)["buttons moved"]


def test_parts_at_rest_sleep_until_something_moves_them() -> None:
    simulation = SETUP2.build()
    trees = simulation.model.body_treeid[[simulation.model.body(name).id for name in BUTTONS]]
    rest(simulation, 0.2)
    assert not simulation.data.tree_awake[trees].any()
    before = place(simulation, BUTTONS[0])
    simulation.push(BUTTONS[0], [0.0, 4.0, 0.0])
    rest(simulation, 0.2)
    assert simulation.data.tree_awake[trees].all()
    assert place(simulation, BUTTONS[0])[1] > before[1] + 0.01


@both
def test_every_part_can_be_drawn(cell) -> None:
    shapes = cell.build().shapes()
    assert {shape.body for shape in shapes} == set(cell.parts)
    assert all((shape.size_m > 0.0).all() for shape in shapes)
    assert "knob" in {shape.name for shape in shapes}


def test_pushing_what_is_not_there_is_refused() -> None:
    with pytest.raises(SimulationError, match="'lamp' is not"):
        SETUP1.build().push("lamp", [0.0, 0.0, 1.0])


def test_physics_that_diverge_are_told(tmp_path, monkeypatch) -> None:
    # MuJoCo leaves a log where it is.
    monkeypatch.chdir(tmp_path)
    simulation = SETUP1.build()
    simulation.push("held", [1e6, 0.0, 1e6])
    with pytest.raises(SimulationError, match="diverged"):
        rest(simulation, 1.0)
