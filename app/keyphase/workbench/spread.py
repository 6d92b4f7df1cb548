"""What parameters would do to all recordings of a folder, looked into one after another."""

from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace

from keyphase.errors import KeyphaseError
from keyphase.labeling.spreading import Change
from keyphase.segmentation import Parameters
from keyphase.workbench.desks.library import Library
from keyphase.workbench.recordings import Recording
from keyphase.workbench.tasks import Tasks


@dataclass(frozen=True)
class SpreadItem:
    """What would become of one recording; without a change, why that cannot be said."""

    recording: Recording
    change: Change | None = None
    error: str | None = None


@dataclass(frozen=True)
class Spread:
    """What is known of a look; each look has a number of its own."""

    look: int
    recordings: tuple[Recording, ...]
    items: tuple[SpreadItem, ...] = ()


@dataclass(frozen=True)
class Trial:
    """Parameters that are tried on a folder; with `include_done` also on what is done."""

    parameters: Parameters
    include_done: bool = False


def look_into(
    spread: Spread,
    trial: Trial,
    library: Library,
    tasks: Tasks,
    show: Callable[[Spread], None],
    is_wanted: Callable[[], bool],
) -> None:
    """Look into all recordings of a spread for as long as that is wanted; `show` what is known."""
    show(spread)
    with tasks.begin("Trying the parameters on the folder") as task:
        for number, recording in enumerate(spread.recordings):
            if not is_wanted():
                return
            task.at(number / len(spread.recordings), f"{recording.name}: trying")
            item = _tried(recording, trial, library)
            spread = replace(spread, items=(*spread.items, item))
            if is_wanted():
                show(spread)


def beside(recording: Recording, recordings: Sequence[Recording]) -> tuple[Recording, ...]:
    """The recordings of the same folder that can be opened."""
    folder = recording.path.parent
    return tuple(r for r in recordings if r.path.parent == folder and not r.error)


def _tried(recording: Recording, trial: Trial, library: Library) -> SpreadItem:
    try:
        looked = library.look(recording)
        looked.close()
        return SpreadItem(recording, looked.preview_shared(trial.parameters, trial.include_done))
    except KeyphaseError as error:
        return SpreadItem(recording, error=str(error))
