"""Writes what is made of the structs of the protocol: the page's types and docs/protocol.md.

make protocol
"""

import sys
from pathlib import Path

from page_types import page_types
from protocol_manual import FILE, manual

TYPES = Path(__file__).parents[2] / "app/keyphase/web/page/js/messages"


def written() -> dict[Path, str]:
    """What each file is to hold."""
    return {TYPES / name: text for name, text in page_types().items()} | {FILE: manual()}


if __name__ == "__main__":
    for path, text in written().items():
        path.write_text(text, encoding="utf-8")
        sys.stdout.write(f"{path}\n")
