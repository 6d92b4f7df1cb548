"""What is made of the structs of the protocol is as they are now; `make protocol` makes it anew."""

from page_types import page_types
from protocol_manual import manual
from protocol_structs import edits, messages, parts_of, requests
from write_protocol import TYPES, written


def test_what_is_checked_in_is_what_the_structs_say() -> None:
    for path, text in written().items():
        assert path.read_text(encoding="utf-8") == text, f"{path} is stale: run `make protocol`"


def test_no_file_of_types_is_left_over() -> None:
    assert {path.name for path in TYPES.iterdir()} == set(page_types())


def test_every_message_and_every_field_is_in_the_manual() -> None:
    text = manual()
    for whole in (*messages(), *requests(), *edits()):
        assert whole.tag is not None
        assert f"### `{whole.tag[1]}`" in text
        for one in parts_of(whole):
            assert one.summary in text
            assert all(f"| `{field.name}`" in text for field in one.fields)


def test_words_are_said_of_fields_that_are_there() -> None:
    for whole in (*messages(), *requests(), *edits()):
        for one in parts_of(whole):
            said = {name for names in one.words for name in names.split(", ")}
            assert said <= {field.name for field in one.fields}, one.name


def test_no_sentence_is_a_table_of_fields_run_together() -> None:
    for whole in (*messages(), *requests(), *edits()):
        for one in parts_of(whole):
            assert "  " not in one.summary, one.name


def test_no_two_structs_share_a_name() -> None:
    kinds: dict[str, type] = {}
    for whole in (*messages(), *requests(), *edits()):
        for one in parts_of(whole):
            assert kinds.setdefault(one.name, one.kind) is one.kind
