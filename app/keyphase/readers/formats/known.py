"""Which format a file or folder is, by its first bytes or by what lies in it."""

from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path

from keyphase.files.reading import first_bytes
from keyphase.readers.formats.array_table import ArrayTable
from keyphase.readers.formats.bags import (
    MCAP_MAGIC,
    ROS1_MAGIC,
    is_ros2_bag,
    table_of_bag,
)
from keyphase.readers.formats.hdf5 import MAGIC as HDF5_MAGIC
from keyphase.readers.formats.hdf5 import names_in_hdf5, parts_of_hdf5, table_of_hdf5
from keyphase.readers.formats.lerobot import (
    is_lerobot,
    names_in_lerobot,
    parts_of_lerobot,
    table_of_lerobot,
)
from keyphase.readers.formats.matlab import (
    MAT_MAGIC,
    NPY_MAGIC,
    parts_of_mat,
    table_of_mat,
    table_of_npy,
)
from keyphase.readers.formats.matlab73 import MAGIC as MAT73_MAGIC
from keyphase.readers.formats.matlab73 import table_of_mat73
from keyphase.readers.formats.numpy_archive import is_foreign_archive, table_of_npz
from keyphase.readers.formats.parquet import MAGIC as PARQUET_MAGIC
from keyphase.readers.formats.parquet import table_of_parquet
from keyphase.readers.formats.zarr_store import is_zarr, names_in_zarr, parts_of_zarr, table_of_zarr


def _no_names(_path: Path, _part: str | None) -> tuple[str, ...]:
    return ()


def _one(_path: Path) -> tuple[str, ...]:
    return ()


@dataclass(frozen=True)
class Format:
    """A format keyphase reads as columns.

    example a path of one recording
    extra   what installs it: pip install "keyphase[EXTRA]"; "" where nothing is needed
    parts   the recordings in a file of many, or none where the file is one
    table   the columns of one recording: path, part and limit of memory in bytes
    names   what its columns are called, where that is known without reading their numbers
    """

    name: str
    extra: str
    endings: str
    example: str
    parts: Callable[[Path], tuple[str, ...]]
    table: Callable[[Path, str | None, int], ArrayTable]
    names: Callable[[Path, str | None], tuple[str, ...]] = _no_names


LEROBOT = Format(
    "LeRobot v2.1, v3.0",
    "lerobot",
    "a folder",
    "pick_and_place#episode_3",
    parts_of_lerobot,
    table_of_lerobot,
    names_in_lerobot,
)
HDF5 = Format(
    "HDF5",
    "hdf5",
    ".hdf5 .h5",
    "low_dim.hdf5#demo_3",
    parts_of_hdf5,
    table_of_hdf5,
    names_in_hdf5,
)
ZARR = Format(
    "Zarr",
    "zarr",
    ".zarr .zarr.zip",
    "buffer.zarr#episode_0",
    parts_of_zarr,
    table_of_zarr,
    names_in_zarr,
)
BAG = Format(
    "ROS 1 and ROS 2 bag, MCAP", "ros", ".bag .mcap, a folder", "run.bag", _one, table_of_bag
)
MAT = Format("MATLAB 5 to 7.2", "", ".mat", "run.mat", parts_of_mat, table_of_mat)
MAT73 = Format("MATLAB 7.3", "hdf5", ".mat", "run.mat", _one, table_of_mat73)
NPY = Format("NumPy array", "", ".npy", "run.npy", _one, table_of_npy)
NPZ = Format("NumPy archive with other names", "", ".npz", "run.npz", _one, table_of_npz)
PARQUET = Format("Parquet", "lerobot", ".parquet", "run.parquet", _one, table_of_parquet)

FORMATS = (LEROBOT, HDF5, ZARR, BAG, MAT, MAT73, NPY, NPZ, PARQUET)

_MAGIC = (
    (HDF5_MAGIC, HDF5),
    (ROS1_MAGIC, BAG),
    (MCAP_MAGIC, BAG),
    (MAT_MAGIC, MAT),
    (MAT73_MAGIC, MAT73),
    (PARQUET_MAGIC, PARQUET),
    (NPY_MAGIC, NPY),
)
MAX_MAGIC_LENGTH = max(len(magic) for magic, _ in _MAGIC)


def format_of(path: Path) -> Format | None:
    """The format of a file or folder, or None where it is none of these.

    No more of it is read than its first bytes or its folder's names.
    """
    try:
        if path.is_dir():
            return _folder_format(path)
        if is_zarr(path):
            return ZARR
        if is_foreign_archive(path):
            return NPZ
        head = first_bytes(path, MAX_MAGIC_LENGTH)
    except (OSError, ValueError):
        return None
    return next((form for magic, form in _MAGIC if head.startswith(magic)), None)


def _folder_format(path: Path) -> Format | None:
    if is_lerobot(path):
        return LEROBOT
    if is_zarr(path):
        return ZARR
    return BAG if is_ros2_bag(path) else None
