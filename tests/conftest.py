"""Fixtures shared by all tests."""

import os
from collections.abc import Generator, Iterator
from pathlib import Path

import pytest
from hypothesis import settings

# No test has a clock, and the same commit is tried on the same examples everywhere.
settings.register_profile("keyphase", deadline=None, derandomize=True)
settings.load_profile("keyphase")


@pytest.fixture(scope="session", autouse=True)
def _state_of_its_own(tmp_path_factory: pytest.TempPathFactory) -> Iterator[None]:
    """What keyphase keeps for its user, the keys of servers among it, is kept elsewhere."""
    with pytest.MonkeyPatch.context() as patch:
        patch.setenv("XDG_STATE_HOME", str(tmp_path_factory.mktemp("state")))
        yield


_KNOWN = pytest.StashKey[str]()

_LONGEST = ("test_long_recording.py", "test_mutated_files.py", "test_wheel.py")

KNOWN_FAILURES = Path(__file__).with_name("known_failures.txt")


def pytest_collection_modifyitems(items: list[pytest.Item]) -> None:
    """The longest first: at the end all but one would wait for it.

    What is known to fail is listed in known_failures.txt, each with its reason, and told in the
    summary; a test that passes again leaves the list.
    """
    items.sort(key=lambda item: item.path.name not in _LONGEST)
    known = dict(_known_failures())
    for item in items:
        name, file = item.nodeid.partition("[")[0], item.nodeid.partition("::")[0]
        reason = known.get(item.nodeid) or known.get(name) or known.get(file)
        if reason is not None:
            item.add_marker(pytest.mark.xfail(reason=reason, strict=False))
            item.stash[_KNOWN] = reason


@pytest.hookimpl(wrapper=True, tryfirst=True)
def pytest_runtest_makereport(
    item: pytest.Item, call: pytest.CallInfo[None]
) -> Generator[None, pytest.TestReport, pytest.TestReport]:
    """What is known to fail may do so while it is put away, too."""
    report = yield
    if call.when == "teardown" and report.failed and _KNOWN in item.stash:
        report.outcome = "skipped"
        report.wasxfail = item.stash[_KNOWN]
    return report


def _known_failures() -> Iterator[tuple[str, str]]:
    for line in KNOWN_FAILURES.read_text().splitlines():
        if line and not line.startswith("#"):
            node, _, reason = line.partition("  # ")
            yield node, reason


@pytest.fixture(scope="session")
def real_data() -> Path:
    """Folder of real recordings; absent on most machines, so tests that need it say so and skip."""
    beside = Path(__file__).parents[2] / "shared" / "real_demonstrations"
    folder = Path(os.environ.get("KEYPHASE_REAL_DATA", beside))
    if not folder.is_dir():
        pytest.skip(f"real recordings not found at {folder}; point KEYPHASE_REAL_DATA at them")
    return folder
