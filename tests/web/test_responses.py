"""What the server sends with every answer, and that no path leads out of the page's folder."""

import gzip
from pathlib import Path

import pytest
from hypothesis import given
from hypothesis import strategies as st
from talking import PAGE, cookie, get

from keyphase.web.server import PageServer
from keyphase.web.transport.responses import StaticFiles, page_files

PATHS = ("/", "/app/static/js/main.js", f"/viser/{PAGE}/", "/nothing")


@pytest.mark.parametrize("path", PATHS)
def test_every_answer_forbids_framing_by_others_and_guessing_of_types(
    server: PageServer, path: str
) -> None:
    response, _ = get(server, path, cookie(server))

    assert response.getheader("X-Content-Type-Options") == "nosniff"
    assert response.getheader("X-Frame-Options") == "SAMEORIGIN"
    assert response.getheader("Referrer-Policy") == "no-referrer"
    assert response.getheader("Cache-Control") == "no-cache"
    assert response.getheader("Content-Security-Policy")


def test_our_page_may_run_its_own_scripts_only(server: PageServer) -> None:
    policy = get(server, "/", cookie(server))[0].getheader("Content-Security-Policy") or ""

    assert "script-src 'self';" in policy
    assert "unsafe" not in policy
    assert "default-src 'none'" in policy
    assert "frame-ancestors 'self'" in policy


def test_visers_client_gets_what_it_needs_and_stays_on_this_server(server: PageServer) -> None:
    policy = (
        get(server, f"/viser/{PAGE}/", cookie(server))[0].getheader("Content-Security-Policy") or ""
    )

    assert "'unsafe-eval'" in policy
    assert "frame-ancestors 'self'" in policy
    assert "https:" not in policy
    assert "*" not in policy


def test_a_file_the_browser_has_is_not_sent_again(server: PageServer) -> None:
    first, body = get(server, "/app/static/js/main.js", cookie(server))
    tag = first.getheader("ETag") or ""
    second, nothing = get(
        server, "/app/static/js/main.js", {**cookie(server), "If-None-Match": tag}
    )

    assert body
    assert (second.status, nothing) == (304, b"")


def test_text_is_packed_for_a_browser_that_can_unpack_it(server: PageServer) -> None:
    path = "/app/static/js/main.js"
    plain, whole = get(server, path, cookie(server))
    answered, packed = get(server, path, {**cookie(server), "Accept-Encoding": "gzip, br"})

    assert plain.getheader("Content-Encoding") is None
    assert answered.getheader("Content-Encoding") == "gzip"
    assert answered.getheader("Vary") == "Accept-Encoding"
    assert gzip.decompress(packed) == whole
    assert len(packed) < 0.5 * len(whole)


def test_a_file_that_was_changed_is_packed_anew(tmp_path: Path) -> None:
    files = StaticFiles("/s/", (tmp_path,))
    for text in ("let one = 1;", "let two = 2;"):
        (tmp_path / "a.js").write_text(text)
        assert gzip.decompress(files.response("/s/a.js", "", None, "gzip").body) == text.encode()


@pytest.mark.parametrize(
    "path",
    [
        "/app/static/../server.py",
        "/app/static/%2e%2e/server.py",
        "/app/static/..%2fserver.py",
        "/app/static/....//server.py",
        "/app/static//etc/passwd",
        "/app/static/..\\server.py",
        "/app/static/%00",
        "/app/static/js",
        "/viser/../../_viser.py",
        "/viser/%2e%2e/%2e%2e/_viser.py",
    ],
)
def test_no_path_leads_out_of_the_folder(server: PageServer, path: str) -> None:
    assert get(server, path, cookie(server))[0].status == 404


def test_no_link_leads_out_of_the_folder(tmp_path: Path) -> None:
    inside = tmp_path / "inside"
    inside.mkdir()
    (tmp_path / "secret.js").write_text("secret")
    (inside / "link.js").symlink_to(tmp_path / "secret.js")

    assert StaticFiles("/s/", (inside,)).response("/s/link.js", "", None, "").status_code == 404


@given(st.text())
def test_any_path_gets_an_answer(path: str) -> None:
    assert page_files().response(f"/app/static/{path}", "", None, "").status_code in (200, 404)
