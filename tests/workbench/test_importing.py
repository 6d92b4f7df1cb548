"""A table nobody has described: proposed, corrected by a person, tried, and read by a recipe."""

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from keyphase.errors import RequestError
from keyphase.readers import read
from keyphase.workbench.importing.importing import Importing
from keyphase.workbench.uploads import Upload


def german_log(samples: int = 400) -> bytes:
    """cp1252, a comment, semicolons, decimal commas, ms since boot, mm, x y z w, tool's wrench."""
    time_ms = 1_234_567 + 4 * np.arange(samples)
    pressed = np.arange(samples) >= samples // 2
    rows = [
        "# Prüfstand, Lauf 3",
        "zeit_ms;Pos X (mm);Pos Y (mm);Pos Z (mm);qx;qy;qz;qw;Fx [N];Fy [N];Fz [N];Bemerkung",
    ]
    for i in range(samples):
        cells = (
            400 + 0.1 * i, 10.5, 140.0 if pressed[i] else 200 - 0.2 * i, 0, 0, 0, 1,
            0.1 * (i % 3), 0.1 * (i % 2), -5.0 if pressed[i] else 0.0,
        )  # fmt: skip
        numbers = [f"{cell:.4f}".replace(".", ",") for cell in cells]
        rows.append(";".join([str(time_ms[i]), *numbers, "drückt" if pressed[i] else "frei"]))
    return ("\r\n".join(rows) + "\r\n").encode("cp1252")


@pytest.fixture
def log(tmp_path: Path) -> Path:
    path = tmp_path / "lauf_3.csv"
    path.write_bytes(german_log())
    return path


def test_only_what_numbers_cannot_tell_is_left_to_a_person(log):
    waiting = Importing().ask_about(log)

    tried = waiting.table.tried(waiting.table.proposed)

    assert not tried.looks
    assert tried.missing == (
        "Say in whose axes the wrench is written.",
        "Say which way the force points when the tool presses.",
    )


def test_each_proposed_column_has_its_evidence(log):
    table = Importing().ask_about(log).table

    by_part = dict(zip(table.proposed.parts, table.evidence, strict=True))

    assert "250 Hz" in by_part["time"]
    assert "named so" in by_part["x"]
    assert "1.000" in by_part["qw"]
    assert by_part["ignore"] == ""
    assert "0xfc" in table.layout_evidence["encoding"]


def test_confirmed_answers_become_a_recipe_beside_the_file(log):
    importing = Importing()
    waiting = importing.ask_about(log)
    before = log.read_bytes()
    answers = replace(waiting.table.proposed, frame="tool", sign=-1)

    (look,) = importing.tried(waiting.id, answers).looks
    paths = importing.confirm(waiting.id, answers, "file")

    demonstration = read(paths[0])
    assert paths == (log,)
    assert log.read_bytes() == before
    assert demonstration.rate_hz == pytest.approx(250)
    np.testing.assert_allclose(demonstration.position_m[0], [0.4, 0.0105, 0.2])
    assert demonstration.force_N is not None
    np.testing.assert_allclose(demonstration.force_N[-1, 2], 5.0)
    assert look.samples == len(demonstration)
    assert look.force_N is not None
    assert look.force_N[1].max() == pytest.approx(5.0, abs=0.01)


def test_other_answers_give_another_recording(log):
    importing = Importing()
    waiting = importing.ask_about(log)
    parts = list(waiting.table.proposed.parts)
    parts[1], parts[2] = parts[2], parts[1]
    answers = replace(waiting.table.proposed, parts=tuple(parts), frame="tool", sign=1)

    importing.confirm(waiting.id, answers, "file")

    demonstration = read(log)
    np.testing.assert_allclose(demonstration.position_m[0], [0.0105, 0.4, 0.2])
    assert demonstration.force_N is not None
    assert demonstration.force_N[-1, 2] < 0


def test_one_recipe_serves_all_tables_of_the_folder(log):
    for number in (4, 5):
        log.with_name(f"lauf_{number}.csv").write_bytes(german_log(500))
    log.with_name("requirements.txt").write_text("numpy==2.1\nscipy==1.14\n")
    log.with_name("weather.csv").write_text("day,rain,sun\n1,0.5,3\n2,0.1,7\n3,0.0,9\n")
    importing = Importing()
    waiting = importing.ask_about(log)
    answers = replace(waiting.table.proposed, frame="tool", sign=-1)

    paths = importing.confirm(waiting.id, answers, "folder")

    assert waiting.others == 2
    assert [path.name for path in paths] == ["lauf_3.csv", "lauf_4.csv", "lauf_5.csv"]
    assert {len(read(path)) for path in paths} == {400, 500}


def test_files_that_were_sent_together_are_taken_in_together(tmp_path):
    importing = Importing()
    waiting = [importing.ask_about_upload(sent(tmp_path, f"lauf_{n}.csv")) for n in (1, 2)]
    answers = replace(waiting[0].table.proposed, frame="base", sign=1)

    paths = importing.confirm(waiting[0].id, answers, "folder")

    assert [path.name for path in paths] == ["lauf_1.csv", "lauf_2.csv"]
    with pytest.raises(RequestError, match="not waiting any more"):
        importing.find(waiting[1].id)


def test_nothing_is_left_of_a_sent_file_that_is_not_wanted(tmp_path):
    importing = Importing()
    waiting = importing.ask_about_upload(sent(tmp_path, "lauf.csv"))

    importing.leave(waiting.id)

    assert list(tmp_path.iterdir()) == []


def test_a_recipe_that_is_there_is_never_replaced(log):
    own = log.with_name(log.name + ".recipe.toml")
    importing = Importing()
    waiting = importing.ask_about(log)
    own.write_text("# mine")

    with pytest.raises(RequestError, match="never replaced"):
        importing.confirm(waiting.id, replace(waiting.table.proposed, frame="base", sign=1), "file")

    assert own.read_text() == "# mine"


def test_what_is_still_open_is_refused(log):
    importing = Importing()
    waiting = importing.ask_about(log)

    with pytest.raises(RequestError, match="in whose axes"):
        importing.confirm(waiting.id, waiting.table.proposed, "file")

    assert [path.name for path in log.parent.iterdir()] == [log.name]


def test_another_separator_splits_the_table_anew(log):
    table = Importing().ask_about(log).table

    tried = table.tried(replace(table.proposed, separator="tab", decimal="."))

    assert not tried.looks
    assert tried.missing


def sent(folder: Path, name: str) -> Upload:
    data = german_log()
    upload = Upload(folder, name, len(data))
    upload.write(data)
    upload.settle()
    return upload


def test_a_layout_no_recipe_can_name_is_told_and_not_tried(log):
    table = Importing().ask_about(log).table

    tried = table.tried(replace(table.proposed, encoding="unicode_escape"))

    assert "among those that recipes name" in tried.missing[0]
