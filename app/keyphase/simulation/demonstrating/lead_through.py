"""Lead-through: a person drags the tool by a target, the workcell answers in real time."""

import threading
import time
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from pathlib import Path

import numpy as np
from numpy.typing import ArrayLike

from keyphase.demonstration import Array, Demonstration
from keyphase.errors import SimulationError
from keyphase.simulation.demonstrating.follower import Follower
from keyphase.simulation.demonstrating.recorder import Recorder
from keyphase.simulation.disturbance import NOMINAL, Disturbance
from keyphase.simulation.impedance import RATE_HZ, Reference
from keyphase.simulation.samples import provenance
from keyphase.simulation.simulation import Sample
from keyphase.simulation.workcells.workcell import Workcell

Pose = tuple[Array, Array]
"""Position (3,) [m] and orientation (4,), w x y z, in the base frame."""

_MAX_BEHIND_S = 0.1
_STEP_S = 1.0 / RATE_HZ


@dataclass(frozen=True, eq=False)
class LeadThroughState:
    """What a page shows of a running session; poses in the base frame.

    sample          the newest sample: tool pose, joint angles, wrench
    parts, links    poses by name
    recorded_s      how much of the present take is recorded, None where none is
    """

    sample: Sample
    parts: Mapping[str, Pose]
    links: Mapping[str, Pose]
    recorded_s: float | None


class LeadThrough:
    """One workcell led by hand. All methods may be called from any thread.

    `run` steps in real time until `close`; `advance` makes a single step, for whoever keeps time
    otherwise.
    """

    def __init__(self, cell: Workcell, disturbance: Disturbance = NOMINAL, seed: int = 0) -> None:
        self._lock = threading.Lock()
        self._stop = threading.Event()
        self._thread: threading.Thread | None = None
        self._simulation = cell.build(disturbance, seed)
        self.shapes = self._simulation.shapes()
        """What the parts look like."""
        self._follower = Follower(self._simulation.here())
        self._target = self._simulation.here()
        self._recorder: Recorder | None = None
        self._sample = self._simulation.step(self._target)
        self.failure: Exception | None = None
        """What stopped `run`, if anything did."""

    def set_target(self, position_m: ArrayLike, orientation_wxyz: ArrayLike) -> None:
        """Where the tool is wanted from now on.

        Raises SimulationError for a pose that is none.
        """
        position = np.array(position_m, dtype=np.float64)
        wxyz = np.array(orientation_wxyz, dtype=np.float64)
        norm = float(np.linalg.norm(wxyz)) if wxyz.shape == (4,) else 0.0
        finite = position.shape == (3,) and np.isfinite(position).all() and np.isfinite(norm)
        if not finite or norm < 1e-6:
            raise SimulationError(
                f"A target must be a position x y z and a quaternion w x y z, but is "
                f"{position.tolist()} and {wxyz.tolist()}; send finite numbers."
            )
        with self._lock:
            self._target = Reference(position, wxyz / norm)

    def let_go(self) -> None:
        """Stay where the tool is now."""
        with self._lock:
            self._target = self._simulation.here()

    def advance(self) -> Sample:
        """One control tick of 4 ms."""
        with self._lock:
            simulation = self._simulation
            reference = self._follower.towards(self._target, simulation.here())
            self._sample = simulation.step(reference)
            if self._recorder is not None:
                self._recorder.append(self._sample)
            return self._sample

    def state(self) -> LeadThroughState:
        """What is to be shown now."""
        with self._lock:
            simulation, recorder = self._simulation, self._recorder
            return LeadThroughState(
                sample=self._sample,
                parts=simulation.part_poses(),
                links=simulation.link_poses(),
                recorded_s=None if recorder is None else recorder.duration_s,
            )

    def start_recording(self, path: Path) -> None:
        """Write every sample from now on into a take of the recording `path`.

        Raises SimulationError while another is recorded, or where `path` exists.
        """
        with self._lock:
            if self._recorder is not None:
                raise SimulationError(
                    f"One take at a time can be recorded, but {self._recorder.path.name} still "
                    "is; stop it first."
                )
            origin = provenance(self._simulation, "by hand")
            self._recorder = Recorder(path, origin)

    def stop_recording(self) -> Demonstration:
        """Finish the take; its recording is whole on the disk on return.

        Raises SimulationError where none is recorded or nothing was.
        """
        recorder = self._taken_recorder()
        return recorder.finish()

    def discard_recording(self) -> None:
        """Drop the present take, if there is one."""
        with self._lock:
            recorder, self._recorder = self._recorder, None
        if recorder is not None:
            recorder.discard()

    def reset(self) -> None:
        """Arm and parts back to their start; a present take is dropped."""
        self.discard_recording()
        with self._lock:
            self._simulation.reset()
            self._target = self._simulation.here()
            self._follower.restart(self._target)

    def start(self) -> None:
        """Run in a thread of its own until `close`."""
        if self._thread is None:
            self._thread = threading.Thread(target=self._run_safely, name="lead-through")
            self._thread.daemon = True
            self._thread.start()

    def run(self, clock: Callable[[], float] = time.monotonic) -> None:
        """Step in real time until `close`; where the machine falls behind, time is let go."""
        due = clock()
        while not self._stop.wait(max(0.0, due - clock())):
            self.advance()
            due = max(due + _STEP_S, clock() - _MAX_BEHIND_S)

    def close(self) -> None:
        """Stop. A take that is still recorded is finished, so that nothing is lost."""
        self._stop.set()
        if self._thread is not None and self._thread is not threading.current_thread():
            self._thread.join()
        with self._lock:
            recorder, self._recorder = self._recorder, None
        if recorder is not None and recorder.duration_s > _STEP_S:
            recorder.finish()
        elif recorder is not None:
            recorder.discard()

    def _taken_recorder(self) -> Recorder:
        with self._lock:
            recorder, self._recorder = self._recorder, None
        if recorder is None:
            raise SimulationError("No take is being recorded; start a recording first.")
        return recorder

    def _run_safely(self) -> None:
        try:
            self.run()
        except Exception as error:
            self.failure = error
