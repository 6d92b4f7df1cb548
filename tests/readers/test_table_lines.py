"""Lines of a table that are no rows, and files that stand for none."""

from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest

from keyphase.errors import DemonstrationError
from keyphase.readers import parse_recipe, read

HEADER = "t,x,y,z"
ROWS = [f"{i / 50:.2f},{i},0,0" for i in range(40)]
RECIPE = parse_recipe(
    """time = {column = "t", unit = "s"}
position = {columns = ["x", "y", "z"], unit = "mm"}
rows = {empty = "leave_out"}""",
    "plain",
)


def text(*lines: str) -> bytes:
    return ("\n".join(lines) + "\n").encode()


@pytest.mark.parametrize(
    ("data", "told"),
    [
        (text(HEADER, *ROWS) + b"\0" * 512, "ends in 512 zero bytes, as after a loss of power"),
        (text(HEADER, *ROWS, "# closed, 40 rows"), "Line 42, '# closed, 40 rows', is a remark"),
        (text(HEADER, *ROWS[:9], "% paused", *ROWS[9:]), "Line 11, '% paused', is a remark"),
        (text(HEADER, *ROWS[:9], HEADER, *ROWS[9:]), "The header stands again in line 11"),
    ],
)
def test_what_is_no_row_is_left_out_and_told(tmp_path: Path, data: bytes, told: str) -> None:
    (tmp_path / "run.csv").write_bytes(data)
    found = read(tmp_path / "run.csv", RECIPE)
    np.testing.assert_allclose(found.position_m[:, 0], np.arange(40) / 1000)
    assert any(told in notice for notice in found.notices)


@pytest.mark.parametrize("every", [1, 3])
def test_rows_that_begin_with_a_sign_are_no_remarks(tmp_path: Path, every: int) -> None:
    rows = [f"{'#' if i % every == 0 else ''}{i},{row}" for i, row in enumerate(ROWS)]
    (tmp_path / "run.csv").write_bytes(text(f"number,{HEADER}", *rows))
    assert len(read(tmp_path / "run.csv", RECIPE)) == 40


@pytest.mark.parametrize("nothing", ["#N/A", "-", "1.#QNAN", "<NA>"])
def test_what_other_programs_write_for_nothing_is_nothing(tmp_path: Path, nothing: str) -> None:
    rows = [*ROWS[:9], f"0.18,{nothing},0,0", *ROWS[10:]]
    (tmp_path / "run.csv").write_bytes(text(HEADER, *rows))
    assert len(read(tmp_path / "run.csv", RECIPE)) == 39


@pytest.mark.parametrize(
    ("data", "told"),
    [
        (lambda: text(HEADER, *ROWS[:9]) + bytes(64) + text("", *ROWS[9:]), "line 11 holds zero"),
        (lambda: text("version https://git-lfs.github.com/spec/v1", "oid x"), "git lfs pull"),
        (lambda: text("", "<!DOCTYPE html>", "<p>404: Not Found</p>"), "it is a web page"),
    ],
)
def test_a_table_with_a_hole_and_what_stands_for_a_file_are_named(
    tmp_path: Path, data: Callable[[], bytes], told: str
) -> None:
    (tmp_path / "run.csv").write_bytes(data())
    with pytest.raises(DemonstrationError, match=told):
        read(tmp_path / "run.csv")
