"""What a page says of tables nobody has described yet."""

from typing import Annotated, Literal

from msgspec import Meta, Struct

from keyphase.readers.proposing.answers import Answers, Part
from keyphase.web.protocol.request_kinds import Id, Name, PageRequest
from keyphase.workbench.importing.importing import Scope


class TableAnswers(Struct, frozen=True, forbid_unknown_fields=True):
    """How a person says that a table is to be read; open is what is "", 0 or null.

    parts         what each column is
    units         of time, length, angle, force, torque, joints and gripper
    frame, sign   of the wrench
    from_first_s  so long nothing touches the tool at the beginning; the mean is taken out
    """

    encoding: Name
    separator: Name
    decimal: Literal[".", ","]
    skip_lines: Annotated[int, Meta(ge=0, le=100_000)]
    header: bool
    parts: Annotated[list[Part], Meta(max_length=2000)]
    units: Annotated[dict[Name, Name], Meta(max_length=10)]
    sequence: Annotated[str, Meta(max_length=3)] = "xyz"
    frame: Literal["", "base", "tool"] = ""
    sign: Literal[0, 1, -1] = 0
    rate_hz: Annotated[float, Meta(gt=0, le=1e6)] | None = None
    from_first_s: Annotated[float, Meta(gt=0, le=1e6)] | None = None

    def answers(self) -> Answers:
        """The same for those who read tables."""
        return Answers(
            encoding=self.encoding,
            separator=self.separator,
            decimal=self.decimal,
            skip_lines=self.skip_lines,
            header=self.header,
            parts=tuple(self.parts),
            units=dict(self.units),
            sequence=self.sequence,
            frame=self.frame,
            sign=self.sign,
            rate_hz=self.rate_hz,
            from_first_s=self.from_first_s,
        )


class Describe(PageRequest, tag="describe", frozen=True):
    """Propose how a recording in the list could be read that cannot be read as it is."""

    recording: Id


class DescribeTry(PageRequest, tag="describe_try", frozen=True):
    """Tell what these answers would come to."""

    id: Name
    answers: TableAnswers


class DescribeConfirm(PageRequest, tag="describe_confirm", frozen=True):
    """Read the table so, and write the recipe: of this file, or of all tables in its folder."""

    id: Name
    answers: TableAnswers
    scope: Scope


class DescribeLeave(PageRequest, tag="describe_leave", frozen=True):
    """Do not read this table after all."""

    id: Name
