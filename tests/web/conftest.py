"""Fixtures of the server's tests: a server on a copy of the bundled recording, and pages of it."""

import shutil
from collections.abc import Iterator
from pathlib import Path

import pytest
from talking import PageClient, StartServer

from keyphase.files.shipped import shipped
from keyphase.web.server import PageServer


@pytest.fixture(scope="module")
def bundled_copy(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A copy of the bundled synthetic Setup 1: labels are kept beside the recording."""
    folder = tmp_path_factory.mktemp("recordings")
    return Path(shutil.copy(shipped("data") / "synthetic_setup1.npz", folder))


@pytest.fixture(scope="module")
def server(bundled_copy: Path) -> Iterator[PageServer]:
    """One server for the tests of a file that change nothing."""
    server = PageServer([bundled_copy])
    yield server
    server.stop()


@pytest.fixture
def start_server() -> Iterator[StartServer]:
    """Starts servers that are stopped at the end."""
    servers: list[PageServer] = []

    def start(*paths: Path, **options: object) -> PageServer:
        servers.append(PageServer(list(paths), **options))  # type: ignore
        return servers[-1]

    yield start
    for started in servers:
        started.stop()


@pytest.fixture
def own_copy(tmp_path: Path) -> Path:
    """A recording of the test's own."""
    return Path(shutil.copy(shipped("data") / "synthetic_setup1.npz", tmp_path))


@pytest.fixture
def page(own_copy: Path, start_server: StartServer) -> Iterator[PageClient]:
    """A page that has received the document of a recording of its own."""
    with PageClient(start_server(own_copy)) as client:
        client.wait_for("document")
        yield client
