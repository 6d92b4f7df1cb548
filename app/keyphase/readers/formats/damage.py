"""What a format's library raises over bytes that are not what they should be, as one refusal."""

from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

from keyphase.errors import DemonstrationError, KeyphaseError

_MAX_REASON = 300


@contextmanager
def damage_told(path: Path, kind: str, advice: str = "copy or export it again") -> Iterator[None]:
    """Turn whatever is raised within into a DemonstrationError that names the file in one line.

    A library raises whatever the bytes lead it to; none of it is a defect of keyphase.
    """
    try:
        yield
    except (KeyphaseError, ImportError):
        raise
    except Exception as error:
        reason = " ".join(f"{type(error).__name__}: {error}".split())[:_MAX_REASON]
        raise DemonstrationError(
            f"{path}: expected a whole {kind}, but it cannot be read ({reason}); {advice}."
        ) from error
