"""The documented list of formats is that of the code."""

from pathlib import Path

from keyphase.writers.documented import exports_examples, exports_table

TEXT = (Path(__file__).parents[2] / "docs" / "exports.md").read_text()


def test_the_table_of_formats_is_that_of_the_code() -> None:
    assert exports_table() in TEXT


def test_each_format_has_the_lines_that_read_it() -> None:
    assert exports_examples() in TEXT
