"""Which other files of a folder may be read as one that a person is asked about."""

from pathlib import Path

from keyphase.errors import KeyphaseError
from keyphase.files.reading import first_bytes
from keyphase.readers.finding import undescribed_alike
from keyphase.readers.proposing.layout import layout_of
from keyphase.workbench.importing.unknown_table import UnknownTable

_LOOKED_AT_BYTES = 64 * 1024


def alike_tables(table: UnknownTable, folder: Path) -> tuple[Path, ...]:
    """Files right in a folder that nobody has described either and that are laid out like `table`.

    Of text those with the same line of names, or without names the same layout: notes, lists of
    requirements and tables of something else are none of them.
    """
    others = [path for path in undescribed_alike(table.path, folder) if path != table.path]
    if not others or not table.is_text:
        return tuple(others)
    own = _names_or_layout(table.path)
    return tuple(path for path in others if _names_or_layout(path) == own)


def _names_or_layout(path: Path) -> object:
    """What two tables of one recorder share; nothing shares anything with what is no table."""
    try:
        data = first_bytes(path, _LOOKED_AT_BYTES)
        form = layout_of(data).form
    except (KeyphaseError, OSError):
        return object()
    lines = data.decode(form.encoding, errors="ignore").splitlines()
    return lines[form.skip_lines].strip() if form.header else form
