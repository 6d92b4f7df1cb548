"""Where commands put what they make: never over somebody else's file unasked."""

from pathlib import Path

from keyphase.errors import KeyphaseError


def refuse_in_the_way(path: Path, made_from: str, *, replace: bool) -> None:
    """Before long work: raise FileInTheWayError where `put` would, and KeyphaseError where the
    folder takes no files."""
    from keyphase.files.writing import require_writable
    from keyphase.labeling.storage.written_files import require_free

    if not replace:
        require_free(path, made_from)
    require_writable(path)


def put(
    path: Path,
    data: bytes,
    made_from: str,
    *,
    replace: bool,
    refusal: type[KeyphaseError] = KeyphaseError,
) -> None:
    """Put `data`, made from what `made_from` names, at `path`.

    Raises FileInTheWayError where a file is there that keyphase did not write, or not for the same,
    or that was changed since, unless it may be replaced; `refusal` where the folder takes no files.
    """
    from keyphase.labeling.storage.written_files import write_unasked

    if_there = "replace" if replace else "ask"
    write_unasked(path, data, made_from, refusal, if_there=if_there)
