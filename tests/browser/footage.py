"""What the page shows of cameras, as tests ask for it."""

import random
from pathlib import Path
from typing import Any

from driver import KeyphasePage

from numbered_videos import READ_NUMBER

_SHOWN = f"""async ([camera, frame]) => {{
  const seen = () => document.querySelector(`[data-camera="${{camera}}"] video`);
  const began = performance.now();
  while (Number(seen()?.dataset.frame ?? NaN) !== frame) {{
    if (performance.now() - began > 20_000) return null;
    await new Promise((done) => setTimeout(done, 1));
  }}
  const took = performance.now() - began;
  return {{ number: ({READ_NUMBER})(seen()), took }};
}}"""


def seek_frame(page: KeyphasePage, camera: dict[str, Any], frame: int) -> tuple[int, float]:
    """The number on the screen once the page says that frame is shown, and after how long [ms]."""
    time_s = camera["begins_s"] + offset_of(page, camera) + (frame + 0.5) / camera["fps"]
    page.page.evaluate("time => keyphase.actions.seek(time)", time_s)
    seen = page.page.evaluate(_SHOWN, [camera["name"], frame])
    assert seen, f"frame {frame} of {camera['name']} was never shown"
    return seen["number"], seen["took"]


def offset_of(page: KeyphasePage, camera: dict[str, Any]) -> float:
    """How much later a person has laid it [s]."""
    return page.document["camera_offsets"].get(camera["name"], 0.0)


def cameras(page: KeyphasePage) -> list[dict[str, Any]]:
    """The cameras of the recording, once they are found and one is seen."""
    page.until("keyphase.state.cameras")
    page.until("document.querySelector('.camera video')?.readyState >= 2")
    return page.state("cameras")["cameras"]


def frames_at_random(camera: dict[str, Any], count: int, seed: int) -> list[int]:
    """Frames here and there, each followed now and then by its neighbours."""
    chance, frames = random.Random(seed), list[int]()
    while len(frames) < count:
        frame = chance.randrange(camera["frames"] - 1)
        frames += [frame, frame + 1, frame] if chance.random() < 0.3 else [frame]
    return frames[:count]


def name_beside(recording: Path, camera: str) -> Path:
    """Where the video of a camera lies."""
    return recording.with_name(f"{recording.stem}_{camera}.mp4")
