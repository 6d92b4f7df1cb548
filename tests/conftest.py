"""Fixtures shared by all tests."""

import os
from collections.abc import Iterator
from pathlib import Path

import pytest
from hypothesis import settings

# No test has a clock, and the same commit is tried on the same examples everywhere.
settings.register_profile("keyphase", max_examples=60, deadline=None, derandomize=True)
settings.register_profile("quick", settings.get_profile("keyphase"), max_examples=10)
settings.load_profile("keyphase")


@pytest.fixture(scope="session", autouse=True)
def _state_of_its_own(tmp_path_factory: pytest.TempPathFactory) -> Iterator[None]:
    """What keyphase keeps for its user, the keys of servers among it, is kept elsewhere."""
    with pytest.MonkeyPatch.context() as patch:
        patch.setenv("XDG_STATE_HOME", str(tmp_path_factory.mktemp("state")))
        yield


_LONGEST = ("test_long_recording.py", "test_mutated_files.py", "test_wheel.py")


def pytest_collection_modifyitems(items: list[pytest.Item]) -> None:
    """The longest first: at the end all but one would wait for it."""
    items.sort(key=lambda item: item.path.name not in _LONGEST)


@pytest.fixture(scope="session")
def real_data() -> Path:
    """Folder of real recordings; absent on most machines, so tests that need it say so and skip."""
    beside = Path(__file__).parents[2] / "shared" / "real_demonstrations"
    folder = Path(os.environ.get("KEYPHASE_REAL_DATA", beside))
    if not folder.is_dir():
        pytest.skip(f"real recordings not found at {folder}; point KEYPHASE_REAL_DATA at them")
    return folder
