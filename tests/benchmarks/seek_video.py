"""Seeks in the videos of the page, in real Chromium: is the frame on the screen the one asked for?

    python tests/benchmarks/seek_video.py --seeks 1000

Three videos of 640x360 whose every frame carries its number lie beside the bundled recording of
Setup 1: AV1 and H.264 as LeRobot writes them (a key frame every second frame), and H.264 with a key
frame every 250. Each is sought at random, forth and back by single frames too; decoding is in
software.
"""

import argparse
import shutil
import sys
import tempfile
from pathlib import Path

import numpy as np

TESTS = Path(__file__).parents[1]
sys.path[:0] = [str(TESTS), str(TESTS / "browser")]

from chromium import chromium_browser  # noqa: E402
from driver import KeyphasePage  # noqa: E402
from footage import cameras, frames_at_random, name_beside, seek_frame  # noqa: E402

from keyphase.files.shipped import shipped  # noqa: E402
from keyphase.web.server import PageServer  # noqa: E402
from numbered_videos import (  # noqa: E402
    H264,
    H264_LIKE_LEROBOT,
    LIKE_LEROBOT,
    numbers_in,
    write_video,
)

CODECS = {"av1": LIKE_LEROBOT, "h264": H264_LIKE_LEROBOT, "h264_sparse": H264}
MOST_MS = 300.0


def sought(page: KeyphasePage, name: str, seeks: int) -> tuple[int, np.ndarray]:
    """Wrong frames, and how long each seek took [ms]."""
    camera = next(one for one in cameras(page) if one["name"] == name)
    page.page.evaluate("name => keyphase.store.set({ camerasChosen: [name] })", name)
    seek_frame(page, camera, 1)
    wrong, took = 0, []
    for frame in frames_at_random(camera, seeks, seed=0):
        number, milliseconds = seek_frame(page, camera, frame)
        wrong += number != frame
        took.append(milliseconds)
    return wrong, np.array(took)


def main() -> None:
    options = argparse.ArgumentParser(description=__doc__)
    options.add_argument("--seeks", type=int, default=1000, help="for each of the three")
    options.add_argument("--frames", type=int, default=200, help="of each video")
    chosen = options.parse_args()
    failed = False
    with tempfile.TemporaryDirectory() as folder, chromium_browser() as browser:
        recording = Path(shutil.copy(shipped("data") / "setup1.npz", folder))
        for name, codec in CODECS.items():
            path = name_beside(recording, name)
            write_video(path, chosen.frames, codec=codec, size=(640, 360))
            if numbers_in(path) != list(range(chosen.frames)):
                sys.exit(f"The encoder of {name} lost frames: nothing can be told of the page.")
        server = PageServer([recording], folder=Path(folder))
        page = KeyphasePage(browser.new_page(viewport={"width": 1440, "height": 900}))
        page.page.goto(server.link)
        page.wait_for_document()
        for name in CODECS:
            wrong, took = sought(page, name, chosen.seeks)
            p50, p95 = np.percentile(took, [50, 95])
            within = float((took < MOST_MS).mean())
            failed |= bool(wrong) or within < 0.95
            sys.stdout.write(
                f"{name}: {len(took)} seeks, {wrong} wrong frames, median {p50:.0f} ms, "
                f"95 % {p95:.0f} ms, {100 * within:.1f} % under {MOST_MS:g} ms\n"
            )
            sys.stdout.flush()
        page.close()
        server.stop()
    sys.exit(failed)


if __name__ == "__main__":
    main()
