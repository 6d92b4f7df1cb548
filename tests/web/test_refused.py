"""Who opens the page without its token is told so, in a page that needs nothing else."""

import re

from talking import get

from keyphase.web.server import PageServer
from keyphase.web.transport.refused import refused


def test_a_person_gets_a_page_with_the_reason_and_where_the_link_is(server: PageServer) -> None:
    response, body = get(server, "/", {"Accept": "text/html,application/xhtml+xml,*/*"})
    page = body.decode()

    assert response.status == 403
    assert response.getheader("Content-Type") == "text/html; charset=utf-8"
    assert "it carries the token" in page
    assert "in the terminal in which keyphase was started" in page
    assert "<svg" in page


def test_it_loads_nothing_and_runs_nothing(server: PageServer) -> None:
    response, body = get(server, "/", {"Accept": "text/html"})
    policy = response.getheader("Content-Security-Policy") or ""

    assert "script" not in body.decode() + policy
    assert "default-src 'none'" in policy
    assert re.findall(r'(?:src|href)="(?!data:)', body.decode()) == []


def test_a_program_gets_the_reason_as_text(server: PageServer) -> None:
    response, body = get(server, "/")

    assert response.getheader("Content-Type") == "text/plain; charset=utf-8"
    assert body.decode().startswith("Open the page by the link")


def test_what_was_sent_is_shown_as_text() -> None:
    body = refused("The Host is '<script>alert(1)</script>'", "text/html").body

    assert b"<script" not in body
    assert b"&lt;script&gt;" in body
