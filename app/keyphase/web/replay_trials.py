"""Trials from the page: the plan in many disturbed worlds, in the background."""

from collections.abc import Callable

from keyphase.simulation.replay_report import trials_outcome
from keyphase.simulation.spread import Spread
from keyphase.simulation.trials import Worlds, drawn_worlds, run_trials
from keyphase.simulation.trials_picture import trials_svg
from keyphase.web.opened import Opened
from keyphase.web.replay_plan import plan_of
from keyphase.web.replay_settings import ReplaySettings
from keyphase.web.telling import Telling

WORLDS = Worlds(
    part_height_m=Spread(-0.01, 0.01),
    part_offset_m=Spread(-0.005, 0.005),
    friction=Spread(0.2, 0.6),
    sensor_noise=Spread(2.0, 2.0),
)
"""Parts ±10 mm in height and ±5 mm aside, friction 0.2 to 0.6, sensor noise doubled."""


def run_and_tell(
    opened: Opened,
    settings: ReplaySettings,
    count: int,
    telling: Telling,
    on_outcome: Callable[[str], None],
) -> None:
    """Run `count` worlds on all cores; the pages get progress, then the picture.

    Raises SkillError or SimulationError for a plan that cannot be replayed.
    """
    plan = plan_of(opened.labeling, settings.end_by)
    worlds = drawn_worlds(WORLDS, count, settings.seed)
    what = f"Trials of {opened.recording.name}"
    telling.progress(what, 0.0)

    def progress(done: int, total: int) -> None:
        telling.progress(what, done / total)

    try:
        trials = run_trials(
            settings.workcell, plan.demonstration, plan.skills, worlds, progress=progress
        )
    finally:
        telling.progress_done()
    title = f"{opened.recording.name} in {settings.workcell}, {settings.end_by} end conditions"
    outcome = trials_outcome(trials)
    on_outcome(outcome)
    telling.all(
        {"type": "trials", "title": title, "outcome": outcome, "svg": trials_svg(trials, title)}
    )
