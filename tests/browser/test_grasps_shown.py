"""A grasp and a release are seen as such: their track, their marks, their names and reasons."""

from pathlib import Path

import numpy as np
from driver import LookAt

from keyphase import Demonstration
from keyphase.readers import save_npz


def test_grasp_and_release_are_marked_named_and_told(look_at: LookAt, tmp_path: Path) -> None:
    time = np.arange(0.0, 8.0, 0.01)
    height = np.interp(
        time, [1.0, 2.0, 3.2, 4.2, 5.2, 6.8, 7.6], [0.2, 0.0, 0.0, 0.2, 0.2, 0.2, 0.1]
    )
    position = np.stack([np.interp(time, [4.2, 5.2], [0.0, 0.3]), 0.0 * time, height], axis=1)
    opening = np.interp(time, [2.2, 2.6, 6.0, 6.3], [0.08, 0.03, 0.03, 0.08])
    path = tmp_path / "picked.npz"
    save_npz(Demonstration("picked", time, position, gripper=opening), path)
    page = look_at(path)
    marks = page.page.locator(".boundary[data-origin=gripper]")
    assert marks.count() == 2
    assert {"Grasp", "Release"} <= set(page.labels())
    assert page.row("gripper").height > 30
    assert page.page.locator("#status").get_by_text("gripper").is_visible()
    first = next(
        number
        for number, boundary in enumerate(page.document["boundaries"])
        if boundary["origin"] == "gripper"
    )
    page.page.evaluate(f"keyphase.store.set({{ explained: {first} }})")
    page.page.get_by_text("The gripper has closed here.").wait_for()
    page.picture("gripper")
