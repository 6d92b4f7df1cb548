"""Cookies that other programs have set on this host, in a real browser."""

from pathlib import Path

from driver import KeyphasePage, Serve
from playwright.sync_api import Browser


def test_a_json_cookie_of_another_program_changes_nothing(
    chromium: Browser, serve: Serve, folder: Path
) -> None:
    server = serve(folder / "setup1.npz")
    context = chromium.new_context()
    context.add_cookies(
        [
            {"name": "prefs", "value": '{"theme":"dark","n":[1]}', "url": "http://127.0.0.1:8888/"},
            {"name": "long", "value": "x" * 4000, "url": "http://127.0.0.1:8889/"},
            {"name": "longer", "value": "y" * 4000, "url": "http://127.0.0.1:8889/"},
            {"name": "longest", "value": "z" * 4000, "url": "http://127.0.0.1:8889/"},
        ]
    )
    page = KeyphasePage(context.new_page())
    refused: list[str] = []
    page.page.on("response", lambda one: refused.append(one.url) if one.status >= 400 else None)
    try:
        page.page.goto(server.link)
        page.wait_for_document()
        page.scene.wait_for_function("() => window.__viserMutable?.nodeRefFromName['/path/pieces']")
        assert refused == []
        assert page.errors == []
    finally:
        context.close()
