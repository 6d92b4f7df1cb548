"""The command `keyphase`: each of its commands is one function of the library and a few lines here.

Everything heavy is imported where it is used, so that `--help` answers at once.
"""

import sys
from collections.abc import Sequence
from dataclasses import dataclass, field
from pathlib import Path
from typing import Annotated

import tyro

from keyphase import __version__
from keyphase.commands.make_demonstrations import MakeDemonstrations
from keyphase.commands.replay import ReplaySegments
from keyphase.errors import KeyphaseError
from keyphase.segmentation.parameters import Parameters

_Paths = tyro.conf.Positional[tuple[Path, ...]]
_Path = tyro.conf.Positional[Path]


@dataclass(frozen=True)
class Open:
    """Open the page on recordings: files, or folders that are searched for them."""

    paths: _Paths = ()
    """Recordings or folders of recordings; without any, the page tells how to begin."""
    host: str = "127.0.0.1"
    """Address to listen on; anything but 127.0.0.1 lets other machines knock."""
    port: int = 0
    """Port to listen on; 0 takes a free one."""
    browser: bool = True
    """Open the page in the browser."""
    read_only: bool = False
    """Give a link for looking: nothing can be changed."""
    upload_limit_mb: int = 2048
    """The largest file that can be dropped on the page [MB]."""
    recipe: Path | None = None
    """How to read tables that are not in keyphase's own form (TOML)."""
    robot: Path | None = None
    """Show another robot than the YuMi (URDF)."""
    tool_frame: str | None = None
    """The link of that robot that is the tool."""

    def run(self) -> int:
        """Serve the page until interrupted."""
        from keyphase.web import open_page

        open_page(
            self.paths,
            host=self.host,
            port=self.port,
            open_browser=self.browser,
            read_only=self.read_only,
            upload_limit_bytes=self.upload_limit_mb << 20,
            recipe=self.recipe,
            robot=self.robot,
            tool_frame=self.tool_frame,
        )
        return 0


@dataclass(frozen=True)
class SegmentRecordings:
    """Segment recordings and write a segment file for each."""

    paths: _Paths
    """Recordings or folders of recordings."""
    output: Path
    """Folder the segment files are written to."""
    recipe: Path | None = None
    """How to read tables that are not in keyphase's own form (TOML)."""
    csv: bool = False
    """Write a CSV beside each segment file."""
    jobs: int = -1
    """How many at once; -1 takes all cores."""
    parameters: tyro.conf.OmitArgPrefixes[Parameters] = field(default_factory=Parameters)

    def run(self) -> int:
        """Segment all, then list what was refused."""
        if not self.paths:
            raise KeyphaseError("Name at least one recording or folder to segment.")
        from tqdm import tqdm

        from keyphase.commands.batch import segment_all

        with tqdm(unit="recording", disable=None) as bar:

            def progress(done: int, total: int) -> None:
                bar.total = total
                bar.update(done - bar.n)

            report = segment_all(
                self.paths,
                self.output,
                recipe=self.recipe,
                parameters=self.parameters,
                csv=self.csv,
                jobs=self.jobs,
                progress=progress,
            )
        print(f"{len(report.written)} segment files in {self.output}")
        if report.refused:
            print(f"{len(report.refused)} refused:", file=sys.stderr)
            for refusal in report.refused:
                print(f"  {refusal.reason}", file=sys.stderr)
        return 1 if report.refused or not report.written else 0


@dataclass(frozen=True)
class ScoreSegments:
    """Score segment files against reference events."""

    truth: _Path
    """A truth.json: for each recording its events, tolerance and intervals to ignore."""
    segments: _Path
    """A folder of segment files, or one of them."""
    json: bool = False
    """Print for machines."""

    def run(self) -> int:
        """Print precision, recall, F1 and timing error per recording and set."""
        from keyphase.scoring import score

        result = score(self.truth, self.segments)
        print(result.as_json() if self.json else result.as_text())
        return 0


@dataclass(frozen=True)
class Record:
    """Record a demonstration of a scripted operator in a simulated workcell."""

    workcell: tyro.conf.Positional[str]
    """setup1 or setup2."""
    output: Path
    """The recording to write (NPZ)."""
    seed: int = 0
    """The same seed gives the same recording."""

    def run(self) -> int:
        """Record and write."""
        from keyphase.readers import save_npz
        from keyphase.simulation import record

        demonstration = record(self.workcell, seed=self.seed)
        save_npz(demonstration, self.output)
        print(f"{self.output}: {demonstration.duration_s:.2f} s at {demonstration.rate_hz:g} Hz")
        return 0


COMMANDS = {
    "open": Open,
    "segment": SegmentRecordings,
    "score": ScoreSegments,
    "record": Record,
    "make-demonstrations": MakeDemonstrations,
    "replay": ReplaySegments,
}
"""Every command by its name."""

_Command = (
    Annotated[Open, tyro.conf.subcommand("open")]
    | Annotated[SegmentRecordings, tyro.conf.subcommand("segment")]
    | Annotated[ScoreSegments, tyro.conf.subcommand("score")]
    | Annotated[Record, tyro.conf.subcommand("record")]
    | Annotated[MakeDemonstrations, tyro.conf.subcommand("make-demonstrations")]
    | Annotated[ReplaySegments, tyro.conf.subcommand("replay")]
)


def main(arguments: Sequence[str] | None = None) -> None:
    """Run the command line and exit; what a user can mend is said in one line on standard error."""
    given = list(sys.argv[1:] if arguments is None else arguments)
    if given == ["--version"]:
        print(f"keyphase {__version__}")
        sys.exit(0)
    try:
        command = tyro.cli(
            _Command, prog="keyphase", description=_DESCRIPTION, args=_as_command(given)
        )
        sys.exit(command.run())
    except KeyphaseError as error:
        print(f"keyphase: {error}", file=sys.stderr)
        sys.exit(1)


_DESCRIPTION = (
    "Turn recorded robot demonstrations into key phases. `keyphase PATH…` opens the page."
)


def _as_command(given: list[str]) -> list[str]:
    """A first argument that is no command is something to open; so is nothing at all."""
    if not given:
        return ["open"]
    return given if given[0] in COMMANDS or given[0] in ("-h", "--help") else ["open", *given]
