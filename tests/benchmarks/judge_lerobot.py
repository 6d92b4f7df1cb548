"""LeRobot itself judges what keyphase writes: its dataset class, validator and RA-BC weights.

    python3.12 -m venv /tmp/lerobot && /tmp/lerobot/bin/pip install "lerobot[dataset]==0.6.1"
    python tests/benchmarks/judge_lerobot.py /tmp/lerobot/bin/python

LeRobot needs Python 3.12 and torch, so it has an environment of its own: this file makes a dataset
there with LeRobot's own writer, exports segments into copies of it here, plain and trimmed, and has
LeRobot read them there. It prints a line for each thing that was judged and exits with 1 where one
does not hold.
"""

import json
import subprocess
import sys
import tempfile
from pathlib import Path

EPISODES = 3
FPS = 50
RECIPE = """
time = {column = "timestamp", unit = "s"}
force = {columns = "observation.wrench[*]", unit = "N"}
wrench = {frame = "base", sign = 1}
[position]
columns = ["observation.state.x", "observation.state.y", "observation.state.z"]
unit = "m"
"""


def main(lerobot: str) -> int:
    """Make, export and judge."""
    sys.path.insert(0, str(Path(__file__).parents[1] / "writers"))
    from lerobot_exports import exported, trimmed

    with tempfile.TemporaryDirectory() as folder:
        source = Path(folder) / "source"
        _there(lerobot, "make", source)
        (Path(folder) / "recipe.toml").write_text(RECIPE)
        plain = exported(source, Path(folder) / "plain", "lerobot")
        short = trimmed(source, Path(folder) / "short")
        tasks = exported(source, Path(folder) / "tasks", "lerobot-tasks")
        return _there(lerobot, "judge", source, plain, short, tasks)


def _there(lerobot: str, what: str, *paths: Path) -> int:
    done = subprocess.run([lerobot, __file__, what, *map(str, paths)], timeout=1500)
    return done.returncode


def make(path: Path) -> None:
    """A dataset of three episodes by LeRobot's own writer, with a video."""
    import numpy as np
    from lerobot.datasets.lerobot_dataset import LeRobotDataset

    xyz = {"dtype": "float32", "shape": (3,), "names": ["x", "y", "z"]}
    features = {
        "observation.state": xyz,
        "observation.wrench": {**xyz, "names": None},
        "action": xyz,
        "observation.images.top": {
            "dtype": "video",
            "shape": (64, 64, 3),
            "names": ["height", "width", "channels"],
        },
    }
    dataset = LeRobotDataset.create("keyphase/judged", FPS, features, root=path, use_videos=True)
    for _ in range(EPISODES):
        for row in range(5 * FPS + 1):
            at = row / FPS
            height = np.interp(at, (0, 1, 2.5, 4, 5), (0.2, 0.1, 0.05, 0.05, 0.2))
            place = np.array([0.3 + 0.02 * at, 0, height], np.float32)
            force = np.array([0, 0, 8.0 if 1 < at < 4 else 0.0], np.float32)
            image = np.full((64, 64, 3), row, np.uint8)
            dataset.add_frame(
                {
                    "observation.state": place,
                    "observation.wrench": force,
                    "action": place,
                    "observation.images.top": image,
                    "task": "put it in",
                }
            )
        dataset.save_episode()
    dataset.finalize()


def judge(source: Path, plain: Path, short: Path, tasks: Path) -> int:
    """Everything that LeRobot says of the copies; how many things do not hold."""
    checks = {
        "the dataset class reads every row": lambda: rows_are_read(plain),
        "the image at each frame is the same": lambda: images_are_the_same(source, plain),
        "the validator finds no error": lambda: validator_agrees(plain),
        "RA-BC weighs every labelled frame": lambda: weights_are_there(plain),
        "SARM finds each stage": lambda: stages_are_found(plain),
        "a trimmed dataset has its own frames and images": lambda: trimmed_is_right(source, short),
        "each frame's task is its segment": lambda: tasks_are_segments(tasks),
    }
    failed = 0
    for name, check in checks.items():
        try:
            print(f"holds   {name}: {check()}")
        except Exception as error:
            failed += 1
            print(f"FAILED  {name}: {type(error).__name__}: {error}")
    return failed


def loaded(path: Path):
    from lerobot.datasets.lerobot_dataset import LeRobotDataset

    return LeRobotDataset("keyphase/judged", root=path)


def rows_are_read(path: Path) -> str:
    dataset = loaded(path)
    first, last = dataset[0], dataset[len(dataset) - 1]
    names = [r["content"] for r in first["language_persistent"] if r["style"] == "subtask"]
    assert names == ["approach", "insert", "wait", "retract"], names
    assert last["language_persistent"]
    assert last["language_events"] == []
    assert dataset[300]["language_persistent"] == []
    return f"{len(dataset)} frames, subtasks {names}"


def images_are_the_same(source: Path, path: Path) -> str:
    before, after = loaded(source), loaded(path)
    for row in (0, 120, 251, len(after) - 1):
        assert (before[row]["observation.images.top"] == after[row]["observation.images.top"]).all()
    return "4 frames compared"


def validator_agrees(path: Path) -> str:
    from lerobot.annotations.steerable_pipeline.reader import (
        EpisodeRecord,  # noqa: F401
        iter_episodes,
    )
    from lerobot.annotations.steerable_pipeline.staging import EpisodeStaging
    from lerobot.annotations.steerable_pipeline.validator import StagingValidator

    dataset = loaded(path)
    with tempfile.TemporaryDirectory() as folder:
        records = list(iter_episodes(path))
        for record in records:
            row = dataset.meta.episodes[record.episode_index]["dataset_from_index"]
            staging = EpisodeStaging(Path(folder), record.episode_index)
            rows = [dict(one) for one in dataset[row]["language_persistent"]]
            staging.write("plan", rows)
        report = StagingValidator().validate(records, Path(folder))
    assert report.ok, report.errors
    return report.summary()


def weights_are_there(path: Path) -> str:
    import torch

    try:
        from lerobot.rewards.sarm.rabc import RABCWeights
    except ImportError:
        from lerobot.policies.sarm.rabc import RABCWeights
    weights = RABCWeights(path / "sarm_progress.parquet", chunk_size=20, head_mode="sparse")
    index = torch.arange(0, 251)
    values, stats = weights.compute_batch_weights({"index": index})
    assert len(values) == 251
    assert torch.isfinite(values).all()
    still = values[150]
    assert still < values[60], "a dropped segment weighs no less than a kept one"
    return json.dumps({key: round(float(value), 3) for key, value in stats.items()})


def stages_are_found(path: Path) -> str:
    try:
        from lerobot.rewards.sarm.sarm_utils import find_stage_and_tau
    except ImportError:
        from lerobot.policies.sarm.sarm_utils import find_stage_and_tau
    shares = json.loads((path / "meta/temporal_proportions_sparse.json").read_text())
    row = loaded(path).meta.episodes[0]
    columns = (row[f"sparse_subtask_{which}"] for which in ("names", "start_frames", "end_frames"))
    names, starts, ends = map(list, columns)
    found = [
        find_stage_and_tau(frame, 251, names, starts, ends, list(shares), shares)[0]
        for frame in (0, 49, 50, 124, 160, 200, 250)
    ]
    assert found == [0, 0, 1, 1, 1, 2, 2], found
    return str(found)


def trimmed_is_right(source: Path, path: Path) -> str:
    before, after = loaded(source), loaded(path)
    assert len(after) == 150 + 251 + 150, len(after)
    for row, was in ((0, 50), (149, 199), (150, 251), (401, 552), (550, 701)):
        one, other = after[row], before[was]
        assert (one["observation.state"] == other["observation.state"]).all(), row
        difference = (one["observation.images.top"] - other["observation.images.top"]).abs().max()
        assert difference < 1e-6, (row, float(difference))
        assert int(one["index"]) == row
    return f"{len(after)} of {len(before)} frames"


def tasks_are_segments(path: Path) -> str:
    dataset = loaded(path)
    found = [dataset[row]["task"] for row in (0, 60, 130, 240, 300)]
    assert found == ["approach", "insert", "wait", "retract", "put it in"], found
    return str(found)


if __name__ == "__main__":
    if len(sys.argv) == 2:
        sys.exit(main(sys.argv[1]))
    do, *given = sys.argv[1:]
    if do == "make":
        make(Path(given[0]))
    else:
        sys.exit(judge(*map(Path, given)))
