"""How many recordings of real robots replay to success in the world made from them.

python tests/benchmarks/real_replays.py FOLDER… [--only S08 S13] [--pictures DIR]

A folder is a set. A recording counts if it has force, and if its force does not help the motion
(its sign and frame can be what they say). What fails is said; with --pictures the path and the
force of one recording of each set are drawn, as demonstrated and as replayed.
"""

import argparse
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path
from textwrap import wrap

import numpy as np

from keyphase.demonstration import Demonstration
from keyphase.errors import KeyphaseError
from keyphase.labeling.label import label
from keyphase.readers import find_recordings, read
from keyphase.segmentation import Segmenter
from keyphase.simulation.choosing import RECORDING, cell_for, met_by
from keyphase.simulation.recorded.cell import RecordedCell
from keyphase.simulation.replay.replay import run
from keyphase.simulation.replay.result import ReplayResult
from keyphase.skills.library import skills_of


@dataclass(frozen=True, eq=False)
class Replayed:
    """What became of one recording, and what it met: the recording without the sensor's offset."""

    name: str
    doubtful: bool
    outcome: str
    result: ReplayResult | None = None
    met: Demonstration | None = None


def replayed(path: Path) -> Replayed | None:
    """One recording with its plan as it is proposed; None without force."""
    demonstration = read(path)
    if demonstration.force_N is None:
        return None
    segmenter = Segmenter(demonstration)
    labeling = label(segmenter.segment(), {}, segmenter.segment_between)
    cell = cell_for(demonstration, RECORDING)
    assert isinstance(cell, RecordedCell)
    met = met_by(demonstration, cell)
    try:
        skills = skills_of(met, [labeling.segments[entry.segment] for entry in labeling.plan])
        result = run(cell.build(), skills, met)
    except KeyphaseError as error:
        return Replayed(path.stem, cell.doubt is not None, str(error))
    return Replayed(path.stem, cell.doubt is not None, result.outcome(), result, met)


def draw(folder: Path, name: str, one: Replayed) -> None:
    """Path and force over time, demonstrated in grey and replayed in colour."""
    import matplotlib

    matplotlib.use("Agg")
    from matplotlib import pyplot

    assert one.result is not None
    assert one.met is not None
    demonstration, states, felt = one.met, one.result.states, one.met.force_N
    assert felt is not None
    at = [(s.demonstrated_s, s.sample) for s in states if s.demonstrated_s is not None]
    time = np.array([t for t, _ in at])
    figure, (path, force) = pyplot.subplots(2, 1, figsize=(11, 6), sharex=True)
    zero = demonstration.position_m[0]
    for axis, color in enumerate(("#e03131", "#2f9e44", "#1971c2")):
        path.plot(
            demonstration.time_s, 1e3 * (demonstration.position_m - zero)[:, axis], color="#adb5bd"
        )
        there = 1e3 * np.array([s.position_m[axis] - zero[axis] for _, s in at])
        path.plot(time, there, ".", markersize=1.5, color=color, label="xyz"[axis])
    demonstrated = np.linalg.norm(felt, axis=1)
    force.plot(demonstration.time_s, demonstrated, color="#adb5bd", label="demonstrated")
    measured = [float(np.linalg.norm(s.force_N)) for _, s in at]
    force.plot(time, measured, ".", markersize=1.5, color="#e8590c", label="replayed")
    path.set_ylabel("position, mm")
    force.set_ylabel("force, N")
    force.set_xlabel("moment of the demonstration, s")
    path.set_title("\n".join(wrap(f"{name}, {one.name}: {one.outcome}", 100)))
    for axes in (path, force):
        axes.legend(loc="upper left", bbox_to_anchor=(1.0, 1.0), markerscale=6, frameon=False)
    figure.tight_layout()
    folder.mkdir(parents=True, exist_ok=True)
    figure.savefig(folder / f"replayed_{name}.png", dpi=80)
    pyplot.close(figure)


def of_set(folder: Path, only: list[str], pictures: Path | None) -> Iterator[Replayed]:
    """Every recording of a set, told as it comes; the first is drawn."""
    drawn = False
    for found in find_recordings([folder]):
        if only and not any(part in found.path.stem for part in only):
            continue
        one = replayed(found.path)
        if one is None:
            continue
        print(f"{folder.name:20} {one.name:24} {one.outcome}", flush=True)
        if pictures and not drawn and one.result is not None:
            draw(pictures, folder.name, one)
            drawn = True
        yield one


def main() -> None:
    parser = argparse.ArgumentParser(description=(__doc__ or "").splitlines()[0])
    parser.add_argument("folders", type=Path, nargs="+")
    parser.add_argument("--only", nargs="*", default=[])
    parser.add_argument("--pictures", type=Path)
    asked = parser.parse_args()
    every: list[Replayed] = []
    table = []
    for folder in asked.folders:
        of_it = list(of_set(folder, asked.only, asked.pictures))
        sound = [one for one in of_it if not one.doubtful]
        good = sum(one.outcome == "success" for one in sound)
        table.append(f"{folder.name:20} {good:3} of {len(sound):3} ({len(of_it)} with force)")
        every += sound
    good = sum(one.outcome == "success" for one in every)
    print(*table, f"{'sum':20} {good:3} of {len(every):3}", sep="\n")


if __name__ == "__main__":
    main()
