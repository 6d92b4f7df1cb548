"""The skill file: a library of skills as versioned JSON with a published schema.

It holds all that an executor needs, so that what was proved in a replay is what is exported. The
same skills give the same bytes; reading them back gives the same skills, to the last bit.
"""

import json
from importlib.resources import files
from pathlib import Path
from typing import Any

from keyphase import __version__
from keyphase.errors import ParameterError, SkillError
from keyphase.files.reading import read_regular
from keyphase.files.strict_json import parsed_json, violation
from keyphase.files.writing import write_whole
from keyphase.skills.exports.skill_library import SkillLibrary
from keyphase.skills.exports.skill_parsing import library_of_values
from keyphase.skills.exports.skill_values import library_values

FORMAT = "keyphase skills"
VERSION = 2

_LIMIT_BYTES = 256 * 1024**2
_MAX_VALUES = 10_000_000


def schema() -> dict[str, Any]:
    """The JSON Schema (draft 2020-12) of a skill file."""
    return json.loads((files("keyphase.skills.exports") / "skills.schema.json").read_text("utf-8"))


def skill_text(library: SkillLibrary) -> str:
    """The library as the text of a skill file."""
    head = {"format": FORMAT, "version": VERSION, "software": f"keyphase {__version__}"}
    content = head | library_values(library)
    return json.dumps(content, indent=1, ensure_ascii=False, allow_nan=False) + "\n"


def library_of_text(text: str, name: str = "skill file") -> SkillLibrary:
    """The library in the text of a skill file; `name` is used in messages.

    Raises SkillError where the text is no JSON, does not follow the schema or holds skills that
    cannot be executed.
    """
    content = _parsed(text, name)
    _refuse_version_1(content, name)
    broken = violation(content, schema())
    if broken is not None:
        raise SkillError(
            f"{name} is no skill file of version {VERSION}: at {broken}; export the skills again."
        )
    try:
        return library_of_values(content)
    except ParameterError as refused:
        raise SkillError(f"{name}: {refused}") from refused


def write_skills(path: Path, library: SkillLibrary) -> None:
    """Write a skill file whole. Raises SkillError where the folder takes no files."""
    write_whole(path, skill_text(library).encode(), refusal=SkillError)


def read_skills(path: Path) -> SkillLibrary:
    """Read a skill file. Raises SkillError where it is missing, damaged or not one."""
    try:
        text = read_regular(path, _LIMIT_BYTES).decode()
    except (OSError, ValueError) as error:
        raise SkillError(f"{path} cannot be read as a skill file ({error}).") from error
    return library_of_text(text, str(path))


def _refuse_version_1(content: Any, name: str) -> None:
    if (
        isinstance(content, dict)
        and content.get("format") == FORMAT
        and content.get("version") == 1
    ):
        raise SkillError(
            f"{name} is a skill file of version 1, which says neither how a contact is approached "
            "and pressed nor what follows it, so that nothing can be executed as it was proved; "
            f"export the skills again as version {VERSION}."
        )


def _parsed(text: str, name: str) -> Any:
    try:
        return parsed_json(text.encode(errors="backslashreplace"), _MAX_VALUES)
    except ValueError as error:
        raise SkillError(
            f"{name} must be JSON as keyphase writes it, but is not ({error}); "
            "export the skills again."
        ) from error
