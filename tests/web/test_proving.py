"""keyphase serves only behind a gate that has been seen to hold."""

import pytest
from talking import StartServer

from keyphase.errors import KeyphaseError
from keyphase.web.transport import one_port
from keyphase.web.transport.access import Access, Entry, Grant


def test_a_gate_that_lets_everybody_in_is_not_served(
    start_server: StartServer, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(Access, "enter", lambda *_: Entry(Grant.EVERYTHING))

    with pytest.raises(KeyphaseError, match=r"does not serve.*403.*200"):
        start_server()


def test_websockets_that_open_for_everybody_are_not_served(
    start_server: StartServer, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(Access, "grant", lambda *_: Grant.EVERYTHING)

    with pytest.raises(KeyphaseError, match="does not serve"):
        start_server()


def test_a_gate_that_is_not_in_front_is_not_served(
    start_server: StartServer, monkeypatch: pytest.MonkeyPatch
) -> None:
    """As with a viser that no longer asks websockets for its server."""
    monkeypatch.setattr(one_port.websockets_server, "serve", one_port.websockets_server.serve)
    monkeypatch.setattr(one_port, "_gate", lambda _site: lambda _connection, _request: None)

    with pytest.raises(KeyphaseError, match="does not serve"):
        start_server()
