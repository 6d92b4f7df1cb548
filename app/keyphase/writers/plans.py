"""The plan made executable elsewhere: skills, behaviour tree, listing, and robot programs."""

from collections.abc import Callable
from pathlib import Path

from keyphase.skills.exports.behavior_tree import behavior_tree
from keyphase.skills.exports.program import program_listing
from keyphase.skills.exports.rapid import rapid
from keyphase.skills.exports.skill_file import skill_text
from keyphase.skills.exports.skill_library import library_of
from keyphase.skills.exports.urscript import urscript
from keyphase.skills.library import skills_of
from keyphase.skills.skill import Skill
from keyphase.writers.carried import Carried
from keyphase.writers.putting import put
from keyphase.writers.segmented import SegmentedRecording
from keyphase.writers.writer import Items, Options, Writer

SKILLS_ENDING = ".skills.json"

_PLAN = frozenset({Carried.NAMES, Carried.ORDER, Carried.ENDS})


def _write_skills(items: Items, target: Path, options: Options) -> tuple[Path, ...]:
    (item,) = items
    text = skill_text(library_of(item.demonstration(), _skills(item)))
    return (put(item, target, text.encode(), options),)


def _write_tree(items: Items, target: Path, options: Options) -> tuple[Path, ...]:
    """A behaviour tree names its skills by their file, which is written with it."""
    (item,) = items
    library = target.with_name(f"{target.name.removesuffix(BEHAVIOR_TREE.ending)}{SKILLS_ENDING}")
    _write_skills(items, library, options)
    text = behavior_tree(_skills(item), library.name)
    put(item, target, text.encode(), options)
    return (target, library)


def _program(
    written: Callable[[tuple[Skill, ...], str], str],
) -> Callable[[Items, Path, Options], tuple[Path, ...]]:
    def write(items: Items, target: Path, options: Options) -> tuple[Path, ...]:
        (item,) = items
        text = written(_skills(item), item.name)
        return (put(item, target, text.encode(), options),)

    return write


def _skills(item: SegmentedRecording) -> tuple[Skill, ...]:
    return skills_of(item.demonstration(), item.planned)


SKILLS = Writer(
    name="skills",
    title="skills",
    ending=SKILLS_ENDING,
    extra="",
    carries=_PLAN,
    write=_write_skills,
    reads_back=(
        "from pathlib import Path\n"
        "from keyphase.skills.exports.skill_file import read_skills\n"
        'print([skill.label for skill in read_skills(Path("PATH")).skills])'
    ),
)

BEHAVIOR_TREE = Writer(
    name="behavior-tree",
    title="behaviour tree for BehaviorTree.CPP",
    ending=".tree.xml",
    extra="",
    carries=_PLAN,
    write=_write_tree,
    reads_back=(
        "from xml.etree import ElementTree\n"
        'tree = ElementTree.parse("PATH")\n'
        'print([node.get("name") for node in tree.iter("Fallback")])'
    ),
    remarks=("the skills lie in a file beside it, *.skills.json",),
)

PROGRAM = Writer(
    name="program",
    title="plan as a listing for people",
    ending=".program.txt",
    extra="",
    carries=_PLAN,
    write=_program(program_listing),
    reads_back=(
        'from pathlib import Path\ntext = Path("PATH").read_text(encoding="utf-8")\nprint(text)'
    ),
)

URSCRIPT = Writer(
    name="urscript",
    title="URScript program with contact moves",
    ending=".script",
    extra="",
    carries=_PLAN,
    write=_program(urscript),
    reads_back=PROGRAM.reads_back,
    remarks=("straight lines between points of the path instead of its time course",),
)

RAPID = Writer(
    name="rapid",
    title="ABB RAPID module with contact moves",
    ending=".mod",
    extra="",
    carries=_PLAN,
    write=_program(rapid),
    reads_back=PROGRAM.reads_back,
    remarks=URSCRIPT.remarks,
)
