"""What a page may say: every request does its work, everything else is refused with a reason."""

import contextlib
import json
from typing import Any, get_args

import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st
from talking import PageClient

from keyphase.errors import RequestError
from keyphase.web.protocol.requests import Request, Seek, Set, parse

JSON = st.recursive(
    st.none() | st.booleans() | st.integers() | st.floats() | st.text(max_size=20),
    lambda inner: (
        st.lists(inner, max_size=4) | st.dictionaries(st.text(max_size=10), inner, max_size=4)
    ),
    max_leaves=8,
)
KINDS = st.sampled_from([kind.__struct_config__.tag for kind in get_args(Request)])
FIELDS = st.sampled_from(
    [
        "id",
        "recording",
        "revision",
        "parameter",
        "value",
        "event",
        "held",
        "edit",
        "segment",
        "time_s",
        "playing",
        "speed",
        "loop",
        "request",
        "tracks",
        "from_s",
        "to_s",
        "width",
        "kind",
        "what",
        "visible",
        "dark",
    ]
)
MESSAGES = st.builds(
    lambda kind, fields: {**fields, "type": kind},
    KINDS,
    st.dictionaries(FIELDS, JSON | st.sampled_from(["json", "path", "1"]), max_size=6),
)


def test_a_request_becomes_a_value() -> None:
    assert parse('{"type": "seek", "time_s": 2}') == Seek(time_s=2.0)
    text = (
        '{"type": "set", "recording": "a", "revision": 7, "parameter": "force_ratio", "value": 2}'
    )
    assert parse(text) == Set("force_ratio", 2.0, recording="a", revision=7)


@pytest.mark.parametrize(
    ("raw", "reason"),
    [
        ("", "truncated"),
        ("[]", "object"),
        ('{"type": "format_disk"}', "format_disk"),
        ('{"time_s": 1}', "type"),
        ('{"type": "seek"}', "time_s"),
        ('{"type": "seek", "time_s": "1"}', "float"),
        ('{"type": "seek", "time_s": true}', "float"),
        ('{"type": "seek", "time_s": NaN}', "malformed"),
        ('{"type": "seek", "time_s": 1e999}', "range"),
        ('{"type": "seek", "time_s": 1e300}', "10000000000"),
        ('{"type": "seek", "time_s": 1, "and": 2}', "and"),
        ('{"type": "play", "playing": true, "speed": 0}', "0.01"),
        ('{"type": "select", "recording": "a", "revision": 1, "segment": -1}', ">= 0"),
        (
            '{"type": "signals", "recording": "a", "request": 1, "tracks": [], "from_s": 0, '
            '"to_s": 1, "width": 1}',
            ">= 2",
        ),
        ('{"type": "open", "id": "\ud800"}', "utf-8"),
        ('{"type": "open", "id": "' + "x" * 5000 + '"}', "4096"),
        (
            '{"type": "edit", "recording": "a", "revision": 1, "edit": '
            + "[" * 50_000
            + "]" * 50_000
            + "}",
            "object",
        ),
        ('{"type": "open", "id": "' + "x" * 300_000 + '"}', "characters"),
        (b"\x00\x01", "binary"),
    ],
)
def test_what_is_no_request_is_refused_with_the_reason(raw: str | bytes, reason: str) -> None:
    with pytest.raises(RequestError, match=reason):
        parse(raw)


@given(st.text() | st.binary() | JSON.map(json.dumps) | MESSAGES.map(json.dumps))
def test_anything_is_parsed_or_refused(raw: str | bytes) -> None:
    with contextlib.suppress(RequestError):
        parse(raw)


@settings(max_examples=150, suppress_health_check=[HealthCheck.function_scoped_fixture])
@given(message=MESSAGES)
def test_nonsense_is_heard_and_the_next_page_is_served(
    page: PageClient, message: dict[str, Any]
) -> None:
    page.send_raw(json.dumps(message))
    page.send("signals", request=77, tracks=["speed"], from_s=0, to_s=1, width=10)

    while page.wait_for_signals()[0]["request"] != 77:
        pass
