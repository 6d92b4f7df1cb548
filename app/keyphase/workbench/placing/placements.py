"""Where recordings stand in front of a robot, kept beside them with their labels."""

import json
import math
from pathlib import Path
from typing import Any

from keyphase.errors import KeyphaseError, LabelingError
from keyphase.files.writing import write_whole
from keyphase.labeling.storage.state_folder import state_folder
from keyphase.robot.pose import Placement

VERSION = 1


def saved_placement(recording: Path, robot: str) -> Placement | None:
    """What a person chose for this recording and robot; None where nobody did.

    Raises LabelingError for a file that is damaged.
    """
    path = state_folder(recording.parent, create=False).newest(_name(recording))
    if path is None:
        return None
    try:
        return _all(path).get(robot)
    except (OSError, ValueError, TypeError, KeyError, RecursionError) as error:
        raise LabelingError(
            f"{path}: expected placements of version {VERSION}, but they cannot be read ({error}); "
            "place the robot again."
        ) from error


def save_placement(recording: Path, robot: str, placement: Placement) -> None:
    """Put a choice on disk, whole, before returning.

    Raises LabelingError where nothing can be written.
    """
    path = state_folder(recording.parent).path / _name(recording)
    try:
        others = _all(path)
    except (OSError, ValueError, TypeError, KeyError, RecursionError):
        others = {}
    content = {
        "version": VERSION,
        "robots": {name: _as_json(one) for name, one in {**others, robot: placement}.items()},
    }
    write_whole(path, f"{json.dumps(content, indent=1)}\n".encode(), refusal=LabelingError)


def forget_placement(recording: Path) -> None:
    """Choose nothing for this recording any more."""
    found: KeyphaseError | None = None
    folder = state_folder(recording.parent, create=False)
    for place in (folder.path, folder.other):
        try:
            (place / _name(recording)).unlink(missing_ok=True)
        except OSError as error:
            found = LabelingError(
                f"{place}: the placement must be removable, but is not ({error.strerror}); "
                "check the folder."
            )
    if found is not None:
        raise found


def _name(recording: Path) -> str:
    return f"{recording.name}.placement.json"


def _all(path: Path) -> dict[str, Placement]:
    content = json.loads(path.read_bytes())
    if content["version"] != VERSION:
        raise ValueError(f"version {content['version']!r}")
    return {name: _placement(one) for name, one in content["robots"].items()}


def _as_json(placement: Placement) -> dict[str, list[float]]:
    return {
        "position_m": list(placement.position_m),
        "orientation_wxyz": list(placement.orientation_wxyz),
    }


def _placement(content: Any) -> Placement:
    x, y, z = (_finite(value) for value in content["position_m"])
    a, b, c, d = (_finite(value) for value in content["orientation_wxyz"])
    norm = math.hypot(a, b, c, d)
    if norm < 1e-6:
        raise ValueError("an orientation of no length")
    return Placement((x, y, z), (a / norm, b / norm, c / norm, d / norm))


def _finite(value: Any) -> float:
    number = float(value)
    if not math.isfinite(number):
        raise ValueError(f"{value!r} is no finite number")
    return number
