"""A plan of skills as a program listing that people read."""

from collections.abc import Sequence

from keyphase.skills.skill import Skill, until


def program_listing(skills: Sequence[Skill], demonstration: str) -> str:
    """One line per skill: number, label, duration, end condition, and what fails it.

    Connecting moves are marked by an arrow; control characters in labels are printed as spaces.
    """
    total = sum(skill.primitive.duration_s for skill in skills)
    head = f"program of {_printable(demonstration)}: {len(skills)} skills, {total:.1f} s"
    if not skills:
        return head + "\n"
    labels = [("→ " if s.connecting else "") + _printable(s.label) for s in skills]
    width = max(map(len, labels))
    lines = [
        f"{number:3d}  {label:<{width}}  {skill.primitive.duration_s:5.2f} s  "
        f"{until(skill)}, or {_failure(skill)}"
        for number, (label, skill) in enumerate(zip(labels, skills, strict=True), start=1)
    ]
    return "\n".join([head, *lines]) + "\n"


def _failure(skill: Skill) -> str:
    after = f"fail after {skill.timeout_s:.1f} s"
    if skill.travel_direction is None:
        return after
    return f"{after} or {1e3 * skill.travel_limit_m:.0f} mm beyond"


def _printable(text: str) -> str:
    return "".join(c if c.isprintable() else " " for c in text)
