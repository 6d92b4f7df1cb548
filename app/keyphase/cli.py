"""The command `keyphase`: chooses among the commands, each of which has a file in `commands/`.

Everything heavy is imported where it is used, so that `--help` answers at once and commands run
where what they do not use is not installed.
"""

import os
import sys
from collections.abc import Sequence
from functools import reduce
from operator import or_
from typing import Annotated, Any, Protocol

import tyro

from keyphase import __version__
from keyphase.commands.agree import AgreeSegments
from keyphase.commands.audit import AuditLabels
from keyphase.commands.draw import DrawSegmentation
from keyphase.commands.export import ExportSegments
from keyphase.commands.fit import FitWeights
from keyphase.commands.inspect import Inspect
from keyphase.commands.make_demonstrations import MakeDemonstrations
from keyphase.commands.open import Open
from keyphase.commands.phases import Phases
from keyphase.commands.propose import Propose
from keyphase.commands.record import Record
from keyphase.commands.replay import ReplaySegments
from keyphase.commands.saying import complain
from keyphase.commands.score import ScoreSegments
from keyphase.commands.segment import SegmentRecordings
from keyphase.commands.tidy import Tidy
from keyphase.errors import KeyphaseError, MissingPackageError

COMMANDS = {
    "open": Open,
    "segment": SegmentRecordings,
    "inspect": Inspect,
    "propose": Propose,
    "phases": Phases,
    "score": ScoreSegments,
    "agree": AgreeSegments,
    "export": ExportSegments,
    "audit": AuditLabels,
    "draw": DrawSegmentation,
    "record": Record,
    "replay": ReplaySegments,
    "tidy": Tidy,
    "make-demonstrations": MakeDemonstrations,
    "fit": FitWeights,
}
"""Every command by its name."""


def main(arguments: Sequence[str] | None = None) -> None:
    """Run the command line and exit; what a user can mend is said in one line on standard error."""
    given = list(sys.argv[1:] if arguments is None else arguments)
    try:
        try:
            _main(given)
        finally:
            sys.stdout.flush()
    except BrokenPipeError:
        # Who read along has closed the pipe, as `head` does; Python would flush once more.
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
        sys.exit(1)


def _main(given: list[str]) -> None:
    if given == ["--version"]:
        print(f"keyphase {__version__}")
        sys.exit(0)
    try:
        command = tyro.cli(
            _any_command(), prog="keyphase", description=_DESCRIPTION, args=_as_command(given)
        )
        sys.exit(_run(command))
    except KeyphaseError as error:
        complain(f"keyphase: {error}")
        sys.exit(1)


def _any_command() -> Any:
    """The type tyro parses: one of the commands, each under its name."""
    named = (Annotated[command, tyro.conf.subcommand(name)] for name, command in COMMANDS.items())
    return reduce(or_, named)


class _Runs(Protocol):
    def run(self) -> int: ...


def _run(command: _Runs) -> int:
    """Raises MissingPackageError where a package that only this command needs is not installed."""
    try:
        return command.run()
    except ModuleNotFoundError as error:
        if (error.name or "").partition(".")[0] == "keyphase":
            raise
        raise MissingPackageError.of(error) from error


_DESCRIPTION = (
    "Turn recorded robot demonstrations into key phases. `keyphase PATH…` opens the page."
)


def _as_command(given: list[str]) -> list[str]:
    """A first argument that is no command is something to open; so is nothing at all."""
    if not given:
        return ["open"]
    return given if given[0] in COMMANDS or given[0] in ("-h", "--help") else ["open", *given]
