"""The notebook in the docs is what its script gives today, run without Jupyter."""

import json
from pathlib import Path
from typing import Any

import pytest

BENCHMARKS = Path(__file__).parent / "benchmarks"

pytestmark = pytest.mark.slow


def told(notebook: str) -> list[dict[str, Any]]:
    """Its cells, pictures by their being there: fonts differ from machine to machine."""
    cells = json.loads(notebook)["cells"]
    for cell in cells:
        for output in cell.get("outputs", ()):
            output.pop("data", None)
    return cells


def test_the_notebook_is_not_stale(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.syspath_prepend(BENCHMARKS)
    from make_notebook import NOTEBOOK, notebook_text

    assert told(notebook_text()) == told(NOTEBOOK.read_text()), (
        "run python tests/benchmarks/make_notebook.py"
    )
