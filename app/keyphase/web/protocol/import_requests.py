"""What a page says of recordings nobody has described yet."""

from dataclasses import asdict
from typing import Annotated, Literal

import msgspec
from msgspec import Meta, Struct

from keyphase.readers.proposing.answers import Answers, Part
from keyphase.web.protocol.request_kinds import Id, Name, PageRequest
from keyphase.workbench.importing.importing import Scope


class TableAnswers(Struct, frozen=True, forbid_unknown_fields=True):
    """How a person says that a recording is to be read; open is what is "", 0 or null.

    parts              what each column is
    units              of time, length, angle, force, torque, joints and gripper
    order, layout      of a quaternion, of a matrix
    sequence           of the axes of three angles, or "rotation_vector"
    frame, sign        of the wrench
    from_first_s       so long nothing touches the tool at the beginning; the mean is taken out
    time_format        of a time in words
    clocks             the column with the time of a section that has one of its own
    sides              to which of two tools each column belongs, if there are two
    urdf, tool_frame   of the robot, where joints say where the tool is
    torque_sign        of joint torques
    preset             what reads the recording but for what that leaves open
    text               the recipe itself, where a person has written it
    """

    encoding: Name
    separator: Name
    decimal: Literal[".", ","]
    skip_lines: Annotated[int, Meta(ge=0, le=100_000)]
    header: bool
    parts: Annotated[list[Part], Meta(max_length=2000)]
    units: Annotated[dict[Name, Name], Meta(max_length=10)]
    order: Literal["", "wxyz", "xyzw"] = ""
    layout: Literal["", "row_major", "column_major"] = ""
    sequence: Annotated[str, Meta(max_length=20)] = ""
    frame: Literal["", "base", "tool"] = ""
    sign: Literal[0, 1, -1] = 0
    rate_hz: Annotated[float, Meta(gt=0, le=1e6)] | None = None
    from_first_s: Annotated[float, Meta(gt=0, le=1e6)] | None = None
    time_format: Name = ""
    clocks: Annotated[dict[Name, Id], Meta(max_length=40)] = {}
    sides: Annotated[list[Name], Meta(max_length=2000)] = []
    lines_after_header: Annotated[int, Meta(ge=0, le=100_000)] = 0
    restarts: bool = False
    leave_out_empty: bool = False
    drop_repeated: bool = False
    urdf: Id = ""
    tool_frame: Name = ""
    torque_sign: Literal[0, 1, -1] = 0
    preset: Name = ""
    text: Annotated[str, Meta(max_length=65536)] = ""

    def answers(self) -> Answers:
        """The same for those who read recordings."""
        values = {name: getattr(self, name) for name in self.__struct_fields__}
        return Answers(**{**values, "parts": tuple(self.parts), "sides": tuple(self.sides)})


def table_answers(answers: Answers) -> TableAnswers:
    """The same for a page."""
    return msgspec.convert(asdict(answers), TableAnswers)


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
