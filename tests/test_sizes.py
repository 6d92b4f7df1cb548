"""Walls that keep the code readable: no file, function or folder grows past what one can survey.

The functions of the page's scripts are measured by tests/page/sizes.test.js.
"""

import ast
from collections import Counter
from collections.abc import Iterator
from pathlib import Path

import pytest

PACKAGE = Path(__file__).parents[1] / "app" / "keyphase"
PAGE = PACKAGE / "web" / "page"

MAX_FILE_LINES = 300
MAX_FUNCTION_LINES = 45
MAX_MODULES = 20
MAX_SHARE_OF_WEB = 0.2


def sources(suffix: str) -> list[Path]:
    found = sorted(PACKAGE.rglob(f"*{suffix}"))
    assert len(found) > 5
    return found


def count_lines(path: Path) -> int:
    return len(path.read_text(encoding="utf-8").splitlines())


def functions(source: str) -> Iterator[tuple[str, int]]:
    """Name and number of lines of each function, without its decorators."""
    for node in ast.walk(ast.parse(source)):
        if isinstance(node, ast.FunctionDef | ast.AsyncFunctionDef) and node.end_lineno:
            yield node.name, node.end_lineno - node.lineno + 1


@pytest.mark.parametrize("suffix", [".py", ".js"])
def test_no_file_is_longer_than_300_lines(suffix: str) -> None:
    counts = {str(path.relative_to(PACKAGE)): count_lines(path) for path in sources(suffix)}
    assert {name: count for name, count in counts.items() if count > MAX_FILE_LINES} == {}


def test_no_function_is_longer_than_45_lines() -> None:
    long = [
        f"{path.relative_to(PACKAGE)}: {name} has {count}"
        for path in sources(".py")
        for name, count in functions(path.read_text(encoding="utf-8"))
        if count > MAX_FUNCTION_LINES
    ]
    assert long == []


@pytest.mark.parametrize("suffix", [".py", ".js"])
def test_no_folder_holds_more_than_20_modules(suffix: str) -> None:
    held = Counter(path.parent for path in sources(suffix) if path.name != "__init__.py")
    crowded = {str(folder.relative_to(PACKAGE)): n for folder, n in held.items() if n > MAX_MODULES}
    assert crowded == {}


def test_the_web_is_less_than_a_fifth_of_the_python_lines() -> None:
    lines = {path: count_lines(path) for path in sources(".py")}
    of_web = sum(count for path, count in lines.items() if path.is_relative_to(PACKAGE / "web"))
    assert of_web / sum(lines.values()) < MAX_SHARE_OF_WEB


def test_the_longest_function_is_found() -> None:
    source = "class A:\n    def short(self):\n        pass\n\n    async def long(self):\n" + (
        "        pass\n" * 50
    )
    assert dict(functions(source)) == {"short": 2, "long": 51}
