"""Which files a robot's description may name as meshes, before any of them is parsed."""

from pathlib import Path

from keyphase.errors import RobotError
from keyphase.files.reading import first_bytes, read_regular

_BINARY = (".stl", ".glb", ".ply")
_TEXT = (".dae", ".gltf")
_SLOW = (".obj", ".off")
_MAX_BYTES = {_BINARY: 64 * 1024**2, _TEXT: 24 * 1024**2, _SLOW: 8 * 1024**2}
"""Of all meshes of a robot together; parsing more takes longer than anybody waits."""


class MeshFiles:
    """The mesh files of one description, let in one after the other."""

    def __init__(self, description: Path) -> None:
        self._description = description
        self._sizes: dict[Path, int] = {}

    def let_in(self, name: str, file: Path) -> None:
        """Refuse what is no regular file of a known format, or more than a robot's meshes take.

        Raises RobotError, naming the mesh as the description does.
        """
        kind = next((kind for kind in _MAX_BYTES if file.suffix.lower() in kind), None)
        if kind is None:
            raise self._refused(
                name,
                f"must be one of {', '.join(_BINARY + _TEXT + _SLOW)}, but ends in '{file.suffix}'",
            )
        try:
            first_bytes(file, 1)
            self._sizes[file] = file.stat().st_size
            total = sum(size for one, size in self._sizes.items() if one.suffix.lower() in kind)
            if total > _MAX_BYTES[kind]:
                raise self._refused(
                    name,
                    f"brings the meshes of its kind to {total} bytes, more than the "
                    f"{_MAX_BYTES[kind]} they may have together",
                )
            data = read_regular(file, _MAX_BYTES[_TEXT]) if file.suffix.lower() == ".dae" else b""
        except OSError as error:
            raise self._refused(name, f"cannot be read ({error.strerror})") from error
        if b"<!DOCTYPE" in data or b"<!ENTITY" in data:
            raise self._refused(name, "declares a document type or entities of its own")

    def _refused(self, name: str, reason: str) -> RobotError:
        return RobotError(
            f"{self._description}: the mesh '{name[:200]}' {reason}; export a coarser one as STL "
            "or GLB, or remove that visual."
        )
