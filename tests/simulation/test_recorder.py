"""A take survives whatever happens to its recorder."""

import signal
import subprocess
import sys
from collections.abc import Sequence

import numpy as np
import pytest

from keyphase.errors import SimulationError
from keyphase.readers import read
from keyphase.simulation import RATE_HZ, Sample
from keyphase.simulation.demonstrating.recorder import (
    MAX_UNWRITTEN_S,
    Recorder,
    read_take,
    recover,
    take_of,
)

ORIGIN = {"workcell": "setup1", "contact_names": ["touch", "wall"], "contact_changes": ["wall"]}
CHUNK = round(MAX_UNWRITTEN_S * RATE_HZ)


def sample(tick: int) -> Sample:
    return Sample(
        time_s=10.0 + tick / RATE_HZ,
        position_m=np.array([0.4, -0.2, 0.2 - 1e-4 * tick]),
        orientation_wxyz=np.array([1.0, 0.0, 0.0, 0.0]),
        joints_rad=np.arange(7.0) + tick,
        force_N=np.array([0.0, 0.0, float(tick)]),
        torque_Nm=np.zeros(3),
        contact_N=np.array([0.0, 5.0 if tick >= 100 else 0.0]),
    )


def recorder_with(samples: int, path, unwritten_s: float = MAX_UNWRITTEN_S) -> Recorder:
    recorder = Recorder(path, ORIGIN, unwritten_s)
    for tick in range(samples):
        recorder.append(sample(tick))
    return recorder


def ticks_of(samples: Sequence[Sample]) -> list[int]:
    return [round(s.force_N[2]) for s in samples]


def test_a_finished_recording_holds_every_sample_and_leaves_no_take(tmp_path) -> None:
    path = tmp_path / "first.npz"
    recorder_with(137, path).finish()
    demonstration = read(path)
    assert len(demonstration) == 137
    assert demonstration.start_s == 0.0
    assert demonstration.rate_hz == pytest.approx(RATE_HZ)
    assert demonstration.metadata["ground_truth"]["contact_changes_s"] == [0.4]
    assert [p.name for p in tmp_path.iterdir()] == ["first.npz"]


def test_all_but_the_last_half_second_is_on_the_disk_at_any_moment(tmp_path) -> None:
    path = tmp_path / "first.npz"
    recorder = Recorder(path, ORIGIN)
    for tick in range(3 * CHUNK + 7):
        recorder.append(sample(tick))
        written, _ = read_take(take_of(path))
        assert tick + 1 - len(written) < CHUNK


def test_a_take_cut_anywhere_in_its_last_chunk_keeps_the_chunks_before(tmp_path) -> None:
    path, chunk = tmp_path / "first.npz", 5
    recorder_with(2 * chunk, path, unwritten_s=chunk / RATE_HZ)
    whole = take_of(path).read_bytes()
    recorder_with(3 * chunk, tmp_path / "longer.npz", unwritten_s=chunk / RATE_HZ)
    longer = take_of(tmp_path / "longer.npz").read_bytes()
    assert longer.startswith(whole)
    torn = tmp_path / "torn.npz.take"
    for length in range(len(whole), len(longer)):
        torn.write_bytes(longer[:length])
        samples, origin = read_take(torn)
        assert origin == ORIGIN
        assert ticks_of(samples) == list(range(2 * chunk))
    assert samples[5].joints_rad == pytest.approx(sample(5).joints_rad)


def test_a_chunk_with_a_flipped_bit_is_not_believed(tmp_path) -> None:
    path = tmp_path / "first.npz"
    recorder_with(2 * CHUNK, path)
    data = bytearray(take_of(path).read_bytes())
    data[-100] ^= 1
    take_of(path).write_bytes(data)
    assert len(read_take(take_of(path))[0]) == CHUNK


def test_a_take_cut_in_its_first_line_is_empty(tmp_path) -> None:
    take = tmp_path / "first.npz.take"
    take.write_bytes(b'{"format": "keyph')
    assert read_take(take) == ([], {})
    assert recover(tmp_path) == ()
    assert not take.exists()


def test_what_is_no_take_is_refused_and_left_alone(tmp_path) -> None:
    take = tmp_path / "letter.npz.take"
    take.write_text('{"dear": "reader"}\n')
    with pytest.raises(SimulationError, match="must begin as a take"):
        recover(tmp_path)
    assert take.exists()


def test_recovering_makes_recordings_of_what_was_left(tmp_path) -> None:
    path = tmp_path / "first.npz"
    recorder_with(2 * CHUNK + 30, path)
    recovered = recover(tmp_path)
    assert [entry.path for entry in recovered] == [path]
    demonstration = read(path)
    assert len(demonstration) == 2 * CHUNK
    assert demonstration.metadata["recovered"] is True
    assert not take_of(path).exists()


def test_a_take_whose_recording_is_whole_already_is_dropped(tmp_path) -> None:
    path = tmp_path / "first.npz"
    recorder = recorder_with(CHUNK, path)
    left = take_of(path).read_bytes()
    recorder.finish()
    take_of(path).write_bytes(left)
    before = path.read_bytes()
    assert recover(tmp_path) == ()
    assert path.read_bytes() == before
    assert not take_of(path).exists()


def test_a_recording_is_never_overwritten(tmp_path) -> None:
    path = tmp_path / "first.npz"
    recorder_with(10, path).finish()
    with pytest.raises(SimulationError, match="exists; choose a new name"):
        Recorder(path, ORIGIN)


def test_a_running_take_is_never_overwritten(tmp_path) -> None:
    path = tmp_path / "first.npz"
    recorder_with(10, path)
    with pytest.raises(SimulationError, match="recover or remove it"):
        Recorder(path, ORIGIN)


def test_a_discarded_take_leaves_nothing(tmp_path) -> None:
    recorder_with(300, tmp_path / "first.npz").discard()
    assert not list(tmp_path.iterdir())


def test_a_single_sample_is_no_recording(tmp_path) -> None:
    with pytest.raises(SimulationError, match=r"at least two samples, but first\.npz has 1"):
        recorder_with(1, tmp_path / "first.npz").finish()


def test_a_folder_that_takes_no_files_is_told(tmp_path) -> None:
    with pytest.raises(SimulationError, match="must be writable"):
        Recorder(tmp_path / "missing" / "first.npz", ORIGIN)


_CHILD = """
import sys
from pathlib import Path
from keyphase.simulation import RATE_HZ, workcell
from keyphase.simulation.demonstrating.lead_through import LeadThrough

session = LeadThrough(workcell("setup1"))
session.start_recording(Path(sys.argv[1]))
for tick in range(1, 100000):
    session.advance()
    print(tick, flush=True)
"""


@pytest.mark.skipif(sys.platform == "win32", reason="needs SIGKILL")
@pytest.mark.parametrize("ticks", [300, 517])
def test_a_killed_process_loses_at_most_the_last_second(ticks, tmp_path) -> None:
    path = tmp_path / "killed.npz"
    child = subprocess.Popen(
        [sys.executable, "-c", _CHILD, str(path)], stdout=subprocess.PIPE, text=True
    )
    assert child.stdout is not None
    for line in child.stdout:
        if int(line) >= ticks:
            break
    child.send_signal(signal.SIGKILL)
    recorded = max((int(line) for line in child.stdout if line.endswith("\n")), default=ticks)
    child.wait()
    (entry,) = recover(tmp_path)
    assert recorded / RATE_HZ - entry.duration_s <= 1.0
    assert len(read(path)) >= ticks - RATE_HZ
