# MuJoCo tells no types.
# pyright: reportAttributeAccessIssue=false
"""Reading an MJCF or URDF file that anybody may have written, as a MuJoCo specification.

MuJoCo reads whatever file a model names, and builds what it is told to; so a model is looked
through first: it may name files that lie beside it, and nothing that runs or multiplies.
"""

import re
from pathlib import Path
from xml.etree import ElementTree

import mujoco

from keyphase.errors import SimulationError
from keyphase.files.reading import read_regular

MAX_BYTES, MAX_ASSET_BYTES = 4 * 1024**2, 64 * 1024**2
MAX_ELEMENTS = 20_000

_REFUSED = frozenset(
    {"include", "plugin", "extension", "replicate", "composite", "flexcomp", "flex", "model"}
)
"""Elements that read files unseen, load code, or multiply."""

_COUNTS = ("nrow", "ncol", "width", "height")
_LARGEST_COUNT = 4096

_FOLDERS = ("meshdir", "texturedir", "assetdir")
_FILES = (
    "file",
    "filename",
    "fileright",
    "fileleft",
    "fileup",
    "filedown",
    "filefront",
    "fileback",
)


def spec_from(path: Path) -> mujoco.MjSpec:
    """The specification in an MJCF or URDF file.

    Raises SimulationError for a file that cannot be read, is none, or names what it may not.
    """
    root = _parsed(path)
    if root.tag == "robot":
        _leave_out_looks(root)
        _refuse_unfinished(path, root)
    _refuse_dangerous(path, root)
    for size in root.findall("size"):
        # What MuJoCo is to set aside for it is for MuJoCo to say.
        root.remove(size)
    try:
        text = ElementTree.tostring(root, encoding="unicode")
        return mujoco.MjSpec.from_string(text, assets=_assets(path, root))
    except (ValueError, RuntimeError, mujoco.FatalError) as error:
        raise _refused(path, f"MuJoCo cannot read it ({_line(error)})") from error


def compiled(path: Path, spec: mujoco.MjSpec) -> mujoco.MjModel:
    """The model of a specification that came from `path`.

    Raises SimulationError where MuJoCo refuses it.
    """
    try:
        return spec.compile()
    except (ValueError, RuntimeError, mujoco.FatalError) as error:
        raise _refused(path, f"MuJoCo cannot build it ({_line(error)})") from error


def _parsed(path: Path) -> ElementTree.Element:
    try:
        data = read_regular(path, MAX_BYTES)
    except FileNotFoundError as error:
        raise _refused(path, "there is no such file") from error
    except (OSError, ValueError) as error:
        raise _refused(path, f"it cannot be read ({error})") from error
    plain = data.replace(b"\0", b"")
    if re.search(rb"<!(DOCTYPE|ENTITY)", plain, re.IGNORECASE):
        raise _refused(path, "it declares a document type or entities of its own")
    try:
        root = ElementTree.fromstring(data)
    except (ElementTree.ParseError, LookupError, ValueError, RecursionError) as error:
        raise _refused(path, f"it is no XML ({error})") from error
    if root.tag not in ("mujoco", "robot"):
        raise _refused(path, f"it begins with <{root.tag}>")
    return root


def _refuse_dangerous(path: Path, root: ElementTree.Element) -> None:
    for count, element in enumerate(root.iter()):
        if count > MAX_ELEMENTS:
            raise _refused(path, f"it has more than {MAX_ELEMENTS} elements")
        if element.tag in _REFUSED:
            raise _refused(path, f"it holds <{element.tag}>; write out what that stands for")
        for key in _COUNTS:
            if element.tag in ("hfield", "texture") and not _is_count(element.get(key, "1")):
                raise _refused(
                    path, f"<{element.tag}> must have a {key} of {_LARGEST_COUNT} at most"
                )
        named = [element.get(key, "") for key in (*_FILES, *_FOLDERS)]
        for name in filter(None, named):
            if Path(name).is_absolute() or ".." in Path(name).parts or ":" in name:
                raise _refused(path, f"it names the file '{name}', which does not lie beside it")


def _refuse_unfinished(path: Path, root: ElementTree.Element) -> None:
    """Refuse a URDF that is still to be expanded, or whose joints have no way to go."""
    for element in root.iter():
        if "xacro" in element.tag or any("${" in value for value in element.attrib.values()):
            raise _refused(path, "it is still to be expanded by xacro")
    for joint in root.iter("joint"):
        limit = joint.find("limit")
        ends = [] if limit is None else [limit.get("lower", "0"), limit.get("upper", "0")]
        if ends and not _in_order(*ends):
            raise _refused(
                path, f"the limits of joint '{joint.get('name')}' are {ends[0]} and {ends[1]}"
            )


def _in_order(lower: str, upper: str) -> bool:
    try:
        return float(lower) <= float(upper)
    except ValueError:
        return False


def _is_count(text: str) -> bool:
    return len(text) < 8 and text.strip().isdigit() and int(text) <= _LARGEST_COUNT


def _leave_out_looks(root: ElementTree.Element) -> None:
    """MuJoCo reads no meshes of a URDF's package, and needs none to move an arm."""
    for link in root.iter("link"):
        for kind in ("visual", "collision"):
            for shape in link.findall(kind):
                link.remove(shape)


def _assets(path: Path, root: ElementTree.Element) -> dict[str, bytes]:
    """Contents of the files that a model names, by the names it has for them."""
    compiler = root.find("compiler")
    folders = [""] + [compiler.get(key, "") for key in _FOLDERS if compiler is not None]
    found: dict[str, bytes] = {}
    left = MAX_ASSET_BYTES
    for element in root.iter():
        for name in filter(None, (element.get(key) for key in _FILES)):
            for folder in folders:
                try:
                    data = read_regular(path.parent / folder / name, left)
                except (OSError, ValueError):
                    continue
                left -= len(data)
                found[str(Path(folder) / name)] = found[name] = data
                break
    return found


def _line(error: Exception) -> str:
    return " ".join(str(error).split())[:200]


def _refused(path: Path, why: str) -> SimulationError:
    return SimulationError(
        f"{path}: expected a model that MuJoCo reads (MJCF or URDF), but {why}; correct it."
    )
