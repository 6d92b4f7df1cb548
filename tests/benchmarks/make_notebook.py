"""Make docs/first_steps.ipynb of examples/first_steps.py, with the results its cells give.

    python tests/benchmarks/make_notebook.py

Needs neither Jupyter nor a kernel: cells are run here, in a folder of their own. The same code
gives the same file.
"""

import base64
import contextlib
import io
import json
import os
import re
import tempfile
from pathlib import Path
from typing import Any

ROOT = Path(__file__).parents[2]
SCRIPT = ROOT / "examples" / "first_steps.py"
NOTEBOOK = ROOT / "docs" / "first_steps.ipynb"

_CELL = re.compile(r"^# %%(?: \[(markdown)\])?\n", re.M)


def main() -> None:
    """Write the notebook."""
    NOTEBOOK.write_text(notebook_text())
    print(NOTEBOOK.relative_to(ROOT))


def notebook_text() -> str:
    """The notebook as JSON, its cells run from first to last."""
    names: dict[str, Any] = {}
    cells = []
    with tempfile.TemporaryDirectory() as folder, contextlib.chdir(folder):
        for number, (kind, source) in enumerate(cells_of(SCRIPT.read_text())):
            cells.append(_cell(number, kind, source, names))
    language = {"name": "python", "version": "3"}
    kernel = {"display_name": "Python 3", "language": "python", "name": "python3"}
    content = {
        "cells": cells,
        "metadata": {"kernelspec": kernel, "language_info": language},
        "nbformat": 4,
        "nbformat_minor": 5,
    }
    return json.dumps(content, indent=1, ensure_ascii=False) + "\n"


def cells_of(script: str) -> list[tuple[str, str]]:
    """Kind ("markdown" or "code") and text of each cell; what stands before the first is none."""
    pieces = _CELL.split(script)[1:]
    found = []
    for kind, body in zip(pieces[::2], pieces[1::2], strict=True):
        text = body.strip("\n")
        if kind == "markdown":
            text = re.sub(r"^# ?", "", text, flags=re.M)
        found.append((kind or "code", text))
    return found


def _cell(number: int, kind: str, source: str, names: dict[str, Any]) -> dict[str, Any]:
    cell: dict[str, Any] = {
        "cell_type": kind,
        "id": f"cell-{number}",
        "metadata": {},
        "source": source.splitlines(keepends=True),
    }
    if kind == "code":
        cell |= {"execution_count": None, "outputs": _outputs(source, names)}
    return cell


def _outputs(source: str, names: dict[str, Any]) -> list[dict[str, Any]]:
    """What a cell prints, and the picture it writes."""
    before, printed = set(os.listdir()), io.StringIO()
    with contextlib.redirect_stdout(printed):
        exec(compile(source, str(SCRIPT), "exec"), names)
    outputs: list[dict[str, Any]] = []
    if text := printed.getvalue():
        lines = text.splitlines(keepends=True)
        outputs.append({"name": "stdout", "output_type": "stream", "text": lines})
    for picture in sorted(set(os.listdir()) - before):
        if picture.endswith(".png"):
            data = base64.b64encode(Path(picture).read_bytes()).decode()
            shown = {"data": {"image/png": data}, "metadata": {}, "output_type": "display_data"}
            outputs.append(shown)
    return outputs


if __name__ == "__main__":
    main()
