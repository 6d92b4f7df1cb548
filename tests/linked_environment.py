"""An environment of a few packages, linked from those of this one: what pip would install, at once.

Which packages it holds follows from what they declare, as it would with pip; their files are the
ones that pip put here.
"""

import venv
from collections.abc import Iterable
from importlib.metadata import Distribution, distribution
from pathlib import Path

from packaging.requirements import Requirement
from packaging.utils import canonicalize_name


def environment_with(folder: Path, requirements: Iterable[str]) -> Path:
    """Make an environment with these requirements and all they need; returns its bin folder."""
    venv.create(folder)
    (site,) = folder.glob("lib/python*/site-packages")
    for found in _with_all_they_need(requirements):
        for entry, target in _entries(found).items():
            if not (site / entry).exists():
                (site / entry).symlink_to(target)
    return folder / "bin"


def _with_all_they_need(requirements: Iterable[str]) -> list[Distribution]:
    waiting = [(one, "") for one in requirements]
    known: dict[tuple[str, str], Distribution] = {}
    while waiting:
        text, extra = waiting.pop()
        requirement = Requirement(text)
        if requirement.marker and not requirement.marker.evaluate({"extra": extra}):
            continue
        for wanted in ("", *requirement.extras):
            key = canonicalize_name(requirement.name), wanted
            if key not in known:
                known[key] = found = distribution(requirement.name)
                waiting += [(needed, wanted) for needed in found.requires or ()]
    return list(known.values())


def _entries(found: Distribution) -> dict[str, Path]:
    """What lies in site-packages of a package: its topmost names, and where they are."""
    names = {path.parts[0] for path in found.files or ()} - {"..", "__pycache__"}
    return {name: Path(str(found.locate_file(name))) for name in names}
