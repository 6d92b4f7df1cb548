"""Write shells/*.glb, the robot's visible surfaces; needs the extra `shells`.

python static_robots/yumi/generate_shells.py [NAME ...]
"""

import sys
from pathlib import Path

import trimesh
from shapes import SHELLS, Piece

FOLDER = Path(__file__).parent / "shells"
MATERIALS = {
    "shell": (222, 224, 223),
    "cap": (190, 194, 198),
    "joint": (58, 62, 68),
    "rubber": (36, 38, 41),
    "sensor": (36, 78, 128),
}
"""Colours, sRGB."""


def main(names: list[str]) -> None:
    """Write the named shells, or all of them, and say how large they are."""
    FOLDER.mkdir(exist_ok=True)
    for name in names or list(SHELLS):
        path = FOLDER / f"{name}.glb"
        path.write_bytes(glb(name, SHELLS[name]()))
        print(f"{path.name:12s} {path.stat().st_size / 1e3:7.1f} kB")
    print(f"together     {sum(f.stat().st_size for f in FOLDER.glob('*.glb')) / 1e3:7.1f} kB")


def glb(name: str, pieces: list[Piece]) -> bytes:
    """One GLB file with a mesh and a material for each piece."""
    scene = trimesh.Scene()
    for number, piece in enumerate(pieces):
        mesh = piece.mesh
        mesh.visual = trimesh.visual.TextureVisuals(material=_material(piece.material))
        scene.add_geometry(mesh, node_name=f"{name}_{number}", geom_name=f"{name}_{number}")
    return bytes(trimesh.exchange.gltf.export_glb(scene, include_normals=True))


def _material(name: str) -> trimesh.visual.material.PBRMaterial:
    return trimesh.visual.material.PBRMaterial(
        name=name, baseColorFactor=(*MATERIALS[name], 255), metallicFactor=0.05, roughnessFactor=0.5
    )


if __name__ == "__main__":
    main(sys.argv[1:])
