"""The other tools of a recording: what each was found to do meanwhile, as a lane below."""

from dataclasses import dataclass

from keyphase.errors import KeyphaseError
from keyphase.labeling.labeling import Labeling
from keyphase.readers import arms_beside
from keyphase.workbench.desks.desk_state import DeskState
from keyphase.workbench.desks.library import Library
from keyphase.workbench.recordings import Recording


@dataclass(frozen=True, eq=False)
class Lane:
    """Another tool of the same recording, and its segments as they are kept."""

    recording: Recording
    labeling: Labeling


def lanes_of(state: DeskState, listed: tuple[Recording, ...], library: Library) -> tuple[Lane, ...]:
    """The other tools among the recordings of a list; one that cannot be read has no lane.

    One that is open is taken as it is there, else it is read and segmented, which takes long.
    """
    try:
        beside = arms_beside(state.recording.path, library.recipe)
    except KeyphaseError:
        return ()
    others = (one for path in beside for one in listed if one.path == path)
    found = ((one, _labeling_of(one, library)) for one in others)
    return tuple(Lane(one, labeling) for one, labeling in found if labeling is not None)


def _labeling_of(recording: Recording, library: Library) -> Labeling | None:
    try:
        if library.has_open(recording.id):
            with library.at(recording.id) as desk:
                return desk.opened().kept_labeling
        opened = library.look(recording)
    except (KeyphaseError, OSError):
        return None
    opened.close()
    return opened.kept_labeling
