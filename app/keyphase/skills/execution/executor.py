"""Execute a plan of skills on any robot: what it measures in, what it is to follow out.

Nothing here knows a simulator, a robot or a demonstration; all numbers are the skills' own. What
runs in a replay is this, and so is what a robot runs that reads the skill file.
"""

from collections.abc import Sequence
from math import sqrt

import numpy as np

from keyphase.demonstration import Array
from keyphase.errors import SkillError
from keyphase.segmentation.windows import AFTER_S
from keyphase.skills.coupling import Reference
from keyphase.skills.end_monitor import Outcome
from keyphase.skills.execution.pressing import Pressed, pressed_now, pressing, still
from keyphase.skills.execution.result import SkillResult, Stage, went_on
from keyphase.skills.execution.run import UNTURNED, SkillRun, Start
from keyphase.skills.execution.seeking import SEATING_S, Seeking, giving, seeking_of, turned_by
from keyphase.skills.execution.sensed import Sensed
from keyphase.skills.execution.shift import shift_after
from keyphase.skills.execution.squared import Squared
from keyphase.skills.skill import Skill

STEP_S = 0.004
"""How often an executor is stepped, unless it is told otherwise."""

STIFFNESS_N_M = 2000.0
"""Stiffness of the impedance that follows the reference, unless the executor is told otherwise."""

PRESSED_S = (AFTER_S[1], 1.0)
"""A contact that was met is pressed at least this long, and at most that long, until it is still.

The end condition's force step is the demonstrated mean until 0.22 s after the contact; so long the
contact is made, too, before anything follows.
"""

STILL_M_S = 0.002
"""A tool slower than this is still."""

LOADED_WITHIN, LOADED_WITHIN_N = 0.3, 3.0
"""A contact is loaded once its force is the demonstrated one to this part of it, or to 3 N."""

REST_S = 0.5
"""How long the tool rests after the last skill, pressing what it pressed."""

_AT_REST = np.zeros(6)
_ROUNDING_S = 1e-9


class Executor:
    """A plan being executed: `reference` is to be followed until the next `step`.

        executor = Executor(skills, sensed)
        while not executor.over:
            robot.follow(executor.reference)
            executor.step(robot.sense())

    What has ended is in `results`; `stage`, `skill` and `run` say what is being done, `unmet` which
    precondition did not hold.
    """

    def __init__(
        self,
        skills: Sequence[Skill],
        sensed: Sensed,
        *,
        stiffness_N_m: float = STIFFNESS_N_M,
        coupled: bool = True,
        step_s: float = STEP_S,
    ) -> None:
        """Begin a plan with the tool as it is sensed; without `coupled` skills do not wait.

        Raises SkillError for a plan without skills.
        """
        if not skills:
            raise SkillError("A plan must have at least one skill to be executed; keep a segment.")
        self.skills, self.results = tuple(skills), list[SkillResult]()
        self.stage: Stage = "moving"
        self.run: SkillRun | None = None
        self.elapsed_s = 0.0
        self.unmet = ""
        self._stiffness_N_m, self._coupled, self._step_s = stiffness_N_m, coupled, step_s
        self._sensed, self._shift = sensed, np.zeros(3)
        self.in_stage_s = self._skill_start_s = self._peak_N = 0.0
        self._outcome: Outcome | None = None
        self._pressed: Sequence[Pressed] = ()
        self._seeking: Seeking | Squared | None = None
        self._turn = UNTURNED
        self.reference = still(sensed.position_m, sensed.orientation_wxyz)
        self._begin(_AT_REST)
        self.reference = self._next_reference()

    @property
    def over(self) -> bool:
        """Whether there is nothing more to do."""
        return self.stage == "over"

    @property
    def skill(self) -> int | None:
        """Index of the skill that runs; None after the last one."""
        return None if self.run is None else len(self.results)

    def step(self, sensed: Sensed, waits: bool = False) -> Reference:
        """Take in what was sensed at the end of a tick; the reference for the next one.

        A skill's timeout stands still while it `waits`, as for a hand that holds the robot.
        """
        if self.over:
            return self.reference
        self._sensed = sensed
        self.elapsed_s += self._step_s
        self.in_stage_s += self._step_s
        self._peak_N = max(self._peak_N, _length(sensed.force_N))
        if self._seeking is not None:
            self._seeking.watch(sensed, self.stage in ("pressing", "searching"))
        self._go_on(waits)
        if not self.over:
            self.reference = self._next_reference()
        return self.reference

    def stop(self) -> None:
        """End the plan at once."""
        if not self.over:
            if self.run is not None:
                self._note_result(None)
            self.run, self.stage = None, "over"

    def _next_reference(self) -> Reference:
        if self.stage == "moving" and self.run is not None:
            return self.run.reference(self._sensed, self._step_s)
        at = pressing(self._still, self._sensed.position_m, self._pressed, self._stiffness_N_m)
        if self._seeking is None or self.stage not in ("pressing", "searching"):
            return at
        if self.stage == "searching":
            return self._seeking.moving(at, self._sensed, self.in_stage_s)
        return giving(at, self._sensed, self._seeking, self.in_stage_s)

    def _go_on(self, waits: bool) -> None:
        """Enter the next stage where this one is over."""
        time_s = self.in_stage_s + _ROUNDING_S
        if self.stage == "moving":
            assert self.run is not None
            self._outcome = self.run.outcome(self._sensed, self._step_s, waits)
            if self._outcome == "contact":
                self._meet(self.run)
            elif self._outcome is not None:
                self._end_skill(self.run.velocity)
        elif self.stage == "pressing":
            if self._has_settled(time_s):
                self._settled()
        elif self.stage == "searching":
            self._search_on(time_s)
        elif self.stage == "loading":
            if time_s >= PRESSED_S[1] or self._is_loaded():
                self._move(_AT_REST)
                self._refuse_unready()
        elif time_s >= REST_S:
            self.stage = "over"

    def _meet(self, run: SkillRun) -> None:
        """A contact was met: press it as the demonstration did, or move on as it did."""
        skill = run.skill
        if skill.press is None:
            self._end_skill(run.velocity)
            return
        kept = pressed_now(skill, 1.0, self._sensed.force_N)
        firmly = 0.0 if self._seeking is None else self._seeking.search.press_N
        self._pressed = [*kept, (skill.press.direction, max(skill.press.force_N, firmly))]
        self._enter("pressing")

    def _settled(self) -> None:
        """A contact is made: that is all, or the part has to go in, or to be squared, too."""
        if self._seeking is None:
            self._end_skill(_AT_REST)
        elif not self._seeking.is_in(self._sensed):
            self._seeking.again(self._sensed, self._shift)
            self._enter("searching")
        elif self._seeking.presses_on():
            self._enter("pressing")
        else:
            self._end_skill(_AT_REST)

    def _search_on(self, time_s: float) -> None:
        assert self._seeking is not None
        if self._seeking.is_in(self._sensed):
            # Nothing pulls it back from where it was found.
            self.reference = still(self._sensed.position_m, self._sensed.orientation_wxyz)
            self._seeking.searched = True
            self._enter("pressing")
        elif time_s >= self._seeking.search.duration_s:
            self._outcome = "timeout"
            self._end_skill(_AT_REST)

    def _has_settled(self, time_s: float) -> bool:
        if self._seeking is not None:
            return time_s >= SEATING_S
        least_s, most_s = PRESSED_S
        speed = _length(self._sensed.velocity[:3])
        return time_s >= most_s or (time_s >= least_s and speed < STILL_M_S)

    def _is_loaded(self) -> bool:
        """Whether the tool presses about as hard as the demonstration did at this moment."""
        for direction, wanted_N in self._pressed:
            missing = abs(wanted_N + float(self._sensed.force_N.dot(direction)))
            if missing > max(LOADED_WITHIN * wanted_N, LOADED_WITHIN_N):
                return False
        return True

    def _end_skill(self, velocity: Array) -> None:
        """Note how the skill ended; begin the next one with a velocity (6,), or rest."""
        skill = self.skills[len(self.results)]
        if self._outcome == "contact":
            self._shift = shift_after(skill, self._sensed.position_m, self._shift)
            if self._seeking is not None:
                self._turn = turned_by(self._sensed, skill.end_orientation_wxyz)
                if self._seeking.searched:
                    self._shift = self._sensed.position_m - self._seeking.press.position_m
        self._note_result(self._outcome)
        if not went_on(self.results[-1]):
            # What was not expected is not pressed on against.
            self.reference = still(self._sensed.position_m, self._sensed.orientation_wxyz)
            self._rest(())
        elif len(self.results) == len(self.skills):
            pressed = self._pressed if self.stage == "pressing" else ()
            self._rest(pressed or pressed_now(skill, 1.0, self._sensed.force_N))
        else:
            self._begin(velocity)

    def _begin(self, velocity: Array) -> None:
        """Begin the next skill, taking over a velocity (6,); its contacts are loaded first."""
        skill = self.skills[len(self.results)]
        if skill.connecting:
            self._shift, self._turn = np.zeros(3), UNTURNED
        self._seeking = seeking_of(skill, self._sensed, self._step_s)
        self._skill_start_s, self._peak_N = self.elapsed_s, 0.0
        self._pressed = [one for each in skill.kept if (one := each.at(0.0)) is not None]
        self._move(velocity)
        if not self._is_loaded():
            self._enter("loading")
        else:
            self._refuse_unready()

    def _refuse_unready(self) -> None:
        """End a skill at once whose precondition does not hold."""
        needs, sensed = self.skills[len(self.results)].precondition, self._sensed
        self.unmet = needs.unmet(sensed, sensed.force_N, self._shift) if needs else ""
        if self.unmet:
            self._outcome = "not ready"
            self._end_skill(_AT_REST)

    def _move(self, velocity: Array) -> None:
        skill = self.skills[len(self.results)]
        begin = Start(self._sensed, self.reference, velocity, self._shift, self._turn)
        self.run = SkillRun(skill, begin, self._coupled, self._stiffness_N_m)
        self._enter("moving")

    def _rest(self, pressed: Sequence[Pressed]) -> None:
        self.run, self._pressed = None, pressed
        self._enter("resting")

    def _enter(self, stage: Stage) -> None:
        self.stage, self.in_stage_s = stage, 0.0
        self._still = still(self.reference.position_m, self.reference.orientation_wxyz)

    def _note_result(self, outcome: Outcome | None) -> None:
        assert self.run is not None
        self.results.append(
            SkillResult(
                skill=len(self.results),
                label=self.run.skill.label,
                outcome=outcome,
                start_s=self._skill_start_s,
                end_s=self.elapsed_s,
                peak_force_N=self._peak_N,
                ended_m=self._sensed.position_m,
                shift_m=self.run.shift_m,
            )
        )


def _length(vector: Array) -> float:
    return sqrt(vector.dot(vector))
