"""What stands below the segments: the other arm of a table, and labels that others made."""

from collections.abc import Iterator
from pathlib import Path

import h5py
import numpy as np
import pytest
from two_pages import TalkingPage

from keyphase.readers import find_recordings
from keyphase.workbench.workbench import Settings, Workbench
from two_arms import RECIPE


def opened(folder: Path) -> Workbench:
    found = [one.path for one in find_recordings([folder])]
    return Workbench(found, Settings(folder=folder, arms=("left", "right")))


@pytest.fixture
def arms(tmp_path: Path) -> Iterator[Workbench]:
    """The left arm stops twice, the right one once."""
    time = np.arange(400) / 50
    left = np.interp(time, [0, 2, 3, 5, 6, 8], [0, 0.3, 0.3, 0.5, 0.5, 0.7])
    right = np.interp(time, [0, 4, 5, 8], [0.2, 0.6, 0.6, 0.3])
    rows = [f"{t},{a:.5f},0,0.3,0.4,{b:.5f},0.3" for t, a, b in zip(time, left, right, strict=True)]
    (tmp_path / "run.csv").write_text("\n".join(["t,lx,ly,lz,rx,ry,rz", *rows, ""]))
    (tmp_path / "recipe.toml").write_text(RECIPE)
    made = opened(tmp_path)
    yield made
    made.close()


def test_the_other_arm_stands_below_with_its_own_segments(arms: Workbench) -> None:
    page = TalkingPage(arms, "page")
    document = page.document()
    assert document["name"] == "run#left"
    page.say("lanes", document)
    page.wait_for(lambda: "lanes" in page.told)
    (lane,) = page.told["lanes"]["lanes"]
    assert lane["name"] == "right"
    assert len(lane["segments"]) < len(document["segments"])
    assert lane["segments"][-1]["end_s"] == pytest.approx(document["end_s"])


def test_labels_in_the_file_are_compared_and_taken_over(tmp_path: Path) -> None:
    time = np.arange(200) / 20
    place = np.zeros((200, 3))
    place[:, 0] = np.interp(time, [0, 3, 4, 7, 10], [0, 0.3, 0.3, 0.6, 0.6])
    with h5py.File(tmp_path / "demo.hdf5", "w") as file:
        file["t"], file["p"] = time, place
        words = ["reach"] * 60 + ["hold"] * 20 + ["carry"] * 120
        file["primitive"] = np.array(words, dtype=h5py.string_dtype())
    (tmp_path / "demo.hdf5.recipe.toml").write_text(
        'time = {column = "t", unit = "s"}\nposition = {columns = "p[*]", unit = "m"}\n'
    )
    bench = opened(tmp_path)
    page = TalkingPage(bench, "page")
    page.say("compare", page.document(), **{"with": "given"})
    page.wait_for(lambda: page.told.get("comparison", {}).get("with") == "given")
    assert page.told["comparison"]["labels"] == ["reach", "hold", "carry"]
    page.say("take_over", page.document(), **{"from": "given"})
    page.wait_for(
        lambda: (
            [one["label"] for one in page.documents[-1]["segments"]] == ["reach", "hold", "carry"]
        )
    )
    bench.close()
