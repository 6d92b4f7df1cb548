"""Which files in a folder are recordings, and which recipe reads them."""

import os
import shutil
from collections.abc import Callable, Iterator
from pathlib import Path

import numpy as np
import pytest

from keyphase.errors import DemonstrationError
from keyphase.readers import find_recordings, read
from keyphase.writers import WRITERS

NATIVE = "time_s,position_x_m,position_y_m,position_z_m\n0,1,2,3\n1,1,2,3\n"
FOREIGN = "t;x;y;z\n0;1;2;3\n1;1;2;3\n"
RECIPE = """
[table]
separator = ";"
[time]
column = "t"
unit = "s"
[position]
columns = ["x", "y", "z"]
unit = "UNIT"
"""


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    """Recordings of every kind among files that are none."""
    files = {
        "b.csv": NATIVE,
        "sub/a.csv": FOREIGN,
        "sub/a.csv.recipe.toml": RECIPE.replace("UNIT", "m"),
        "batch/recipe.toml": RECIPE.replace("UNIT", "mm"),
        "batch/one.txt": FOREIGN,
        "batch/two.dat": FOREIGN,
        "batch/one.segments.csv": "id,start_s\n1,0\n",
        "batch/one.segments.json": "{}",
        "batch/native.csv": NATIVE,
        "notes.txt": "a note",
        "foreign.csv": FOREIGN,
        ".hidden/c.csv": NATIVE,
        ".hidden.csv": NATIVE,
    }
    for name, text in files.items():
        (tmp_path / name).parent.mkdir(exist_ok=True)
        (tmp_path / name).write_text(text)
    np.savez(tmp_path / "archive.npz", time_s=[0, 1], position_m=np.zeros((2, 3)))
    return tmp_path


def names(found: tuple[tuple[Path, Path], ...]) -> list[str]:
    return [relative.as_posix() for _, relative in found]


def test_what_keyphase_writes_beside_a_recording_is_none_of_its_own(folder: Path) -> None:
    before = names(find_recordings([folder]))
    for writer in WRITERS:
        if writer.ending:
            for name in ("one", "one_2"):
                shutil.copy(
                    folder / "batch" / "one.txt", folder / "batch" / f"{name}{writer.ending}"
                )
    assert names(find_recordings([folder])) == before


def test_a_folder_gives_its_recordings_sorted_by_their_names_in_it(folder: Path) -> None:
    assert names(find_recordings([folder])) == [
        "archive.npz",
        "b.csv",
        "batch/native.csv",
        "batch/one.txt",
        "batch/two.dat",
        "sub/a.csv",
    ]


def test_everything_found_can_be_read(folder: Path) -> None:
    for path, _ in find_recordings([folder]):
        assert len(read(path)) == 2


def test_a_recipe_for_all_makes_every_table_a_recording(folder: Path) -> None:
    found = names(find_recordings([folder], recipe=folder / "batch" / "recipe.toml"))
    assert {"foreign.csv", "notes.txt"} <= set(found)


def test_a_file_is_taken_as_named(folder: Path) -> None:
    ((path, relative),) = find_recordings([folder / "foreign.csv"])
    assert path == folder / "foreign.csv"
    assert relative == Path("foreign.csv")


def test_a_recording_named_twice_is_found_once(folder: Path) -> None:
    assert len(find_recordings([folder / "b.csv", folder])) == 6


def test_a_folder_that_cannot_be_listed_is_refused(
    folder: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    def walk(top: Path, onerror: Callable[[OSError], None]) -> Iterator[None]:
        onerror(PermissionError(13, "Permission denied", str(top)))
        yield from ()

    monkeypatch.setattr("os.walk", walk)
    with pytest.raises(DemonstrationError, match=r"the folder cannot be listed \(Permission"):
        find_recordings([folder])


def test_a_folder_inside_that_cannot_be_listed_is_refused_by_itself(
    folder: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    before = len(find_recordings([folder]))
    listed = os.scandir

    def scandir(path: str) -> object:
        if Path(path) == folder / "sub":
            raise PermissionError(13, "Permission denied", str(path))
        return listed(path)

    monkeypatch.setattr("os.scandir", scandir)
    found = [one.relative for one in find_recordings([folder])]
    assert Path("sub") in found
    assert 1 < len(found) <= before


def test_the_recipe_of_a_file_wins_over_that_of_its_folder(folder: Path) -> None:
    own = folder / "batch" / "one.txt.recipe.toml"
    own.write_text(RECIPE.replace("UNIT", "cm"))
    assert read(folder / "batch" / "one.txt").position_m[0, 0] == pytest.approx(0.01)
    assert read(folder / "batch" / "two.dat").position_m[0, 0] == pytest.approx(0.001)


def test_a_recipe_given_wins_over_all(folder: Path) -> None:
    metres, millimetres = folder / "sub" / "a.csv.recipe.toml", folder / "batch" / "recipe.toml"
    assert read(folder / "batch" / "two.dat", metres).position_m[0, 0] == 1.0
    assert read(folder / "sub" / "a.csv", millimetres).position_m[0, 0] == 0.001


def test_a_native_table_needs_no_recipe_of_its_folder(folder: Path) -> None:
    assert read(folder / "batch" / "native.csv").position_m[0, 0] == 1.0


def test_an_archive_is_read_whatever_recipe_is_given(folder: Path) -> None:
    assert len(read(folder / "archive.npz", folder / "batch" / "recipe.toml")) == 2


def test_the_notices_say_which_recipe_was_used(folder: Path) -> None:
    (notice,) = read(folder / "batch" / "one.txt").notices
    assert notice == f"Read with the recipe {folder / 'batch' / 'recipe.toml'}."


def test_a_table_without_recipe_is_refused_with_the_way_to_write_one(folder: Path) -> None:
    with pytest.raises(
        DemonstrationError, match=r"keyphase inspect --write .*foreign\.csv`"
    ) as refused:
        read(folder / "foreign.csv")
    assert "recipe foreign.csv.recipe.toml beside it" in str(refused.value)


def test_wrenches_beside_and_notes_are_no_recordings_of_a_folders_recipe(folder: Path) -> None:
    batch = folder / "batch"
    beside = '[wrench_file]\npath = "{stem}_ft.log"\ncolumn = "t"\nunit = "s"\n'
    force = '[force]\ncolumns = ["x", "y", "z"]\nunit = "N"\n[wrench]\nframe = "base"\nsign = 1\n'
    (batch / "recipe.toml").write_text((batch / "recipe.toml").read_text() + force + beside)
    for name in ("one_ft.log", "two_ft.log"):
        (batch / name).write_text(FOREIGN.replace(";", ","))
    (batch / "notes.txt").write_text("Monday, 3 runs\nthe second 1.5 mm too deep\n")
    found = names(find_recordings([batch]))
    assert found == ["native.csv", "one.txt", "two.dat"]
