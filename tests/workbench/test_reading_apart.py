"""Reading in a process of its own: the same recording, and a server that a file cannot end."""

import os
from collections.abc import Iterator
from pathlib import Path

import h5py
import numpy as np
import pytest

from keyphase.errors import DemonstrationError, RecipeError, RequestError
from keyphase.readers import FOLDER_RECIPE, read
from keyphase.workbench.apart.apart import ReadingApart
from keyphase.workbench.importing.importing import Importing
from keyphase.workbench.uploads import Upload

RECIPE = "time = {rate_hz = 100}\nposition = {columns = 'tool[*]', unit = 'm'}"
BREAKS_OFF = "import os\nos.abort()\n"


@pytest.fixture
def reading() -> Iterator[ReadingApart]:
    one = ReadingApart()
    yield one
    one.close()


@pytest.fixture
def recording(tmp_path: Path) -> Path:
    path = tmp_path / "run.h5"
    with h5py.File(path, "w") as file:
        file["tool"] = np.random.default_rng(0).normal(size=(300, 3)) * 0.01
    (tmp_path / FOLDER_RECIPE).write_text(RECIPE)
    return path


@pytest.fixture
def library_that_ends_its_process(
    tmp_path_factory: pytest.TempPathFactory, monkeypatch: pytest.MonkeyPatch
) -> None:
    """What the reading process imports as h5py, which here is loaded already."""
    folder = tmp_path_factory.mktemp("library")
    (folder / "h5py.py").write_text(BREAKS_OFF)
    # keyphase's own folder comes before it, and holds no h5py.
    monkeypatch.setenv("PYTHONPATH", f"{folder}{os.pathsep}{os.environ.get('PYTHONPATH', '')}")


def test_what_is_read_apart_is_what_is_read_here(reading: ReadingApart, recording: Path) -> None:
    apart, here = reading.call(recording, read, recording), read(recording)
    np.testing.assert_array_equal(apart.position_m, here.position_m)
    assert (apart.source, apart.notices) == (here.source, here.notices)
    assert not apart.position_m.flags.writeable
    (recording.parent / FOLDER_RECIPE).unlink()
    with pytest.raises(RecipeError, match="a recipe must say what they are"):
        reading.call(recording, read, recording)


def test_a_process_that_ended_is_told_of_and_the_next_file_is_read(
    reading: ReadingApart, recording: Path
) -> None:
    with pytest.raises(DemonstrationError, match=r"run\.h5: .* broke off over it"):
        reading.call(recording, os.abort)
    assert len(reading.call(recording, read, recording)) == 300


def test_nothing_is_read_once_it_is_closed(reading: ReadingApart, recording: Path) -> None:
    reading.close()
    with pytest.raises(DemonstrationError, match="keyphase is being stopped"):
        reading.call(recording, read, recording)


@pytest.mark.usefixtures("library_that_ends_its_process")
def test_a_file_that_ends_what_reads_it_is_refused_when_it_is_sent_opened_or_described(
    reading: ReadingApart, recording: Path
) -> None:
    sent = Upload(recording.parent, "sent.h5", recording.stat().st_size)
    sent.write(recording.read_bytes())
    with pytest.raises(RequestError, match=r"sent\.h5: .* broke off over it"):
        sent.finish(calls=reading.call)
    for asks in (lambda: reading.call(recording, read, recording),
                 lambda: Importing(reading.call).ask_about(recording)):  # fmt: skip
        with pytest.raises(DemonstrationError, match="broke off over it"):
            asks()
