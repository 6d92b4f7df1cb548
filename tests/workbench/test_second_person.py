"""Another person's segment files beside the recordings: counted, compared, taken over."""

import shutil
from pathlib import Path

import pytest
from two_pages import TalkingPage

from keyphase.cli import main
from keyphase.errors import LabelingError
from keyphase.files.shipped import shipped
from keyphase.workbench.workbench import Settings, Workbench


@pytest.fixture
def page(tmp_path):
    """A page on two recordings; another person has named the first segment of one otherwise."""
    paths = [
        Path(shutil.copy(shipped("data") / "synthetic_setup1.npz", tmp_path / f"{name}.npz"))
        for name in "ab"
    ]
    other = tmp_path / "other"
    other.mkdir()
    with pytest.raises(SystemExit):
        main(["segment", str(paths[0]), "--output", str(other)])
    file = other / "a.segments.json"
    text = file.read_text()
    label = next(line for line in text.splitlines() if '"label"' in line)
    file.write_text(text.replace(label, label.split(":")[0] + ': "Approach",', 1))
    workbench = Workbench(paths, Settings(folder=tmp_path, beside=other))
    yield TalkingPage(workbench, "one")
    workbench.close()


def differences(page):
    return {one["name"]: one["differences"] for one in page.told["recordings"]["items"]}


def test_where_two_differ_is_counted_compared_and_settled(page):
    page.open("a")
    page.wait_for(lambda: differences(page) == {"a": 1, "b": None})
    page.say("compare", page.told["document"], **{"with": "another person"})
    page.wait_for(lambda: page.told.get("comparison", {}).get("with") == "another person")
    told = page.told["comparison"]
    assert told["differs_s"] == [page.told["document"]["segments"][0]["start_s"]]
    assert (told["only_first_s"], told["only_second_s"]) == ([], [])
    page.say("take_over", page.told["document"], **{"from": "another person"})
    page.wait_for(lambda: differences(page)["a"] == 0)
    assert page.told["document"]["segments"][0]["label"] == "Approach"


def test_what_is_no_folder_is_refused(tmp_path):
    with pytest.raises(LabelingError, match="another person's segment files"):
        Workbench([], Settings(beside=tmp_path / "gone"))
