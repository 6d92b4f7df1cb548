"""The documents say what is there, and what they point at exists."""

import re
from dataclasses import fields
from pathlib import Path

import pytest

from keyphase.cli import COMMANDS
from keyphase.segmentation import Parameters

ROOT = Path(__file__).parents[1]
DOCUMENTS = sorted([*ROOT.glob("*.md"), *ROOT.glob("docs/*.md"), *ROOT.glob("data/*.md")])


@pytest.mark.parametrize("document", DOCUMENTS, ids=lambda path: path.name)
def test_every_link_leads_somewhere(document: Path) -> None:
    targets = re.findall(r"\]\(([^)#\s]+)\)", document.read_text())
    local = [target for target in targets if "://" not in target]
    missing = [target for target in local if not (document.parent / target).exists()]
    assert missing == []


def test_readme_names_every_command() -> None:
    text = (ROOT / "README.md").read_text()
    assert [name for name in COMMANDS if name != "open" and f"keyphase {name}" not in text] == []


def test_method_describes_every_parameter() -> None:
    text = (ROOT / "docs" / "method.md").read_text()
    assert [field.name for field in fields(Parameters) if field.name not in text] == []


def test_every_make_target_of_the_readme_exists() -> None:
    targets = set(re.findall(r"`make (\w+)`", (ROOT / "README.md").read_text()))
    makefile = (ROOT / "Makefile").read_text()
    assert {target for target in targets if f"\n{target}:" not in makefile} == set()


def test_readme_example_runs(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    import shutil

    from keyphase.files.shipped import shipped

    shutil.copy(shipped("data") / "setup1.npz", tmp_path)
    monkeypatch.chdir(tmp_path)
    (example,) = re.findall(r"```python\n(.*?)```", (ROOT / "README.md").read_text(), re.DOTALL)
    exec(compile(example, "README.md", "exec"), {})
