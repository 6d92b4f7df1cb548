"""What stands in front of viser: the gate, our page's files, and the two websockets."""

from http import HTTPStatus

from websockets.asyncio.server import ServerConnection
from websockets.http11 import Request, Response

from keyphase.errors import RequestError
from keyphase.web.transport.access import Access, Entry, Grant
from keyphase.web.transport.addresses import (
    PageOwners,
    is_frame,
    page_of_frame_socket,
    page_of_socket,
)
from keyphase.web.transport.page_sockets import PageSockets
from keyphase.web.transport.refused import refused
from keyphase.web.transport.responses import (
    StaticFiles,
    page_files,
    page_policy,
    text,
    viser_policy,
)
from keyphase.web.transport.video_parts import VIDEOS, Videos, video_part
from keyphase.web.transport.viser_messages import admits
from keyphase.web.transport.viser_page import ViserPage, viser_page

INDEX = "/app/static/index.html"
"""The file behind `/`."""


class OurSite:
    """Gate, files, videos and sockets."""

    def __init__(
        self, access: Access, sockets: PageSockets, videos: Videos = lambda _id: None
    ) -> None:
        self.has_scenes = False
        self._access = access
        self._videos = videos
        self._sockets = sockets
        self._owners = PageOwners()
        self._files: StaticFiles = page_files()
        self._viser: ViserPage = viser_page()

    def response(self, request: Request, port: int) -> Response:
        """Our page and its files, viser's client for a frame, 404 for what is nobody's.

        403 for whoever has no right to be here, whatever they ask for.
        """
        try:
            entry = self._access.enter(request.path, request.headers, port)
        except RequestError as error:
            return refused(str(error), request.headers.get("Accept", ""))
        path = request.path.partition("?")[0]
        policy = page_policy(request.headers["Host"])
        tag = request.headers.get("If-None-Match")
        accepted = request.headers.get("Accept-Encoding", "")
        if path == "/":
            return self._remembered(entry, self._files.response(INDEX, policy, tag, accepted), port)
        if path.startswith(self._files.prefix):
            return self._files.response(path, policy, tag, accepted)
        if path.startswith(VIDEOS):
            return video_part(self._videos(path.removeprefix(VIDEOS)), request.headers)
        if is_frame(path):
            policy = viser_policy(request.headers["Host"])
            return self._viser.response(policy, accepted, tag)
        return text(HTTPStatus.NOT_FOUND, "There is no such page.")

    def refusal(self, request: Request, port: int) -> Response | None:
        """403 for a websocket of somebody who has no right to it."""
        try:
            grant = self._access.grant(request.path, request.headers, port)
        except RequestError as error:
            return text(HTTPStatus.FORBIDDEN, str(error))
        page = page_of_socket(request.path) or page_of_frame_socket(request.path)
        if page and not self._owners.admits(page, grant):
            return text(HTTPStatus.FORBIDDEN, "This page belongs to somebody else; open another.")
        return None

    async def page_socket(self, connection: ServerConnection) -> None:
        """One page's conversation."""
        assert connection.request is not None
        page = page_of_socket(connection.request.path)
        await self._sockets.serve(connection, self._grant(connection), page or None)

    def admits(self, connection: ServerConnection, message: bytes) -> bool:
        """Whether viser may hear a message from its client."""
        return admits(message, self._grant(connection))

    def _grant(self, connection: ServerConnection) -> Grant:
        assert connection.request is not None
        request, port = connection.request, connection.local_address[1]
        return self._access.grant(request.path, request.headers, port)

    def _remembered(self, entry: Entry, answer: Response, port: int) -> Response:
        """Turn the token of the link into the cookie that takes its place."""
        if entry.remember:
            answer.headers["Set-Cookie"] = self._access.cookie(port, entry.grant)
        return answer
