"""What all requests of a page are made of: bounded values, and what names a document."""

from typing import Annotated

from msgspec import Meta, Struct

Time = Annotated[float, Meta(ge=-1e9, le=1e10)]
Value = Annotated[float, Meta(ge=-1e12, le=1e12)]
Id = Annotated[str, Meta(max_length=4096)]
Name = Annotated[str, Meta(max_length=100)]
Counter = Annotated[int, Meta(ge=0, le=2**53)]


class PageRequest(Struct, frozen=True, tag_field="type", forbid_unknown_fields=True):
    """A message from a page."""


class OnDocument(PageRequest, frozen=True, kw_only=True):
    """A request about a recording; `revision` is that of the document it was made on.

    `event` is the page's own number of it: the document that contains it names it as its cause,
    or it comes back as `refused`.
    """

    recording: Id
    revision: Counter
    event: Counter | None = None
