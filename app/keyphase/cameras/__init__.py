"""Videos beside a recording: where they are, which frame was taken when."""

from keyphase.cameras.camera import Camera, Footage
from keyphase.cameras.footage import footage_of

__all__ = ["Camera", "Footage", "footage_of"]
