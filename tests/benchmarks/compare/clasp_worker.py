"""Runs in an environment of its own, because claspy needs older packages than keyphase.

    python clasp_worker.py FOLDER

reads FOLDER/*.npz (`features` (N, d), `time_s` (N,)) and writes FOLDER/*.json: times and seconds.
"""

import json
import sys
import time
from pathlib import Path

import numpy as np
from claspy.segmentation import BinaryClaSPSegmentation


def main() -> None:
    """Segment all, the first one twice: it compiles."""
    warm = True
    for path in sorted(Path(sys.argv[1]).glob("*.npz")):
        with np.load(path) as file:
            features, times = file["features"], file["time_s"]
        if warm:
            found(features[:500])
            warm = False
        start = time.process_time()
        try:
            changes = found(features)
        except Exception as error:
            print(f"{path.stem}: {error}", file=sys.stderr)
            changes = []
        taken = time.process_time() - start
        answer = {"times": [float(times[i]) for i in changes], "seconds": taken}
        path.with_suffix(".json").write_text(json.dumps(answer))


def found(features):
    """Indices of change points."""
    return BinaryClaSPSegmentation(n_jobs=1).fit_predict(np.ascontiguousarray(features))


if __name__ == "__main__":
    main()
