"""The page: a viser scene and panel above, our own timeline below, one port."""

from keyphase.web.server import open_page

__all__ = ["open_page"]
