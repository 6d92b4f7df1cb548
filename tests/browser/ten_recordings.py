"""Ten recordings of one task, each at a pace, in a place and with noise of its own.

Each is the bundled demonstration, so that it is known where their phases end.
"""

from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from keyphase.demonstration import Demonstration
from keyphase.files.shipped import shipped
from keyphase.labeling.edits import Done, DropIdle, Label
from keyphase.labeling.label import label
from keyphase.labeling.storage.journal import Journal
from keyphase.readers import read, save_npz
from keyphase.segmentation import Segmenter
from keyphase.workbench.desks.folder import Folder

NAMES = ("Reach", "Lower", "Slide")
TURNED = (1, 5)
"""These have the other sign of force."""

SHAKEN = 9
"""In this one something shakes the sensor before the first contact, which is unsure then."""

_CONTACT_S, _SHAKEN_S, _SHAKEN_N = 3.3, 0.7, 4.5
_RATE_HZ = 125.0


def paced(
    pace: float, uneven_s: float, time_s: NDArray[np.float64], whole_s: float
) -> NDArray[np.float64]:
    """When it happens at this pace, which is not the same all the way."""
    return pace * time_s + uneven_s * np.sin(2 * np.pi * time_s / whole_s)


def ten_recordings(folder: Path) -> list[tuple[float, float]]:
    """Ten recordings; the pace of each and how uneven it is."""
    random = np.random.default_rng(4)
    base = read(shipped("data") / "setup1.npz")
    assert base.force_N is not None
    began = base.time_s - base.time_s[0]
    paces = [
        (1.0, 0.0),
        *((random.uniform(0.8, 1.3), random.uniform(-0.2, 0.2)) for _ in "123456789"),
    ]
    for number, (pace, uneven) in enumerate(paces):
        when = paced(pace, uneven, began, began[-1])
        time = np.arange(0.0, when[-1], 1 / _RATE_HZ)
        position, force = (
            np.stack([np.interp(time, when, column) for column in values.T], axis=1)
            for values in (base.position_m, base.force_N)
        )
        force = (-1 if number in TURNED else 1) * random.uniform(0.3, 1.2) * force
        noise_N = np.full((len(time), 1), 0.02)
        if number == SHAKEN:
            contact_s = paced(pace, uneven, np.array(_CONTACT_S), began[-1])
            noise_N[np.abs(time - contact_s) < _SHAKEN_S] = _SHAKEN_N
        recording = Demonstration(
            f"{number:02d}",
            time,
            position + random.normal(0.0, 0.02, 3),
            force_N=force + random.normal(0.0, 1.0, force.shape) * noise_N,
        )
        save_npz(recording, folder / f"take_{number:02d}.npz")
    return paces


def finish(path: Path) -> None:
    """Name the kept segments of a recording, drop the idle ones and mark it as done."""
    with_journal = Journal(read(path))
    segmentation = Segmenter(with_journal.document.demonstration).segment()
    kept = [one for one in segmentation.segments if not one.idle]
    names = [Label(one.start_s + 0.1, name) for one, name in zip(kept, NAMES, strict=True)]
    for edit in (*names, DropIdle(), Done()):
        document = with_journal.document
        with_journal.save(document.apply(edit, label(segmentation, document.edits)))
    document = with_journal.document
    Folder(path.parent).show_task(label(segmentation, document.edits))
    with_journal.close()
