"""What stands in front of viser: the gate, our page's files, and the two websockets."""

from http import HTTPStatus

from websockets.asyncio.server import ServerConnection
from websockets.http11 import Request, Response

from keyphase.errors import RequestError
from keyphase.web.transport.access import Access, Grant, token_in_link
from keyphase.web.transport.page_sockets import PageSockets
from keyphase.web.transport.responses import (
    StaticFiles,
    page_files,
    page_policy,
    text,
    viser_policy,
    with_headers,
)
from keyphase.web.transport.viser_messages import Accepts, admits

PAGE = "/app/static/index.html"
"""The file behind `/`."""


class OurSite:
    """Gate, files and sockets; `accepts` says which control may take which value."""

    def __init__(self, access: Access, sockets: PageSockets, accepts: Accepts) -> None:
        self._access = access
        self._sockets = sockets
        self._accepts = accepts
        self._files: StaticFiles = page_files()

    def refusal(self, request: Request, port: int) -> Response | None:
        """403 for whoever has no right to be here, whatever they ask for."""
        try:
            self._access.grant(request.path, request.headers, port)
        except RequestError as error:
            return text(HTTPStatus.FORBIDDEN, str(error))
        return None

    def response(self, request: Request, port: int) -> Response | None:
        """Our page and its files; None for what is viser's, 404 for what is nobody's."""
        path = request.path.partition("?")[0]
        host = request.headers["Host"]
        tag = request.headers.get("If-None-Match")
        if path == "/":
            answer = self._files.response(PAGE, page_policy(host), tag)
            return self._remembered(request, answer, port)
        if path.startswith(self._files.prefix):
            return self._files.response(path, page_policy(host), tag)
        if path.startswith("/viser/"):
            return None
        return text(HTTPStatus.NOT_FOUND, "There is no such page.")

    def finish(self, request: Request, response: Response) -> Response:
        """viser's client with our headers."""
        return with_headers(response, viser_policy(request.headers["Host"]))

    async def page_socket(self, connection: ServerConnection) -> None:
        """One page's conversation."""
        await self._sockets.serve(connection, self._grant(connection))

    def admits(self, connection: ServerConnection, message: bytes) -> bool:
        """Whether viser may hear a message from its client."""
        return admits(message, self._grant(connection), self._accepts)

    def _grant(self, connection: ServerConnection) -> Grant:
        assert connection.request is not None
        request, port = connection.request, connection.local_address[1]
        return self._access.grant(request.path, request.headers, port)

    def _remembered(self, request: Request, answer: Response, port: int) -> Response:
        """Turn the token of the link into the cookie that takes its place."""
        if token_in_link(request.path):
            grant = self._access.grant(request.path, request.headers, port)
            answer.headers["Set-Cookie"] = self._access.cookie(port, grant)
        return answer
