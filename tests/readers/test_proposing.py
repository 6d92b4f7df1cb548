"""What an unknown table probably is: proposed with evidence, never counted on its own."""

from pathlib import Path

import numpy as np
import pytest

from keyphase.errors import DemonstrationError, RecipeError
from keyphase.readers import parse_recipe, read
from keyphase.readers.proposing.layout import layout_of
from keyphase.readers.proposing.proposal import propose

NAMES = "Zeit [ms];Px [mm];Py [mm];Pz [mm];qx;qy;qz;qw;Fx [N];Fy [N];Fz [N];Greifer [mm];Status"


def german(rows: int = 300) -> bytes:
    """A log with everything that is different from a plain CSV."""
    lines = ["# Versuch 3: Fügen", "# Prüfstand", NAMES]
    for i in range(rows):
        numbers = [400 + i / 100, 20, 300, 0, 0, 0.1, np.sqrt(0.99), 0.1, 0.2, -5, 40]
        cells = [str(152345 + 4 * i), *(f"{v:.4f}".replace(".", ",") for v in numbers), "läuft"]
        lines.append(";".join(cells))
    return "\r\n".join(lines).encode("cp1252")


@pytest.fixture
def log(tmp_path: Path) -> Path:
    path = tmp_path / "Versuch_03.csv"
    path.write_bytes(german())
    return path


def test_a_german_log_is_understood_but_for_what_only_a_person_knows(log: Path) -> None:
    proposal = propose(log)
    assert proposal.open == ("wrench.frame", "wrench.sign")
    found = {g.role: ([proposal.names[c] for c in g.columns], g.unit) for g in proposal.guesses}
    assert found["time"] == (["Zeit [ms]"], "ms")
    assert found["position"] == (["Px [mm]", "Py [mm]", "Pz [mm]"], "mm")
    assert found["quaternion"] == (["qx", "qy", "qz", "qw"], "")
    assert found["gripper"] == (["Greifer [mm]"], "mm")


def test_the_evidence_says_what_was_seen(log: Path) -> None:
    text = propose(log).recipe_text()
    assert "steps of 4: ms, which makes 250 Hz" in text
    assert "norm of these four is 1.000 in every row: a quaternion" in text
    assert "byte 0xfc in line 1 is no UTF-8 ('ü' here)" in text


def test_what_is_open_must_be_said_before_anything_is_read(log: Path) -> None:
    with pytest.raises(RecipeError, match="frame"):
        parse_recipe(propose(log).recipe_text(), "proposed")


def test_the_completed_proposal_reads_the_log_value_by_value(log: Path) -> None:
    text = propose(log).recipe_text()
    text = text.replace('# frame = "base"', 'frame = "tool"').replace("# sign = 1 ", "sign = -1 ")
    demonstration = read(log, parse_recipe(text, "completed"))
    np.testing.assert_allclose(demonstration.rate_hz, 250)
    np.testing.assert_allclose(demonstration.position_m[0], [0.4, 0.02, 0.3])
    assert demonstration.gripper is not None
    np.testing.assert_allclose(demonstration.gripper, 0.04)


@pytest.mark.parametrize(
    ("text", "separator", "decimal", "header"),
    [
        ("t,x,y,z\n0,1.5,2,3\n1,1.5,2,3\n", ",", ".", True),
        ("0\t1,5\t2\t3\n1\t1,5\t2\t3\n", "tab", ",", False),
        ("# t x y z\n0 1.5 2 3\n1 1.5 2 3\n", "whitespace", ".", True),
        ("a|b\n1.5|2\n2.5|3\n", "|", ".", True),
    ],
)
def test_layouts_are_told_apart(text: str, separator: str, decimal: str, header: bool) -> None:
    layout = layout_of(text.encode())
    assert (layout.separator, layout.form.decimal, layout.form.header) == (
        separator,
        decimal,
        header,
    )


@pytest.mark.parametrize("data", [b"", b"hello world\nno numbers\n", b"\0\1\2\0"])
def test_what_is_no_table_is_refused(data: bytes) -> None:
    with pytest.raises(DemonstrationError, match="expected a t"):
        layout_of(data)


@pytest.mark.slow
@pytest.mark.parametrize(
    "name",
    ["iiwa_tagged.csv", "lund_two_hand_assembly_trial_2.csv", "dfki_subject1_run1.tsv"],
)
def test_time_and_place_of_real_logs_are_found(real_data: Path, name: str) -> None:
    roles = {guess.role for guess in propose(real_data / "raw" / name).guesses}
    assert {"time", "position"} <= roles


@pytest.mark.parametrize(("turn", "parts"), [((1, 0, 0, 0), "wxyz"), ((0, 0, 0, 1), "xyzw")])
def test_without_names_the_order_that_a_tool_at_rest_has_is_shown_first_and_stays_open(
    tmp_path: Path, turn: tuple[float, ...], parts: str
) -> None:
    path = tmp_path / "trajectory.dat"
    rows = [(0.4 + np.sin(i / 30), 0.01, 0.3 - 0.002 * i, *turn) for i in range(200)]
    path.write_text("\n".join(" ".join(f"{cell:.6f}" for cell in row) for row in rows) + "\n")
    proposal = propose(path)
    found = {guess.role: guess for guess in proposal.guesses}
    assert found["position"].columns == (0, 1, 2)
    assert found["quaternion"].columns == (3, 4, 5, 6)
    assert found["quaternion"].likely == parts
    assert "orientation.order" in proposal.open


@pytest.mark.parametrize("columns", [3, 4])
def test_a_matrix_that_never_turns_is_no_quaternion(tmp_path: Path, columns: int) -> None:
    path = tmp_path / "matrix.dat"
    still = np.eye(4)[:columns, :columns].ravel().tolist()
    rows = [(0.4 + np.sin(i / 30), 0.01, 0.3, *still) for i in range(200)]
    path.write_text("\n".join(" ".join(f"{cell:.6f}" for cell in row) for row in rows) + "\n")
    assert "quaternion" not in {guess.role for guess in propose(path).guesses}


STILL_TURN = np.tile([0.0, 1.0, 0.0, 0.0], (50, 1)) + 1e-4 * np.sin(np.arange(200)).reshape(50, 4)
PATH = np.array([0.4, 0.0, 0.1]) + np.outer(np.arange(50), [1e-3, 2e-3, -1e-4])


def axes(name: str) -> list[str]:
    return [name.format(axis) for axis in "xyz"]


@pytest.mark.parametrize(
    ("role", "chosen", "columns"),
    [
        # The height and three of a tool that hardly turns have a norm near one, too.
        ("quaternion", "turn", {"path": axes("p{}"), "turn": ["qw", "qx", "qy", "qz"]}),
        ("quaternion", "turn", {"path": axes("pose.{}"), "turn": ["o.w", "o.x", "o.y", "o.z"]}),
        ("position", "path", {"aim": axes("ee_des_{}"), "path": axes("ee_{}")}),
        ("position", "path", {"aim": axes("x_des_{}"), "path": axes("x_act_{}")}),
        ("position", "path", {"aim": axes("object_{}"), "path": axes("gripper_{}")}),
        (
            "force",
            "push",
            {"path": axes("x_{}"), "aim": axes("f_des_{}"), "push": axes("f_act_{}")},
        ),
    ],
)
def test_what_was_measured_of_the_tool_is_proposed(
    tmp_path: Path, role: str, chosen: str, columns: dict[str, list[str]]
) -> None:
    """Beside aims, other things and numbers that only look alike."""
    values = {"path": PATH, "aim": PATH + 0.01, "turn": STILL_TURN, "push": 9.0 * PATH}
    names = ["t", *(name for group in columns.values() for name in group)]
    rows = np.hstack([np.arange(50)[:, None] / 100, *(values[kind] for kind in columns)])
    path = tmp_path / "log.csv"
    np.savetxt(path, rows, "%.6f", ",", header=",".join(names), comments="")

    guess = next(one for one in propose(path).guesses if one.role == role)

    assert [names[column] for column in guess.columns] == columns[chosen]
