"""Files as labs write them: the proposed recipe, completed, reads them value by value."""

import re
from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

from keyphase.demonstration import Array, Demonstration
from keyphase.errors import DemonstrationError
from keyphase.readers import parse_recipe, read
from keyphase.readers.proposing.proposal import propose

ROWS = 120
TIME = np.arange(ROWS) / 100
POSITION = np.stack([0.45 + 0.1 * TIME, 0.02 * np.sin(TIME), 0.3 - 0.1 * TIME], axis=1)
TURNS = Rotation.from_euler("xyz", np.stack([3.0 + 0 * TIME, 0.1 * TIME, 0.4 * TIME], axis=1))
XYZW = TURNS.as_quat()
FORCE = np.stack([0.1 * TIME, -2 * (TIME > 0.5), 9.0 * (TIME > 0.5)], axis=1)

Columns = dict[str, Array]


def usual() -> Columns:
    columns = {"time": TIME}
    columns |= {name: POSITION[:, i] for i, name in enumerate("xyz")}
    columns |= {f"q{name}": XYZW[:, i] for i, name in enumerate("xyzw")}
    return columns | {f"f{name}": FORCE[:, i] for i, name in enumerate("xyz")}


def rows(columns: Columns, separator: str = ",") -> list[str]:
    cells = (
        [f"{v:.9f}" if np.isfinite(v) else "" for v in row]
        for row in zip(*columns.values(), strict=True)
    )
    return [separator.join(row) for row in cells]


def csv(columns: Columns, header: str | None = None, separator: str = ",") -> bytes:
    first = separator.join(columns) if header is None else header
    return ("\n".join([first, *rows(columns, separator)]) + "\n").encode()


def units_below() -> bytes:
    names = ",".join(usual())
    in_mm = usual() | {name: 1000 * POSITION[:, i] for i, name in enumerate("xyz")}
    return csv(in_mm, f"{names}\ns,mm,mm,mm,,,,,N,N,N")


def merged_topics() -> bytes:
    """A row for each message: the pose in even rows, the force in odd ones."""
    columns = {name: values.copy() for name, values in usual().items()}
    for name, values in columns.items():
        if name != "time":
            values[name.startswith("f") :: 2] = np.nan
    return csv(columns)


def matrix() -> bytes:
    poses = np.tile(np.eye(4), (ROWS, 1, 1))
    poses[:, :3, :3], poses[:, :3, 3] = TURNS.as_matrix(), POSITION
    flat = poses.transpose(0, 2, 1).reshape(ROWS, 16)
    named = {f"T_{i}": flat[:, i] for i in range(16)}
    return csv({"time": TIME, **named, **{f"f{a}": FORCE[:, i] for i, a in enumerate("xyz")}})


def stamped(form: Callable[[float], str]) -> bytes:
    header = ",".join(["stamp", *list(usual())[1:]])
    lines = [
        f"{form(t)},{row.partition(',')[2]}" for t, row in zip(TIME, rows(usual()), strict=True)
    ]
    return ("\n".join([header, *lines]) + "\n").encode()


TABLES = {
    "units_below": units_below(),
    "merged_topics": merged_topics(),
    "matrix": matrix(),
    "iso": stamped(lambda t: f"2025-03-01T10:12:{t + 1:09.6f}Z"),
    "german_dates": stamped(lambda t: f"01.03.2025 10:12:{t + 1:09.6f}"),
    "nanoseconds": stamped(lambda t: str(1740822000123456789 + round(1e9 * t))),
    "doubled_names": csv(usual(), "time,x,y,z,x,y,z,w,fx,fy,fz"),
    "no_header": ("\n".join(rows(usual(), " ")) + "\n").encode(),
    "frames_counted": csv({"frame": np.arange(ROWS) * 1.0, **usual()}),
    "commanded_too": csv({**{f"target_{a}": 0 * TIME + i for i, a in enumerate("xyz")}, **usual()}),
    "raw_force_too": csv({**{f"raw_f{a}": 0 * TIME + i for i, a in enumerate("xyz")}, **usual()}),
}


def completed(text: str) -> str:
    """What a person says of these files: xyzw, and a wrench on the tool in the base's axes."""
    text = text.replace('# frame = "base"', 'frame = "base"').replace("# sign = 1", "sign = 1")
    text = text.replace("# order =", 'order = "xyzw"')
    columns = 'kind = "quaternion"\ncolumns = [4, 5, 6, 7]' in text
    if columns and "\n[force]" not in text:
        text = text.replace("[wrench]", "")
        text += '[force]\ncolumns = [8, 9, 10]\nunit = "N"\n[wrench]\nframe = "base"\nsign = 1\n'
    return re.sub(r"# Not read:.*", "", text)


def read_as_proposed(path: Path) -> Demonstration:
    return read(path, parse_recipe(completed(propose(path).recipe_text()), "completed"))


@pytest.mark.parametrize("name", TABLES)
def test_a_proposal_reads_what_was_written(tmp_path: Path, name: str) -> None:
    path = tmp_path / f"{name}.csv"
    path.write_bytes(TABLES[name])
    found = read_as_proposed(path)
    at = found.time_s - found.time_s[0] + (TIME[1] if name == "merged_topics" else 0)
    for axis in range(3):
        expected = np.interp(at, TIME, POSITION[:, axis])
        np.testing.assert_allclose(found.position_m[:, axis], expected, atol=2e-6)
    assert found.orientation_wxyz is not None
    assert found.force_N is not None
    turned = Rotation.from_quat(found.orientation_wxyz, scalar_first=True)
    np.testing.assert_allclose((turned[0].inv() * TURNS[0]).magnitude(), 0, atol=0.01)
    np.testing.assert_allclose(found.force_N[-1], FORCE[-1], atol=0.05)


def test_an_order_that_no_name_says_is_left_open_however_the_numbers_look(tmp_path: Path) -> None:
    """A tool that points down is as near 1 in x as a tool at rest is in w."""
    path = tmp_path / "no_header.csv"
    path.write_bytes(TABLES["no_header"])
    assert "orientation.order" in propose(path).open


def test_several_demonstrations_in_one_table_are_told_apart(tmp_path: Path) -> None:
    twice = {name: np.concatenate([values, values]) for name, values in usual().items()}
    again, numbered = tmp_path / "again.csv", tmp_path / "numbered.csv"
    again.write_bytes(csv(twice))
    number = np.repeat([0.0, 1.0], ROWS)
    numbered.write_bytes(csv({"episode_index": number, **twice}))
    assert "time_starts_again = true" in propose(again).recipe_text()
    text = propose(numbered).recipe_text()
    assert 'demonstration = "episode_index"' in text
    assert 'column = "time"' in text


def test_a_number_of_the_row_is_no_time(tmp_path: Path) -> None:
    path = tmp_path / "counted.csv"
    path.write_bytes(csv({"sample": np.arange(ROWS) * 1.0, **dict(list(usual().items())[1:])}))
    assert "time is missing" in propose(path).open


def test_a_known_recorder_is_proposed_by_its_preset(tmp_path: Path) -> None:
    path = tmp_path / "rtde.csv"
    pose, force = np.hstack([POSITION, TURNS.as_rotvec()]), np.hstack([FORCE, 0 * FORCE])
    columns = {"timestamp": TIME}
    columns |= {f"actual_TCP_pose_{i}": pose[:, i] for i in range(6)}
    columns |= {f"actual_TCP_force_{i}": force[:, i] for i in range(6)}
    path.write_bytes(csv(columns))
    proposal = propose(path)
    assert proposal.recipe_text().startswith('preset = "ur_rtde"')
    found = read(path, parse_recipe(completed(proposal.recipe_text()), "completed"))
    assert found.torque_Nm is not None
    np.testing.assert_allclose(found.force_N, FORCE, atol=1e-6)


def test_a_preset_that_leaves_nothing_open_reads_a_plain_table_alone(tmp_path: Path) -> None:
    wxyz = XYZW[:, [3, 0, 1, 2]]
    columns = {"header.tm": np.round(1000 * TIME)}
    columns |= {f"feedBack.cartesian.pos.{a}": 1000 * POSITION[:, i] for i, a in enumerate("xyz")}
    columns |= {f"feedBack.cartesian.orient.u{i}": wxyz[:, i] for i in range(4)}
    path = tmp_path / "egm.csv"
    path.write_bytes(csv(columns))
    np.testing.assert_allclose(read(path).position_m, POSITION, atol=1e-8)


def test_what_would_not_be_read_is_listed(tmp_path: Path) -> None:
    path = tmp_path / "log.csv"
    path.write_bytes(csv({**usual(), "motor_current": TIME}))
    assert propose(path).unread == ("motor_current",)


def test_two_tools_side_by_side_are_two_demonstrations(tmp_path: Path) -> None:
    columns = {"time": TIME}
    for side, offset in (("left", 0.5), ("right", -0.5)):
        columns |= {f"{side}_{a}": POSITION[:, i] + offset for i, a in enumerate("xyz")}
        columns |= {f"{side}_q{a}": XYZW[:, i] for i, a in enumerate("xyzw")}
    path = tmp_path / "arms.csv"
    path.write_bytes(csv(columns))
    recipe = parse_recipe(propose(path).recipe_text(), "proposed")
    right = read(f"{path}#right", recipe)
    np.testing.assert_allclose(right.position_m, POSITION - 0.5, atol=1e-8)


def test_which_of_several_places_is_the_tools_is_left_open(tmp_path: Path) -> None:
    columns = {"time": TIME}
    for name in ("Elbow", "Thumb"):
        columns |= {f"{name} {axis}": POSITION[:, i] for i, axis in enumerate("XYZ")}
    path = tmp_path / "markers.csv"
    path.write_bytes(csv(columns))
    proposal = propose(path)
    assert "position.columns" in proposal.open
    assert '# columns = ["Elbow X", "Elbow Y", "Elbow Z"]' in proposal.recipe_text()


def test_micrometres_are_read_as_they_are_named(tmp_path: Path) -> None:
    header = "t,Weg X (µm),Weg Y (µm),Weg Z (µm)"
    path = tmp_path / "weg.csv"
    path.write_bytes(
        csv({"t": TIME, **{a: 1e6 * POSITION[:, i] for i, a in enumerate("xyz")}}, header)
    )
    np.testing.assert_allclose(read_as_proposed(path).position_m, POSITION, atol=1e-9)


def test_a_unit_that_is_not_known_is_asked_for(tmp_path: Path) -> None:
    path = tmp_path / "pixels.csv"
    header = "t,x [px],y [px],z [px]"
    path.write_bytes(csv({"t": TIME, **{a: POSITION[:, i] for i, a in enumerate("xyz")}}, header))
    assert "position.unit" in propose(path).open


def test_three_numbers_that_turn_are_a_vector_or_angles_as_a_person_says(tmp_path: Path) -> None:
    columns = {"t": TIME, **{a: POSITION[:, i] for i, a in enumerate("xyz")}}
    path = tmp_path / "rotvec.csv"
    path.write_bytes(csv(columns | {f"r{a}": POSITION[:, i] for i, a in enumerate("xyz")}))
    assert "orientation.kind" in propose(path).open


@pytest.mark.parametrize("yaw", [0.0, 1.2])
@pytest.mark.parametrize("kind", ["one axis", "three axes"])
def test_numbers_that_lie_or_turn_over_as_one_axis_does_say_so(
    tmp_path: Path, kind: str, yaw: float
) -> None:
    """A tool that points down tilts to and fro about half a turn, as a UR writes it, or others."""
    roll, pitch = np.pi + 0.1 * np.sin(3.0 * TIME), 0.1 * np.cos(3.0 * TIME)
    turns = Rotation.from_euler("xyz", np.stack([roll, pitch, yaw + 0 * TIME], axis=1))
    numbers = turns.as_rotvec() if kind == "one axis" else turns.as_euler("xyz")
    columns = {"t": TIME, **{f"TCP_{a}": POSITION[:, i] for i, a in enumerate("xyz")}}
    path = tmp_path / "tcp.csv"
    path.write_bytes(csv(columns | {f"TCP_r{a}": numbers[:, i] for i, a in enumerate("xyz")}))
    assert ("a rotation vector" in propose(path).recipe_text()) == (kind == "one axis")


def test_another_clock_in_the_table_is_asked_about(tmp_path: Path) -> None:
    path = tmp_path / "clocks.csv"
    path.write_bytes(csv({**usual(), "ft_time": TIME + 0.003}))
    assert '# time = "ft_time"' in propose(path).recipe_text()


@pytest.mark.parametrize(
    ("data", "told"),
    [
        (b'{"t": [0, 1]}', "JSON"),
        (b'{"t": 0}\n{"t": 1}\n', "JSON"),
        (b"PK\3\4 [Content_Types].xml", "Excel"),
    ],
)
def test_what_is_no_table_is_refused_with_what_to_do(
    tmp_path: Path, data: bytes, told: str
) -> None:
    (tmp_path / "run.txt").write_bytes(data)
    with pytest.raises(DemonstrationError, match=told):
        read(tmp_path / "run.txt")
