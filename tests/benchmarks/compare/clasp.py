"""claspy, in its environment: recordings out, boundaries and processor seconds back."""

import json
import subprocess
from collections.abc import Mapping
from pathlib import Path

import numpy as np
from samples import samples
from sets import Recording

NAME = "ClaSP (claspy)"
WORKER = Path(__file__).with_name("clasp_worker.py")


def run(
    python: Path, recordings: Mapping[str, Recording], scratch: Path, limit_s: float
) -> dict[str, tuple[list[float], float]]:
    """For each key the times found and the seconds taken; without those that took too long."""
    scratch.mkdir(parents=True, exist_ok=True)
    names = {}
    for index, (key, recording) in enumerate(recordings.items()):
        taken = samples(recording.demonstration)
        features = taken.features(recording.truth.judged.what == "contact")
        names[key] = scratch / f"{index:04d}"
        np.savez(names[key].with_suffix(".npz"), features=features, time_s=taken.time_s)
    try:
        subprocess.run([python, WORKER, scratch], timeout=limit_s, check=True)
    except (subprocess.TimeoutExpired, subprocess.CalledProcessError) as error:
        print(f"claspy: {type(error).__name__}")
    answers = {}
    for key, path in names.items():
        if path.with_suffix(".json").exists():
            answer = json.loads(path.with_suffix(".json").read_text())
            answers[key] = (answer["times"], answer["seconds"])
    return answers
