"""From the channels a reader found to a demonstration that knows its file."""

from collections.abc import Iterable, Mapping
from typing import Any

import numpy as np

from keyphase.demonstration import Array, Demonstration
from keyphase.errors import DemonstrationError
from keyphase.files.parts import stem_of
from keyphase.files.reading import WholeFile
from keyphase.logged import Event
from keyphase.notices import Caution
from keyphase.oddities import Oddity, oddities_of
from keyphase.readers.held import held_notices
from keyphase.readers.timing import irregular_notices


def build(
    file: WholeFile,
    channels: Mapping[str, Array],
    *,
    named: Mapping[str, Array] | None = None,
    events: Iterable[Event] = (),
    wrench_estimated: bool = False,
    metadata: Mapping[str, Any] | None = None,
    notices: Iterable[str] = (),
) -> Demonstration:
    """The demonstration of `channels` (by their names in Demonstration), named after its file.

    `named` are its further channels.

    What holds, irregular rows and whatever is odd about it is added to the notices. Raises
    DemonstrationError, naming the file, where the channels break an invariant.
    """
    name = stem_of(file.source.path)
    try:
        with np.errstate(all="ignore"):
            found = (*irregular_notices(channels["time_s"]), *held_notices(channels))
            read = Demonstration(
                name=name,
                **channels,
                channels=named or {},
                events=tuple(events),
                wrench_estimated=wrench_estimated,
                metadata=metadata or {},
                source=file.source,
                notices=(*notices, *found),
            )
            return read.told(_told(odd) for odd in oddities_of(read))
    except DemonstrationError as error:
        reason = str(error).removeprefix(f"{name}: ")
        raise DemonstrationError(f"{file.name}: {reason}") from error


def _told(odd: Oddity) -> str:
    return Caution(odd.text) if odd.severity == "warning" else odd.text
