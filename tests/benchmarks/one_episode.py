"""One episode of a file of several gigabytes: how much memory reading it takes, and how long.

    python tests/benchmarks/one_episode.py              # HDF5, Zarr, LeRobot v3 and MCAP
    python tests/benchmarks/one_episode.py --gigabytes 1 hdf5

Each file is written first, image streams included, then read in a process of its own. Peak memory
is compared with that of a file that holds the episode alone; ends with 1 where it is 50 MB more.
"""

import argparse
import json
import subprocess
import sys
import tempfile
from collections.abc import Callable
from pathlib import Path

import numpy as np

EPISODE_ROWS = 1000
MOST_MORE_MB = 50.0
IMAGE = (120, 160, 3)
RUN = """
import sys, time
from keyphase.readers import load_recipe, read
begun = time.perf_counter()
found = read(sys.argv[1], load_recipe(sys.argv[2]))
took = time.perf_counter() - begun
status = dict(line.split(":", 1) for line in open("/proc/self/status"))
peak = int(status["VmHWM"].split()[0]) / 1024
print(len(found), took, peak)
"""


def main() -> int:
    """Measure the formats asked for."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("formats", nargs="*", help=", ".join(WRITERS))
    parser.add_argument("--gigabytes", type=float, default=2.0)
    given = parser.parse_args()
    per_episode = EPISODE_ROWS * int(np.prod(IMAGE))
    episodes = max(2, int(given.gigabytes * 1e9 / per_episode))
    held = True
    print("| format | size | episodes | seconds | peak | of one episode alone |")
    print("|---|---|---|---|---|---|")
    for name in given.formats or WRITERS:
        with tempfile.TemporaryDirectory() as folder:
            write, recipe = WRITERS[name]
            (Path(folder) / "recipe.toml").write_text(recipe)
            many, one = Path(folder) / "many", Path(folder) / "one"
            many.mkdir()
            one.mkdir()
            large, small = write(many, episodes), write(one, 1)
            size = sum(f.stat().st_size for f in many.rglob("*") if f.is_file()) / 1e9
            rows, seconds, peak = measured(large, Path(folder) / "recipe.toml")
            _, _, alone = measured(small, Path(folder) / "recipe.toml")
        print(
            f"| {name} | {size:.2f} GB | {episodes} | {seconds:.2f} | {peak:.0f} MB | "
            f"{alone:.0f} MB |",
            flush=True,
        )
        held = held and rows == EPISODE_ROWS and peak - alone < MOST_MORE_MB
    return 0 if held else 1


def measured(path: Path, recipe: Path) -> tuple[int, float, float]:
    """Rows, seconds and peak memory [MB] of reading one recording in a fresh process."""
    command = [sys.executable, "-c", RUN, str(path), str(recipe)]
    said = subprocess.run(command, check=True, capture_output=True, text=True).stdout.split()
    return int(said[0]), float(said[1]), float(said[2])


def numbers(episode: int) -> dict[str, np.ndarray]:
    """What is read of an episode."""
    random = np.random.default_rng(episode)
    return {
        "time": np.arange(EPISODE_ROWS) / 50,
        "position": random.normal(0, 1e-3, (EPISODE_ROWS, 3)).cumsum(0),
        "force": random.normal(0, 1, (EPISODE_ROWS, 3)),
    }


def images(random: np.random.Generator) -> np.ndarray:
    """What is passed over: a camera's images, which pack badly."""
    return random.integers(0, 255, (EPISODE_ROWS, *IMAGE), dtype=np.uint8)


def hdf5(folder: Path, episodes: int) -> Path:
    """robomimic's layout."""
    import h5py

    seen = images(np.random.default_rng(0))
    with h5py.File(folder / "all.hdf5", "w") as file:
        for episode in range(episodes):
            group = file.create_group(f"data/demo_{episode}")
            for name, values in numbers(episode).items():
                group[f"obs/{name}"] = values
            group["obs/image"] = seen
    return folder / f"all.hdf5#demo_{episodes - 1}"


def zarr(folder: Path, episodes: int) -> Path:
    """A replay buffer."""
    import zarr as library

    rows = episodes * EPISODE_ROWS
    store = library.open_group(str(folder / "all.zarr"), mode="w")
    ends = np.arange(1, episodes + 1) * EPISODE_ROWS
    store.create_array("meta/episode_ends", data=ends)
    seen = images(np.random.default_rng(0))
    camera = store.create_array(
        "data/image", shape=(rows, *IMAGE), chunks=(100, *IMAGE), dtype="u1", compressors=None
    )
    arrays = {
        name: store.create_array(
            f"data/{name}", shape=(rows, *values.shape[1:]), chunks=(500, *values.shape[1:]),
            dtype="f8",
        )
        for name, values in numbers(0).items()
    }  # fmt: skip
    for episode in range(episodes):
        span = slice(episode * EPISODE_ROWS, (episode + 1) * EPISODE_ROWS)
        camera[span] = seen
        for name, values in numbers(episode).items():
            arrays[name][span] = values
    return folder / f"all.zarr#episode_{episodes - 1}"


def lerobot(folder: Path, episodes: int) -> Path:
    """v3.0 with images in the table, all episodes in one file and one row group."""
    import pyarrow as pa
    import pyarrow.parquet as pq

    path = folder / "dataset"
    (path / "data/chunk-000").mkdir(parents=True)
    (path / "meta/episodes/chunk-000").mkdir(parents=True)
    info = {
        "codebase_version": "v3.0",
        "total_episodes": episodes,
        "fps": 50,
        "features": {},
        "data_path": "data/chunk-{chunk_index:03d}/file-{file_index:03d}.parquet",
    }
    (path / "meta/info.json").write_text(json.dumps(info))
    seen = [image.tobytes() for image in images(np.random.default_rng(0))]
    writer = None
    for episode in range(episodes):
        values = numbers(episode)
        table = pa.table(
            {
                "timestamp": values["time"],
                "position": list(values["position"]),
                "force": list(values["force"]),
                "episode_index": np.full(EPISODE_ROWS, episode),
                "image": pa.array([{"bytes": one, "path": ""} for one in seen]),
            }
        )
        target = path / "data/chunk-000/file-000.parquet"
        writer = writer or pq.ParquetWriter(target, table.schema, compression="none")
        writer.write_table(table)
    assert writer is not None
    writer.close()
    where = {"episode_index": list(range(episodes))}
    where |= {"data/chunk_index": [0] * episodes, "data/file_index": [0] * episodes}
    pq.write_table(pa.table(where), path / "meta/episodes/chunk-000/file-000.parquet")
    return folder / f"dataset#episode_{episodes - 1}"


def mcap(folder: Path, episodes: int) -> Path:
    """One recording with the images of all of them beside it: a bag is not read in parts."""
    from rosbags.rosbag2 import StoragePlugin, Writer
    from rosbags.typesys import Stores, get_typestore

    store = get_typestore(Stores.ROS2_HUMBLE)
    kinds = store.types
    values = numbers(0)
    seen = images(np.random.default_rng(0))
    names = {
        "/pose": "geometry_msgs/msg/PointStamped",
        "/force": "geometry_msgs/msg/Vector3Stamped",
        "/camera": "sensor_msgs/msg/Image",
    }
    with Writer(folder / "bag", version=9, storage_plugin=StoragePlugin.MCAP) as writer:
        topics = {t: writer.add_connection(t, kind, typestore=store) for t, kind in names.items()}
        for row in range(EPISODE_ROWS):
            ns = int(1e18) + row * 20_000_000
            stamp = kinds["builtin_interfaces/msg/Time"](sec=ns // 10**9, nanosec=ns % 10**9)
            header = kinds["std_msgs/msg/Header"](stamp=stamp, frame_id="base")
            point = kinds["geometry_msgs/msg/Point"](*values["position"][row].tolist())
            force = kinds["geometry_msgs/msg/Vector3"](*values["force"][row].tolist())
            told = {
                "/pose": [kinds[names["/pose"]](header, point)],
                "/force": [kinds[names["/force"]](header, force)],
                "/camera": [
                    kinds[names["/camera"]](
                        header, IMAGE[0], IMAGE[1], "rgb8", 0, 3 * IMAGE[1], seen[row].reshape(-1)
                    )
                ]
                * episodes,
            }
            for topic, messages in told.items():
                for message in messages:
                    raw = store.serialize_cdr(message, names[topic])
                    writer.write(topics[topic], ns, raw)
    return folder / "bag"


PLACE = 'position = {columns = "%s", unit = "m"}\n'
FORCE = 'force = {columns = "%s", unit = "N"%s}\nwrench = {frame = "base", sign = 1}\n'


def recipe(time: str, position: str, force: str, clock: str = "") -> str:
    """How a file is read."""
    own = f', time = "{clock}"' if clock else ""
    return f'time = {{column = "{time}", unit = "s"}}\n' + PLACE % position + FORCE % (force, own)


WRITERS: dict[str, tuple[Callable[[Path, int], Path], str]] = {
    "hdf5": (hdf5, recipe("obs/time", "obs/position[*]", "obs/force[*]")),
    "zarr": (zarr, recipe("time", "position[*]", "force[*]")),
    "lerobot": (lerobot, recipe("timestamp", "position[*]", "force[*]")),
    "mcap": (mcap, recipe("/pose.stamp", "/pose.point.?", "/force.vector.?", "/force.stamp")),
}

if __name__ == "__main__":
    sys.exit(main())
