"""The tokens of a folder and a port, kept so that pages find a server again that comes back."""

import hashlib
import logging
import os
import time
from pathlib import Path
from typing import Annotated

import msgspec

from keyphase.web.transport.access import COOKIE_LASTS_S, new_token
from keyphase.web.transport.private_files import private_folder, read_private, write_private

_log = logging.getLogger(__name__)

_Token = Annotated[str, msgspec.Meta(pattern=r"^[-_0-9A-Za-z]{43}$")]


class Keys(msgspec.Struct, frozen=True):
    """`token` opens everything, `looking_token` everything to the eye and nothing to the hand."""

    token: _Token
    looking_token: _Token


class LastingKeys:
    """The keys of the servers on one folder of recordings, one file for each port.

    They lie in the user's state folder, readable by the user only, and are forgotten when their
    cookies are. Where they cannot be kept, each start has new ones.
    """

    def __init__(self, recordings: Path) -> None:
        absolute = os.path.realpath(recordings)
        digest = hashlib.sha256(os.fsencode(absolute)).hexdigest()[:16]
        self.folder = servers_folder() / digest

    def ports(self) -> list[int]:
        """The ports of earlier servers, the last one first."""
        files = sorted(self._fresh_files(), reverse=True)
        return [int(file.stem) for _, file in files]

    def of(self, port: int) -> Keys:
        """The keys of the server on `port`: those it had before, or new ones."""
        kept = _read(self._file(port))
        keys = kept or Keys(new_token(), new_token())
        try:
            self._forget_old()
            private_folder(servers_folder())
            private_folder(self.folder)
            write_private(self._file(port), msgspec.json.encode(keys))
        except OSError as error:
            _log.info("The keys of this server cannot be kept: %s", error)
        return keys

    def _file(self, port: int) -> Path:
        return self.folder / f"{port}.json"

    def _fresh_files(self) -> list[tuple[float, Path]]:
        oldest = time.time() - COOKIE_LASTS_S
        return [(when, file) for when, file in self._files() if when > oldest]

    def _forget_old(self) -> None:
        fresh = {file for _, file in self._fresh_files()}
        for _, file in self._files():
            if file not in fresh:
                file.unlink(missing_ok=True)

    def _files(self) -> list[tuple[float, Path]]:
        """When each was last used, and the file."""
        try:
            files = [file for file in self.folder.glob("*.json") if file.stem.isdigit()]
            return [(file.stat().st_mtime, file) for file in files]
        except OSError:
            return []


def servers_folder() -> Path:
    """Where the keys of all servers of this user lie."""
    base = os.environ.get("XDG_STATE_HOME") or os.path.expanduser("~/.local/state")
    return Path(base, "keyphase", "servers")


def _read(path: Path) -> Keys | None:
    data = read_private(path)
    if data is None:
        return None
    try:
        if time.time() - path.stat().st_mtime > COOKIE_LASTS_S:
            return None
        return msgspec.json.decode(data, type=Keys)
    except (OSError, msgspec.MsgspecError, ValueError):
        return None
