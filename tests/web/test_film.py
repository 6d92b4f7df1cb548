"""A scene that is written down: what is drawn for it is in the film and seen by nobody."""

import base64
import re

import zstandard
from framing import frame
from talking import PageClient

from keyphase.web.transport.film import film_in


def test_a_film_holds_what_is_drawn_for_it_and_no_page_sees_any_of_it(page: PageClient) -> None:
    with frame(page.server, page.page) as framed:
        before, sent = set(framed.nodes), framed.bytes
        client, film = film_in(page.server.viser)
        label = client.scene.add_label("/only/in/the/film", "said there")
        film.insert_sleep(0.5)
        label.text = "said later"
        client.camera.position = (1.0, 2.0, 3.0)
        html = film.as_html()

        assert set(framed.nodes) == before
        assert framed.bytes - sent < 10_000
        assert client.client_id not in page.server.viser.get_clients()
    found = re.search(r'__VISER_EMBED_DATA__="([^"]+)"', html)
    assert found
    data = zstandard.ZstdDecompressor().decompressobj().decompress(base64.b64decode(found[1])[8:])
    assert b"said there" in data
    assert b"said later" in data
    assert b"SetCameraPositionMessage" in data
