"""Write shells/*.glb, the robot's visible surfaces; needs the extra `shells`.

python static_robots/yumi/generate_shells.py [NAME ...] [--to FOLDER]
"""

import argparse
from pathlib import Path

import numpy as np
import trimesh
from shapes import SHELLS, Piece

FOLDER = Path(__file__).parent / "shells"
MATERIALS = {
    "shell": (194, 196, 195),
    "cap": (160, 164, 168),
    "joint": (48, 52, 58),
    "rubber": (30, 32, 35),
    "sensor": (36, 78, 128),
}
"""Colours, sRGB."""


def main() -> None:
    """Write the named shells, or all of them, and say how large they are."""
    parser = argparse.ArgumentParser(description="Write the YuMi's shells as GLB files.")
    parser.add_argument("names", nargs="*", choices=[*SHELLS, []], metavar="NAME")
    parser.add_argument("--to", type=Path, default=FOLDER, metavar="FOLDER")
    asked = parser.parse_args()
    asked.to.mkdir(exist_ok=True)
    for name in asked.names or SHELLS:
        path = asked.to / f"{name}.glb"
        path.write_bytes(glb(name, SHELLS[name]()))
        print(f"{path.name:12s} {path.stat().st_size / 1e3:7.1f} kB")
    together = sum(file.stat().st_size for file in asked.to.glob("*.glb"))
    print(f"together     {together / 1e3:7.1f} kB")


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
        name=name, baseColorFactor=_linear(MATERIALS[name]), metallicFactor=0.0, roughnessFactor=0.6
    )


def _linear(colour: tuple[int, int, int]) -> list[int]:
    # GLB holds linear light.
    share = np.array(colour) / 255
    light = np.where(share <= 0.04045, share / 12.92, ((share + 0.055) / 1.055) ** 2.4)
    return [*(int(value) for value in np.rint(light * 255)), 255]


if __name__ == "__main__":
    main()
