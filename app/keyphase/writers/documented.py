"""The list of export formats that the documents show, made from the code."""

from collections.abc import Iterator

from keyphase.writers.carried import Carried
from keyphase.writers.registry import WRITERS
from keyphase.writers.writer import Writer

_COLUMNS = {
    Carried.NAMES: "names",
    Carried.MOTIONS: "motions",
    Carried.TIMES: "exact times",
    Carried.DROPPED: "dropped",
    Carried.ORDER: "plan",
    Carried.ENDS: "end conditions",
    Carried.DOUBTS: "confidence",
    Carried.PARAMETERS: "parameters",
    Carried.MARKS: "marks",
    Carried.SIGNALS: "signals",
}


def exports_table() -> str:
    """Every format as Markdown: what it writes, what to install, and what it carries."""
    head = ["`--to`", "format", "writes", "install", *_COLUMNS.values()]
    rows = [_row(head), _row(["---"] * 4 + [":-:"] * len(_COLUMNS))]
    for writer in WRITERS:
        install = f"`keyphase[{writer.extra}]`" if writer.extra else ""
        ticks = ["✓" if one in writer.carries else "" for one in _COLUMNS]
        rows.append(_row([f"`{writer.name}`", writer.title, written(writer), install, *ticks]))
    return "\n".join(rows)


def exports_examples() -> str:
    """For each format the three lines that read it, and what a person should know of it."""
    return "\n\n".join("\n".join(_example(writer)) for writer in WRITERS)


def written(writer: Writer) -> str:
    """What a format writes, in a few words."""
    return f"`*{writer.ending}`" if writer.ending else "a copy of the file or dataset"


def _example(writer: Writer) -> Iterator[str]:
    yield f"### {writer.name}"
    yield ""
    for remark in writer.remarks:
        yield f"- {remark}"
    if writer.remarks:
        yield ""
    yield "```python"
    yield writer.reads_back.replace("PATH", f"run{writer.ending}" if writer.ending else "copy")
    yield "```"


def _row(cells: list[str]) -> str:
    return f"| {' | '.join(cells)} |"
