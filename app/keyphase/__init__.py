"""keyphase turns a recorded robot demonstration into key phases."""

__version__ = "0.1.0"
