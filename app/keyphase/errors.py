"""Everything keyphase refuses, as one tree.

KeyphaseError
├── DemonstrationError      a recording that cannot be read or used
│   └── RecipeError         a recipe that does not say how to read a table
├── CameraError             a video beside a recording that cannot be shown
├── ParameterError          a parameter out of its range
├── LabelingError           an edit that cannot be applied, a document that cannot be opened
│   ├── JournalError        the journal beside a recording cannot be used
│   └── SegmentFileError    a segment file that is malformed or of another recording
├── RobotError              a robot description or pose that cannot be used
├── SkillError              a segment that cannot be made executable
├── SimulationError         a workcell, recording or replay that cannot run
├── ScoreError              a reference that cannot be scored against
├── ExportError             segments that a format cannot hold as asked
├── MakingError             demonstrations that cannot be made as asked
├── FileInTheWayError       a file that would be replaced, and is not keyphase's own
├── MissingPackageError     a package that only this needs is not installed
└── RequestError            a message from a browser that is refused

Each message says what was expected, what came, and how to mend it, in one sentence.
"""

from pathlib import Path

from keyphase.printable import printable_line


class KeyphaseError(Exception):
    """Root of all errors a user can act on; anything else that is raised is a defect.

    Its message can be printed and sent as one line, whatever a file or a name that it quotes
    holds.
    """

    def __init__(self, message: object = "") -> None:
        super().__init__(printable_line(str(message)))


class DemonstrationError(KeyphaseError):
    """A recording that cannot be read or used."""


class RecipeError(DemonstrationError):
    """A recipe that does not say how to read a table."""


class CameraError(KeyphaseError):
    """A video beside a recording that cannot be shown."""


class ParameterError(KeyphaseError):
    """A parameter out of its range."""


class LabelingError(KeyphaseError):
    """An edit that cannot be applied or a document that cannot be opened."""


class JournalError(LabelingError):
    """The journal beside a recording cannot be used."""


class SegmentFileError(LabelingError):
    """A segment file that is malformed or belongs to another recording."""


class RobotError(KeyphaseError):
    """A robot description or a pose that cannot be used."""


class SkillError(KeyphaseError):
    """A segment that cannot be made executable."""


class SimulationError(KeyphaseError):
    """A workcell, a recording or a replay that cannot run."""


class ScoreError(KeyphaseError):
    """A reference that cannot be scored against."""


class ExportError(KeyphaseError):
    """Segments that a format cannot hold as asked, or labels in one that cannot be read."""


class MakingError(KeyphaseError):
    """Demonstrations that cannot be made as asked."""


class FileInTheWayError(KeyphaseError):
    """A file that would be replaced, and that keyphase did not write as it is.

    path   the file
    whose  what it is, as in "keyphase did not write it"
    """

    def __init__(self, path: Path, whose: str) -> None:
        super().__init__(
            f"{path} is in the way ({whose}), so it was not replaced; choose another name, move it "
            "away, or ask for it to be replaced (--replace)."
        )
        self.path, self.whose = path, whose


class MissingPackageError(KeyphaseError):
    """A package that only part of keyphase needs, and that is not installed."""

    @classmethod
    def of(cls, error: ModuleNotFoundError) -> "MissingPackageError":
        """What to install so that the import that failed goes well."""
        package = (error.name or str(error)).partition(".")[0]
        return cls(
            f"This needs the package '{package}', which is not installed; "
            'install what it belongs to: pip install "keyphase[all]".'
        )


class RequestError(KeyphaseError):
    """A message from a browser that is refused."""
