"""What the scenes of all pages share: robots, and what is worked out once for each recording."""

import threading
from collections import OrderedDict
from collections.abc import Callable, Sequence

from keyphase.demonstration import Demonstration
from keyphase.labeling.labeling import Labeling
from keyphase.robot.arm import Arm
from keyphase.robot.description import RobotDescription
from keyphase.simulation.workcells.parts_path import PartsPath, parts_path
from keyphase.web.scene.recording.ground_shadow import GroundShadow, shadow_of
from keyphase.workbench.placing.joint_paths import JointPaths
from keyphase.workbench.recordings import Recording
from keyphase.workbench.telling import in_words
from keyphase.workbench.worker import Worker

KEPT = 8
"""So many recordings' parts are remembered."""

STEP_S = 0.012
"""Posing one page's scene may take so much of a core, with room for everything else."""


class Shared:
    """`arms` are descriptions of the same robot with different tools.

    finished_beside     the finished recordings of a recording's folder
    joints, part_paths  threads that work out joints and parts, one recording after another; each
                        page has at most one wish waiting in either
    """

    def __init__(
        self,
        arms: Sequence[RobotDescription],
        finished_beside: Callable[[Recording], list[Labeling]],
    ) -> None:
        self.finished_beside = finished_beside
        self.arms = tuple(Arm(robot) for robot in arms)
        self.paths = JointPaths()
        self.shadow: GroundShadow | None = shadow_of(arms[0])
        self.joints, self.part_paths = Worker(in_words), Worker(in_words)
        self.pages = 0
        self._parts = _Parts()

    @property
    def pace_s(self) -> float:
        """Least time between two poses of a page whose playhead runs; more with more pages."""
        return STEP_S * self.pages

    def parts(self, demonstration: Demonstration) -> PartsPath | None:
        """Where the parts were; None where it was not recorded in a workcell of ours."""
        return self._parts.of(demonstration)

    def wait_until_idle(self, timeout_s: float) -> bool:
        """Whether everything there was to work out is worked out within `timeout_s`."""
        return all(w.wait_until_idle(timeout_s) for w in (self.joints, self.part_paths))

    def close(self) -> None:
        """Work out no more."""
        for worker in (self.joints, self.part_paths):
            worker.stop()
            worker.join()


class _Parts:
    def __init__(self) -> None:
        self._lock = threading.Lock()
        self._known: OrderedDict[int, tuple[Demonstration, PartsPath | None]] = OrderedDict()

    def of(self, demonstration: Demonstration) -> PartsPath | None:
        with self._lock:
            known = self._known.get(id(demonstration))
        if known is None:
            known = demonstration, parts_path(demonstration)
        with self._lock:
            self._known[id(demonstration)] = known
            while len(self._known) > KEPT:
                self._known.popitem(last=False)
        return known[1]
