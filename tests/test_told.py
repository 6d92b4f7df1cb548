"""What is odd about a recording is told when it is read, segmented and inspected."""

import json
from collections.abc import Callable, Mapping
from pathlib import Path

import numpy as np
import pytest

from keyphase.batch.report import report_lines
from keyphase.batch.segmenting import segment_all
from keyphase.commands.inspect import ODD, Inspect
from keyphase.demonstration import Demonstration
from keyphase.oddities import breaks_of
from keyphase.readers import read, save_npz

ROWS = 600
T = np.arange(ROWS) / 50.0
WAY = 0.1 * (1 - np.cos(2 * np.pi * T / 6.0))
PLACE = np.column_stack([0.4 + WAY, 0.0 * T, 0.3 + 0.0 * T])
NOISE = np.random.default_rng(0).normal(0, 0.05, (ROWS, 3))
SPEED = np.gradient(WAY, T)
STILL = np.tile([0.4, 0.1, 0.3], (ROWS, 1))
TURNING = np.linspace(0, 1, ROWS)[:, None]


def at(row: int, values: np.ndarray, value: object) -> np.ndarray:
    """The values with another one in a row."""
    changed = values.copy()
    changed[row] = value
    return changed


def pushed(strength: float) -> np.ndarray:
    """A force along the speed, which helps, or against it."""
    return NOISE + strength * np.column_stack([SPEED, 0 * T, 0 * T]) / np.abs(SPEED).max()


KINDS: Mapping[str, tuple[dict[str, np.ndarray], str]] = {
    "milliseconds": ({"time_s": 1000 * T}, "were milliseconds read as seconds?"),
    "gap": ({"time_s": T + 1.5 * (T > 4)}, "1.52 s without data at 4.00 s"),
    "jump": ({"position_m": at(300, PLACE, [0.9, 0.5, 0.3])}, "The tool jumps"),
    "zero": ({"position_m": at(300, PLACE, 0.0)}, "1 row has the place 0 0 0"),
    "constant": ({"force_N": NOISE * [1, 1, 0]}, "force_N z never changes"),
    "saturated": ({"force_N": np.clip(pushed(-30.0), -8, 8)}, "may have been at its limit"),
    "still": (
        {"position_m": STILL, "joints_rad": TURNING},
        "position_m never changes while joints",
    ),
    "wander": (
        {"position_m": STILL + 1e-5 * NOISE, "force_N": NOISE + 2 * np.sin(T)[:, None]},
        "the force wanders by",
    ),
    "sign": ({"force_N": pushed(10.0)}, "helps the motion"),
}


@pytest.fixture(scope="module")
def folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A recording for each oddity, named after it."""
    folder = tmp_path_factory.mktemp("odd")
    for name, (channels, _) in KINDS.items():
        given = {"time_s": T, "position_m": PLACE, **channels}
        save_npz(Demonstration(name, **given), folder / f"{name}.npz")
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
