"""How many messages a connection may send, so that one cannot keep the others waiting."""

import time
from dataclasses import dataclass, field

MESSAGES_PER_S = 200.0
"""A connection that goes on faster than this is made to wait."""


@dataclass
class Budget:
    """Messages a connection may still send at once; refills with time, up to one second's worth."""

    left: float = MESSAGES_PER_S
    at_s: float = field(default_factory=time.monotonic)

    def wait_s(self) -> float:
        """Take one message; how long to wait first."""
        now = time.monotonic()
        self.left = min(self.left + (now - self.at_s) * MESSAGES_PER_S, MESSAGES_PER_S) - 1.0
        self.at_s = now
        return max(-self.left / MESSAGES_PER_S, 0.0)
