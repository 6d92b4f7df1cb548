"""Text out of files and names, made harmless where it is shown.

A name in a file can hold escape sequences that a terminal obeys, or marks that turn the direction
of what follows; bytes of a file name that are no text can be neither printed nor sent.
"""

import re

_UNSHOWN = re.compile("[\x00-\x08\x0b-\x1f\x7f-\x9f\u2028-\u202e\u2066-\u2069\ud800-\udfff]")


def printable(text: str) -> str:
    r"""The text with escapes such as \x1b for what a terminal or a page must not obey.

    Lines, tabs and letters of every script stay; so do the joiners that scripts and emoji need.
    """
    return _UNSHOWN.sub(_escape, text)


def printable_line(text: str) -> str:
    """The same in one line: a name with a line's end in it does not look like two."""
    return printable(text).replace("\n", "\\n").replace("\t", "\\t")


def _escape(match: re.Match[str]) -> str:
    code = ord(match[0])
    return f"\\x{code:02x}" if code < 0x100 else f"\\u{code:04x}"
