"""Replays and trials in words and as JSON."""

import json
from typing import Any

import numpy as np

from keyphase.simulation.replay.result import ReplayResult, SkillResult
from keyphase.simulation.replay.trials import Trials


def replay_text(result: ReplayResult) -> str:
    """One line for each skill, then the workcell's checks; the outcome comes last."""
    width = max(len(skill.label) for skill in result.skills)
    lines = [_skill_line(each, width) for each in result.results]
    for index in range(len(result.results), len(result.skills)):
        lines.append(
            f"{index + 1:3d}  {_printable(result.skills[index].label):<{width}}  not begun"
        )
    checks = ", ".join(
        f"{name}: {'yes' if holds else 'no'}" for name, holds in result.checks.items()
    )
    lines.append(f"{checks}; {result.duration_s:.2f} s, peak force {result.peak_force:.1f} N")
    return "\n".join([*lines, _printable(result.outcome())])


def replay_values(result: ReplayResult) -> dict[str, Any]:
    """The same as JSON values."""
    return {
        "skills": [
            {
                "label": each.label,
                "connecting": result.skills[each.skill].connecting,
                "outcome": each.outcome,
                "start_s": each.start_s,
                "end_s": each.end_s,
                "peak_force_N": each.peak_force_N,
                "ended_m": each.ended_m.tolist(),
                "shift_m": each.shift_m.tolist(),
            }
            for each in result.results
        ],
        "not_begun": [skill.label for skill in result.skills[len(result.results) :]],
        "checks": dict(result.checks),
        "duration_s": result.duration_s,
        "peak_force_N": result.peak_force,
        "succeeded": result.succeeded,
        "outcome": result.outcome(),
    }


def trials_text(trials: Trials) -> str:
    """How each skill ended how often; success rate and forces come last."""
    width = max((len(label) for label in trials.labels), default=0)
    lines = []
    for index, label in enumerate(trials.labels):
        counts = ", ".join(f"{count} {how}" for how, count in trials.outcomes(index).most_common())
        lines.append(f"{index + 1:3d}  {_printable(label):<{width}}  {counts}")
    return "\n".join([*lines, trials_outcome(trials)])


def trials_outcome(trials: Trials) -> str:
    """Success rate with its confidence interval, and the forces, in one line."""
    low, high = trials.interval()
    peaks = trials.peak_forces()
    return (
        f"Success in {trials.successes} of {len(trials.trials)} worlds "
        f"({100 * trials.rate:.1f} %, 95 % confidence {100 * low:.1f} to {100 * high:.1f} %), "
        f"peak force {peaks.max():.1f} N, median {np.median(peaks):.1f} N"
    )


def trials_values(trials: Trials) -> dict[str, Any]:
    """Every trial and the summary as JSON values."""
    return {
        "skills": [
            {"label": label, "outcomes": dict(sorted(trials.outcomes(index).items()))}
            for index, label in enumerate(trials.labels)
        ],
        "trials": [
            {
                "disturbance": trial.world.disturbance.as_json(),
                "seed": trial.world.seed,
                "outcomes": list(trial.outcomes),
                "checks": dict(trial.checks),
                "peak_force_N": trial.peak_force_N,
                "duration_s": trial.duration_s,
                "error": trial.error,
                "succeeded": trial.succeeded,
            }
            for trial in trials.trials
        ],
        "successes": trials.successes,
        "rate": trials.rate,
        "confidence_95": list(trials.interval()),
        "peak_force_N": float(trials.peak_forces().max()),
        "outcome": trials_outcome(trials),
    }


def as_json(values: dict[str, Any]) -> str:
    """JSON for machines; the same values give the same text."""
    return json.dumps(values, indent=1, ensure_ascii=False, allow_nan=False)


def _skill_line(each: SkillResult, width: int) -> str:
    return (
        f"{each.skill + 1:3d}  {_printable(each.label):<{width}}  {each.outcome or 'stopped':<18}  "
        f"{each.end_s - each.start_s:5.2f} s  peak {each.peak_force_N:4.1f} N"
    )


def _printable(text: str) -> str:
    """Labels are people's: what is no printable character is printed as a space."""
    return "".join(c if c.isprintable() else " " for c in text)
