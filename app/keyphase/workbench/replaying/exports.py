"""What carries on elsewhere: skills, behaviour tree, program and a shareable replay as files."""

import os
from collections.abc import Callable, Mapping
from pathlib import Path

from keyphase.errors import RequestError, SimulationError
from keyphase.files.parts import stem_of
from keyphase.files.writing import write_whole
from keyphase.skills.exports.behavior_tree import behavior_tree
from keyphase.skills.exports.program import program_listing
from keyphase.skills.exports.rapid import rapid
from keyphase.skills.exports.skill_file import write_skills
from keyphase.skills.exports.skill_library import library_of
from keyphase.skills.exports.urscript import urscript
from keyphase.workbench.replaying.plan import ReplayPlan


def export_plan(plan: ReplayPlan, recording: Path, kind: str) -> Path:
    """Write the plan as `skills`, `behavior tree`, `program`, `urscript` or `rapid`; its path.

    It stands beside the recording, or, where nothing may be written there, in the current folder.
    A behaviour tree names its skills by their file, which is written with it. Raises RequestError
    for another kind, SkillError or SimulationError where the file cannot be written.
    """
    writers: Mapping[str, Callable[[], Path]] = {
        "skills": lambda: _write_skills(plan, recording),
        "behavior tree": lambda: _write_tree(plan, recording),
        "program": lambda: _write_text(
            beside(recording, ".program.txt"), program_listing(plan.skills, stem_of(recording))
        ),
        "urscript": lambda: _write_text(
            beside(recording, ".script"), urscript(plan.skills, stem_of(recording))
        ),
        "rapid": lambda: _write_text(
            beside(recording, ".mod"), rapid(plan.skills, stem_of(recording))
        ),
    }
    if kind not in writers:
        raise RequestError(f"A plan is written as {', '.join(writers)}, but not as {kind!r}.")
    return writers[kind]()


def beside(recording: Path, suffix: str) -> Path:
    """A file named after the recording, where there is room for it."""
    folder = recording.parent if os.access(recording.parent, os.W_OK) else Path.cwd()
    return folder / f"{stem_of(recording)}{suffix}"


def write_page(html: str, recording: Path) -> Path:
    """Write a page that opens without a server. Raises SimulationError where that fails."""
    return _write_text(beside(recording, ".replay.html"), html)


def _write_skills(plan: ReplayPlan, recording: Path) -> Path:
    path = beside(recording, ".skills.json")
    write_skills(path, library_of(plan.demonstration, plan.skills))
    return path


def _write_tree(plan: ReplayPlan, recording: Path) -> Path:
    library = _write_skills(plan, recording)
    return _write_text(beside(recording, ".xml"), behavior_tree(plan.skills, library.name))


def _write_text(path: Path, text: str) -> Path:
    write_whole(path, text.encode(), refusal=SimulationError)
    return path
