"""Sound files as laboratories write them by themselves: other names, containers, sparse rows."""

import json
from pathlib import Path

import h5py
import numpy as np
import pyarrow as pa
import pyarrow.parquet as pq
import scipy.io
from google.protobuf import descriptor_pb2, descriptor_pool, message_factory
from mcap.writer import Writer

from fuzzing.sound import FORCE, PLACE, ROWS, WXYZ, T

PLACED = """
time = {column = "%s", unit = "s", from_zero = true}
position = {columns = "%s", unit = "m"}
force = {columns = "%s", unit = "N"%s}
wrench = {frame = "base", sign = 1}
"""

SECTIONS = """
[table]
lines_after_header = 1
demonstration = "demo"
[time]
column = "t"
unit = "s"
[position]
columns = ["x", "y", "z"]
unit = "mm"
[orientation]
kind = "rot6d"
columns = "r?"
[force]
columns = ["fx", "fy", "fz"]
unit = "N"
time = "t_force"
offset = [0.1, 0.0, 0.0]
[wrench]
frame = "tool"
sign = -1
[gripper]
columns = ["left_finger", "right_finger"]
unit = "mm"
[channels]
current = "i_1"
button = {column = "di", time = "t_force"}
[events]
column = "note"
[rows]
empty = "leave_out"
outliers = "drop"
missing = 0
"""


def archive(folder: Path) -> Path:
    """An archive with names of its own."""
    (folder / "run.npz.recipe.toml").write_text(PLACED % ("t", "pos[*]", "f[*]", ""))
    np.savez(folder / "run.npz", t=T, pos=PLACE, f=FORCE)
    return folder / "run.npz"


def matlab_73(folder: Path) -> Path:
    """HDF5 behind 512 bytes of MATLAB's."""
    path = folder / "run.mat"
    (folder / "run.mat.recipe.toml").write_text(PLACED % ("log.t", "log.pos[*]", "log.f[*]", ""))
    with h5py.File(path, "w", userblock_size=512) as file:
        for name, values in {"t": T[:, None], "pos": PLACE, "f": FORCE}.items():
            stored = file.create_dataset(f"log/{name}", data=values.T, compression="gzip")
            stored.attrs["MATLAB_class"] = np.bytes_("double")
    with path.open("r+b") as stream:
        stream.write(b"MATLAB 7.3 MAT-file, Platform: GLNXA64".ljust(124) + b"\x00\x02IM")
    return path


def parquet(folder: Path) -> Path:
    """Columns, one of dates and one of lists."""
    (folder / "run.parquet.recipe.toml").write_text(PLACED % ("t", "pos[*]", "f[*]", ""))
    stamps = pa.array(10**18 + np.round(1e9 * T).astype(np.int64), pa.timestamp("ns"))
    columns = {"t": stamps, "pos": list(PLACE), "f": list(FORCE)}
    pq.write_table(pa.table(columns), folder / "run.parquet")
    return folder / "run.parquet"


def json_messages(folder: Path) -> Path:
    """MCAP without ROS, two topics of JSON."""
    recipe = PLACED % ("/pose.log_time", "/pose.pos.?", "/f.f[*]", ', time = "/f.log_time"')
    (folder / "run.mcap.recipe.toml").write_text(recipe)
    with (folder / "run.mcap").open("wb") as stream:
        writer = Writer(stream)
        writer.start(profile="", library="lab")
        schema = writer.register_schema("any", "jsonschema", b"{}")
        pose, force = (writer.register_channel(t, "json", schema) for t in ("/pose", "/f"))
        for row in range(ROWS):
            ns = 10**18 + row * 20_000_000
            place = {"pos": dict(zip("xyz", PLACE[row].tolist(), strict=True))}
            writer.add_message(pose, ns, json.dumps(place).encode(), ns)
            writer.add_message(force, ns, json.dumps({"f": FORCE[row].tolist()}).encode(), ns)
        writer.finish()
    return folder / "run.mcap"


def protobuf_messages(folder: Path) -> Path:
    """MCAP without ROS, one topic of Protobuf."""
    recipe = PLACED % ("/state.log_time", "/state.pos[*]", "/state.f[*]", "")
    (folder / "run.mcap.recipe.toml").write_text(recipe)
    file = descriptor_pb2.FileDescriptorProto(name="lab.proto", package="lab", syntax="proto3")
    state = file.message_type.add(name="State")
    for number, name in enumerate(("pos", "f")):
        state.field.add(name=name, number=number + 1, type=1, label=3)
    pool = descriptor_pool.DescriptorPool()
    pool.Add(file)
    kind = message_factory.GetMessageClass(pool.FindMessageTypeByName("lab.State"))
    described = descriptor_pb2.FileDescriptorSet(file=[file]).SerializeToString()
    with (folder / "run.mcap").open("wb") as stream:
        writer = Writer(stream)
        writer.start(profile="", library="lab")
        schema = writer.register_schema("lab.State", "protobuf", described)
        channel = writer.register_channel("/state", "protobuf", schema)
        for row in range(ROWS):
            ns = 10**18 + row * 20_000_000
            said = kind(pos=PLACE[row].tolist(), f=FORCE[row].tolist())
            writer.add_message(channel, ns, said.SerializeToString(), ns)
        writer.finish()
    return folder / "run.mcap"


def sections(folder: Path) -> Path:
    """Two demonstrations in one table with every section a recipe can have, and empty cells."""
    (folder / "run.csv.recipe.toml").write_text(SECTIONS)
    turns = np.tile([1.0, 0.0, 0.0, 0.0, 1.0, 0.0], (ROWS, 1))
    names = "demo,t,x,y,z,r0,r1,r2,r3,r4,r5,t_force,fx,fy,fz,left_finger,right_finger,i_1,di,note"
    lines = [names, names.replace("x", "mm").replace("t", "s")]
    for demo in ("first", "second"):
        for row in range(ROWS):
            force = FORCE[row] if row % 2 else [np.nan] * 3
            values = [T[row], *(1000 * PLACE[row] + 1), *turns[row], T[row] + 0.001, *force]
            cells = [f"{value:.6g}" if np.isfinite(value) else "" for value in values]
            tail = ["20", "-20", "0.5", str(row % 7 > 3), "press" if row > 30 else ""]
            tail[3] = str(int(row % 7 > 3))
            lines.append(",".join([demo, *cells, *tail]))
    (folder / "run.csv").write_text("\n".join([*lines, ""]))
    return folder / "run.csv"


def unknown_table(folder: Path) -> Path:
    """A table nobody has described."""
    columns = np.column_stack([1000 * T, 1000 * PLACE, WXYZ, FORCE])
    header = "t [ms];x [mm];y [mm];z [mm];qw;qx;qy;qz;Fx;Fy;Fz"
    np.savetxt(folder / "log.csv", columns, "%.6g", ";", header=header, comments="")
    return folder / "log.csv"


BESIDE = """
time = {column = "t", unit = "s"}
position = {columns = ["x", "y", "z"], unit = "m"}
force = {columns = "f*", unit = "N", clock_offset_s = -0.02}
wrench = {frame = "base", sign = 1}
wrench_file = {path = "{stem}_ft.%s", column = "t", unit = "s"}
"""


def _with_wrench(folder: Path, ending: str) -> Path:
    (folder / "run.csv.recipe.toml").write_text(BESIDE % ending)
    rows = [f"{t:.4f},{x:.5f},{y:.5f},{z:.5f}" for t, (x, y, z) in zip(T, PLACE, strict=True)]
    (folder / "run.csv").write_text("\n".join(["t,x,y,z", *rows]) + "\n")
    return folder / "run.csv"


def wrench_table(folder: Path) -> Path:
    """A wrench in a table of its own."""
    rows = [f"{t:.4f},{x:.4f},{y:.4f},{z:.4f}" for t, (x, y, z) in zip(T, FORCE, strict=True)]
    (folder / "run_ft.csv").write_text("\n".join(["t,fx,fy,fz", *rows]) + "\n")
    return _with_wrench(folder, "csv")


def wrench_hdf5(folder: Path) -> Path:
    """A wrench in an HDF5 file of its own."""
    with h5py.File(folder / "run_ft.h5", "w") as file:
        file["t"], file["f"] = T, FORCE
    return _with_wrench(folder, "h5")


def cells_of_matlab(folder: Path) -> Path:
    """Two recordings as the cells of one variable."""
    (folder / "run.mat.recipe.toml").write_text(PLACED % ("t", "pos[*]", "f[*]", ""))
    cells = np.empty((1, 2), dtype=object)
    cells[0, 0] = cells[0, 1] = {"t": T, "pos": PLACE, "f": FORCE}
    scipy.io.savemat(folder / "run.mat", {"demos": cells})
    return folder / "run.mat"


def list_cells(folder: Path) -> Path:
    """A table whose cells hold lists."""
    (folder / "run.csv.recipe.toml").write_text(PLACED % ("t", "pos[*]", "f[*]", ""))
    rows = [
        f'{t:.4f},"{p.tolist()}","{f.tolist()}"' for t, p, f in zip(T, PLACE, FORCE, strict=True)
    ]
    (folder / "run.csv").write_text("\n".join(["t,pos,f", *rows]) + "\n")
    return folder / "run.csv"
