"""What is odd about a recording is told when it is read, segmented and inspected."""

import json
from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest

from keyphase.batch.report import refusal_lines, report_lines
from keyphase.batch.segmenting import segment_all
from keyphase.batch.tasks import Refusal
from keyphase.commands.inspect import ODD, Inspect
from keyphase.demonstration import Demonstration
from keyphase.oddities import breaks_of
from keyphase.readers import read, save_npz
from odd_recordings import KINDS, NOISE, T, save_odd_recordings


@pytest.fixture(scope="module")
def folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    folder = tmp_path_factory.mktemp("odd")
    save_odd_recordings(folder)
    return folder


@pytest.fixture(scope="module")
def written(folder: Path, tmp_path_factory: pytest.TempPathFactory) -> Callable[[str], list[str]]:
    """What the command prints of a recording, and what its segment file says."""
    output = tmp_path_factory.mktemp("out")
    report = segment_all([folder], output, jobs=1)
    printed = "\n".join(report_lines(report))

    def of(name: str) -> list[str]:
        file = json.loads((output / f"{name}.segments.json").read_text())
        own = printed.partition(f"{name}.npz:")[2].partition(".npz:")[0]
        return [own, "\n".join(file["demonstration"]["notices"])]

    return of


@pytest.mark.parametrize("name", KINDS)
def test_an_oddity_is_printed_and_stands_in_the_segment_file(
    written: Callable[[str], list[str]], name: str
) -> None:
    for told in written(name):
        assert KINDS[name][1] in told


@pytest.mark.parametrize("name", KINDS)
def test_an_odd_recording_is_not_sound_to_the_inspection(
    folder: Path, capsys: pytest.CaptureFixture[str], name: str
) -> None:
    assert Inspect(paths=(folder / f"{name}.npz",)).run() == ODD
    odd = [line for line in capsys.readouterr().out.splitlines() if line.startswith("  odd: ")]
    assert any(KINDS[name][1] in line for line in odd)


@pytest.mark.parametrize(("name", "span"), [("gap", (4.0, 5.52)), ("jump", (5.98, 6.02))])
def test_a_gap_and_a_jump_are_breaks_with_their_span(
    folder: Path, name: str, span: tuple[float, float]
) -> None:
    (found,) = breaks_of(read(folder / f"{name}.npz"))
    assert found.span_s == pytest.approx(span)


def test_no_idle_segment_lies_over_a_gap_in_which_the_tool_moved(
    tmp_path: Path,
) -> None:
    still = np.where(T < 6, 0.0, 0.2)
    place = np.column_stack([0.4 + still, 0.0 * T, 0.3 + 0.0 * T]) + 1e-5 * NOISE
    save_npz(Demonstration("lost", T + 1.5 * (T >= 6), place), tmp_path / "lost.npz")
    segment_all([tmp_path / "lost.npz"], tmp_path, jobs=1)
    file = json.loads((tmp_path / "lost.segments.json").read_text())
    over = [s for s in file["segments"] if s["start_s"] < 7.0 and s["end_s"] > 6.5]
    assert [s["label"].startswith("idle") for s in over] == [False] * len(over)
    assert over


def test_recordings_of_one_file_refused_for_one_reason_are_told_in_one_line() -> None:
    parts = [Path(f"in/data.hdf5#demo_{k}") for k in range(3)]
    refused = [Refusal(part, f"{part}: no preset fits.") for part in parts]
    refused += [Refusal(Path("in/run.csv"), "in/run.csv: it is empty.")]
    assert list(refusal_lines(refused)) == [
        "in/data.hdf5#demo_0: no preset fits. (2 more of data.hdf5 likewise)",
        "in/run.csv: it is empty.",
    ]
