"""What `import keyphase` offers: complete, documented, and loaded only when asked for."""

import subprocess
import sys
from pathlib import Path

import pytest

import keyphase

ROOT = Path(__file__).parents[1]

OFFERED = [
    "Demonstration",
    "Document",
    "FoundBoundary",
    "KeyphaseError",
    "Parameters",
    "Segmentation",
    "Segmenter",
    "agreement",
    "audit",
    "draw",
    "label",
    "propose",
    "read",
    "read_segment_file",
    "register_method",
    "replay",
    "score",
    "segment",
    "skills_of",
    "skills_of_many",
    "taught_by",
    "write",
    "write_segment_file",
]


def test_the_offered_names_are_these() -> None:
    assert sorted(keyphase.__all__) == OFFERED


@pytest.mark.parametrize("name", OFFERED)
def test_every_offered_name_exists_and_is_documented(name: str) -> None:
    assert (getattr(keyphase, name).__doc__ or "").strip()


def test_a_name_that_is_not_offered_is_refused() -> None:
    with pytest.raises(AttributeError, match="no attribute 'segmnt'"):
        keyphase.segmnt  # noqa: B018


def test_importing_keyphase_loads_nothing_but_its_errors_and_what_they_say() -> None:
    code = "import sys, keyphase; print(*(m for m in sys.modules if m.startswith('keyphase.')))"
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    assert set(done.stdout.split()) == {"keyphase.errors", "keyphase.printable"}


def test_types_travel_with_the_package() -> None:
    assert (ROOT / "app" / "keyphase" / "py.typed").is_file()
