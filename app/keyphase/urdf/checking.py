"""What makes a file a URDF that can be used, checked so that the answer names the culprit.

The parsers behind yourdfpy and Pinocchio print their reasons where no user of a page sees them.
"""

import re
from collections import Counter
from pathlib import Path
from xml.etree import ElementTree

import numpy as np

from keyphase.errors import RobotError
from keyphase.files.reading import read_regular
from keyphase.urdf.numbers import refuse_bad_numbers

_MAX_BYTES = 4 * 1024**2
_MAX_LINKS = 500
_MAX_SHAPES = 2000
_MAX_ATTRIBUTES = 50
_ENCODING = re.compile(rb"""\W{0,4}<\?xml[^>]*encoding\s*=\s*["']([^"']*)""")
_ENCODINGS = frozenset({"utf-8", "utf8", "utf-16", "us-ascii", "ascii", "iso-8859-1", "latin-1"})

MOVING = ("revolute", "continuous", "prismatic")
_TYPES = (*MOVING, "fixed", "floating", "planar")


def refuse_bad_urdf(path: Path) -> None:
    """Raise RobotError where `path` is no file, no XML, or no URDF with one tree of links."""
    robot = _parsed(path)
    names = [link.get("name", "") for link in robot.findall("link")]
    joints = robot.findall("joint")
    for kind, found in (("link", names), ("joint", [joint.get("name", "") for joint in joints])):
        name, times = Counter(found).most_common(1)[0] if found else ("", 1)
        if times > 1 or "" in found:
            raise RobotError(
                f"{path}: every {kind} must have a name of its own, but "
                + (
                    f"'{name}' is the name of {times}; rename them."
                    if times > 1
                    else "one has none."
                )
            )
    independent = {joint.get("name", "") for joint in joints if joint.find("mimic") is None}
    for joint in joints:
        _refuse_bad_joint(path, joint, set(names))
        _refuse_bad_mimic(path, joint, independent)
    refuse_bad_numbers(path, robot)
    children = Counter(_end(joint, "child") for joint in joints)
    child, times = children.most_common(1)[0] if children else ("", 1)
    if times > 1:
        raise RobotError(
            f"{path}: every link must hang on one joint, but '{child}' hangs on {times}; "
            "remove all of them but one."
        )
    roots = sorted(set(names) - set(children))
    if len(roots) != 1 or len(_below(roots[0], joints)) < len(names):
        raise RobotError(
            f"{path}: expected links that form one tree with one root, but "
            + (
                f"found {len(roots)} roots ({', '.join(roots)[:200]})"
                if len(roots) > 1
                else "some of them form loops"
            )
            + "; connect all by joints, each below another."
        )


def _parsed(path: Path) -> ElementTree.Element:
    try:
        data = read_regular(path, _MAX_BYTES)
    except FileNotFoundError as error:
        raise RobotError(
            f"{path}: expected a robot description, but there is no such file; "
            "give the path of a URDF."
        ) from error
    except (OSError, ValueError) as error:
        reason = error.strerror if isinstance(error, OSError) else str(error)
        raise RobotError(f"{path}: the URDF cannot be read ({reason}); check it.") from error
    _refuse_declarations(path, data)
    try:
        robot = ElementTree.fromstring(data)
    except (ElementTree.ParseError, LookupError, ValueError) as error:
        raise RobotError(
            f"{path}: expected a URDF, but it is no XML ({error}); "
            "give a URDF, which is an XML file."
        ) from error
    if robot.tag != "robot" or not robot.get("name") or robot.find("link") is None:
        raise RobotError(
            f'{path}: expected a URDF, <robot name="..."> with links in it, but found '
            f"<{robot.tag}> with {len(robot.findall('link'))} links; "
            "convert other formats (xacro, SDF, MJCF) to URDF first."
        )
    _refuse_too_much(path, robot)
    return robot


def _refuse_too_much(path: Path, robot: ElementTree.Element) -> None:
    """What the parsers behind yourdfpy and Pinocchio take minutes over."""
    links = len(robot.findall("link"))
    if links > _MAX_LINKS:
        raise RobotError(
            f"{path}: a robot may have {_MAX_LINKS} links, but this one has {links}; leave out "
            "those that the arm does not need."
        )
    shapes = sum(len(robot.findall(f"link/{kind}")) for kind in ("visual", "collision"))
    if shapes > _MAX_SHAPES:
        raise RobotError(
            f"{path}: a robot may have {_MAX_SHAPES} shapes, but this one has {shapes}; put those "
            "of a link into one mesh."
        )
    if any(len(element.attrib) > _MAX_ATTRIBUTES for element in robot.iter()):
        raise RobotError(
            f"{path}: an element may have {_MAX_ATTRIBUTES} attributes, but one has more; check "
            "that it is a URDF."
        )


def _refuse_declarations(path: Path, data: bytes) -> None:
    """Entities of one's own can make gigabytes of a line, and encodings anything of a file."""
    plain = data.replace(b"\0", b"")
    if b"<!DOCTYPE" in plain or b"<!ENTITY" in plain:
        raise RobotError(
            f"{path}: a URDF must not declare a document type or entities of its own, but this one "
            "does; write out what they stand for."
        )
    named = _ENCODING.match(plain)
    if named and named[1].decode("ascii", "replace").lower() not in _ENCODINGS:
        raise RobotError(
            f"{path}: a URDF must be UTF-8, UTF-16, ASCII or Latin-1 text, but says it is "
            f"{named[1][:40].decode('ascii', 'replace')!r}; save it as UTF-8."
        )


def _refuse_bad_joint(path: Path, joint: ElementTree.Element, links: set[str]) -> None:
    name, kind = joint.get("name"), joint.get("type")
    if kind not in _TYPES:
        raise RobotError(
            f"{path}: joint '{name}' must be one of {', '.join(_TYPES)}, but its type is {kind!r}."
        )
    for end in ("parent", "child"):
        if _end(joint, end) not in links:
            raise RobotError(
                f"{path}: joint '{name}' must connect two links of the robot, but its {end} is "
                f"'{_end(joint, end)}'; add that link or correct the name."
            )
    limit = joint.find("limit")
    missing = [] if limit is None else [k for k in ("velocity", "effort") if limit.get(k) is None]
    if missing:
        raise RobotError(
            f"{path}: joint '{name}' must have a <limit> with velocity and effort, but "
            f"{' and '.join(missing)} is missing; add what the robot's data sheet says."
        )
    if kind in ("revolute", "prismatic"):
        _refuse_bad_range(path, joint)
    axis = joint.find("axis")
    if kind in MOVING and axis is not None and not np.any(_numbers(path, joint, axis, "xyz")):
        raise RobotError(
            f"{path}: joint '{name}' must move along an axis, but its axis is zero; correct it."
        )


def _refuse_bad_range(path: Path, joint: ElementTree.Element) -> None:
    limit = joint.find("limit")
    if limit is None:
        raise RobotError(
            f"{path}: joint '{joint.get('name')}' must have a <limit>, as its type is "
            f"{joint.get('type')}, but has none; add it, or make the joint continuous or fixed."
        )
    lower = _numbers(path, joint, limit, "lower", "0")[0]
    upper = _numbers(path, joint, limit, "upper", "0")[0]
    if lower > upper:
        raise RobotError(
            f"{path}: joint '{joint.get('name')}' must have a <limit> whose lower end does not lie "
            f"above its upper end, but has [{lower:g}, {upper:g}]; swap them."
        )


def _refuse_bad_mimic(path: Path, joint: ElementTree.Element, independent: set[str]) -> None:
    mimic = joint.find("mimic")
    if mimic is not None and mimic.get("joint") not in independent:
        raise RobotError(
            f"{path}: joint '{joint.get('name')}' must mimic a joint that moves by itself, but "
            f"mimics '{mimic.get('joint')}'; name such a joint."
        )


def _numbers(
    path: Path,
    joint: ElementTree.Element,
    element: ElementTree.Element,
    key: str,
    default: str = "",
) -> list[float]:
    text = element.get(key, default)
    try:
        numbers = [float(word) for word in text.split()]
    except ValueError:
        numbers = []
    if not numbers or not np.all(np.isfinite(numbers)):
        raise RobotError(
            f"{path}: joint '{joint.get('name')}' must have numbers for {key} in "
            f"<{element.tag}>, but has '{text}'; correct it."
        )
    return numbers


def _below(root: str, joints: list[ElementTree.Element]) -> set[str]:
    """The root and all links that can be reached from it."""
    beneath: dict[str, list[str]] = {}
    for joint in joints:
        beneath.setdefault(_end(joint, "parent"), []).append(_end(joint, "child"))
    reached, waiting = {root}, [root]
    while waiting:
        for link in beneath.get(waiting.pop(), []):
            if link not in reached:
                reached.add(link)
                waiting.append(link)
    return reached


def _end(joint: ElementTree.Element, which: str) -> str:
    element = joint.find(which)
    return "" if element is None else element.get("link", "")
