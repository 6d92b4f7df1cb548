"""What carries on elsewhere: skills, behaviour tree, program and a shareable replay as files."""

from collections.abc import Callable, Mapping
from pathlib import Path

from keyphase.errors import RequestError, SimulationError, SkillError
from keyphase.files.parts import stem_of
from keyphase.labeling.storage.written_files import IfThere
from keyphase.skills.exports.behavior_tree import behavior_tree
from keyphase.skills.exports.program import program_listing
from keyphase.skills.exports.rapid import rapid
from keyphase.skills.exports.skill_file import skill_text
from keyphase.skills.exports.skill_library import library_of
from keyphase.skills.exports.urscript import urscript
from keyphase.workbench.exporting.beside import Beside
from keyphase.workbench.replaying.plan import ReplayPlan

PLAN_KINDS = ("skills", "behavior-tree", "program", "urscript", "rapid")


def export_plan(plan: ReplayPlan, recording: Path, kind: str, if_there: IfThere = "ask") -> Path:
    """Write the plan as `skills`, `behavior-tree`, `program`, `urscript` or `rapid`; its path.

    It stands beside the recording, or, where nothing may be written there, in the current folder.
    A behaviour tree names its skills by their file, which is written with it. Raises RequestError
    for another kind, FileInTheWayError where somebody else's file would be replaced, SkillError
    or SimulationError where the file cannot be written.
    """
    there, name = Beside(recording, if_there), stem_of(recording)
    writers: Mapping[str, Callable[[], Path]] = {
        "skills": lambda: _write_skills(plan, there),
        "behavior-tree": lambda: _write_tree(plan, there),
        "program": lambda: _write_text(there, ".program.txt", program_listing(plan.skills, name)),
        "urscript": lambda: _write_text(there, ".script", urscript(plan.skills, name)),
        "rapid": lambda: _write_text(there, ".mod", rapid(plan.skills, name)),
    }
    if kind not in writers:
        raise RequestError(f"A plan is written as {', '.join(writers)}, but not as {kind!r}.")
    return writers[kind]()


def write_page(html: str, recording: Path, if_there: IfThere = "ask") -> Path:
    """Write a page that opens without a server.

    Raises FileInTheWayError where somebody else's file would be replaced, SimulationError where
    the folder takes none.
    """
    return _write_text(Beside(recording, if_there), ".replay.html", html)


def _write_skills(plan: ReplayPlan, there: Beside) -> Path:
    text = skill_text(library_of(plan.demonstration, plan.skills))
    return there.write(".skills.json", text.encode(), SkillError)


def _write_tree(plan: ReplayPlan, there: Beside) -> Path:
    library = _write_skills(plan, there)
    return _write_text(there, ".tree.xml", behavior_tree(plan.skills, library.name))


def _write_text(there: Beside, ending: str, text: str) -> Path:
    return there.write(ending, text.encode(), SimulationError)
