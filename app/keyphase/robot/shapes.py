"""What a robot's links look like, read by yourdfpy for display."""

import os
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

import numpy as np
import trimesh
from trimesh.exchange.gltf import export_glb
from yourdfpy import URDF
from yourdfpy.urdf import filename_handler_magic

from keyphase.demonstration import Array
from keyphase.errors import RobotError
from keyphase.robot.mesh_files import MeshFiles


@dataclass(frozen=True, eq=False)
class LinkShape:
    """One mesh fixed to a link, and where: `origin` (4, 4) in the link's frame."""

    link: str
    mesh: trimesh.Trimesh
    origin: Array


def read_display(path: Path) -> URDF:
    """The description with its meshes, as yourdfpy loads it.

    Raises RobotError where it is no valid URDF or a mesh is missing or cannot be read.
    """
    files = MeshFiles(path)

    def found(fname: str) -> str:
        file = filename_handler_magic(fname, dir=str(path.parent))
        if not os.path.exists(file):
            raise RobotError(
                f"{path}: the mesh '{fname}' is missing; put it at the path the description "
                f"names, relative to {path.parent}, or remove that visual."
            )
        files.let_in(fname, Path(file))
        return file

    try:
        display = URDF.load(str(path), filename_handler=found)
    except RobotError:
        raise
    except Exception as error:
        # A file from anywhere can fail anywhere in the parser or a mesh loader.
        raise RobotError(
            f"{path}: expected a valid URDF with readable meshes, but reading it gave "
            f"{type(error).__name__}: {error}; check the file with another URDF viewer."
        ) from error
    _refuse_empty_meshes(path, display)
    return display


def _refuse_empty_meshes(path: Path, display: URDF) -> None:
    # A mesh file that cannot be read gives an empty scene, silently.
    graph = display.scene.graph
    shown = {graph.transforms.parents[node] for node in graph.nodes_geometry}
    for name, link in display.link_map.items():
        files = [v.geometry.mesh.filename for v in link.visuals if v.geometry and v.geometry.mesh]
        if files and name not in shown:
            raise RobotError(
                f"{path}: the mesh '{files[0]}' of link '{name}' must hold a surface, but nothing "
                "could be read from it; export it again as STL, OBJ, DAE or GLB."
            )


def shapes_of(display: URDF) -> tuple[LinkShape, ...]:
    """Every visual mesh with the link it belongs to."""
    graph = display.scene.graph
    shapes = []
    for node in graph.nodes_geometry:
        link = graph.transforms.parents[node]
        origin, name = graph.get(node, frame_from=link)
        mesh = display.scene.geometry[name]
        if isinstance(mesh, trimesh.Trimesh):
            shapes.append(LinkShape(link, mesh, np.array(origin, dtype=np.float64)))
    return tuple(shapes)


def link_glb(shapes: Sequence[LinkShape]) -> bytes:
    """One GLB file of shapes of the same link, in that link's frame, with their colours."""
    scene = trimesh.Scene()
    for number, shape in enumerate(shapes):
        scene.add_geometry(shape.mesh, geom_name=f"{number}", transform=shape.origin)
    return export_glb(scene, include_normals=True)
