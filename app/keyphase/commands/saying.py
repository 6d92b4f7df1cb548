"""What commands print: text for a person, on a terminal."""

import sys

from keyphase.printable import printable


def say(*lines: object) -> None:
    """Print a line each; names out of files cannot steer the terminal."""
    for line in lines:
        print(printable(str(line)))


def complain(*lines: object) -> None:
    """The same on standard error."""
    for line in lines:
        print(printable(str(line)), file=sys.stderr)
