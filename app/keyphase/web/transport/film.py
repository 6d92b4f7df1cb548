"""Writing a scene down: a client of viser's that nobody has, whose messages are kept as a film."""

import time
from typing import Any

import numpy as np
import viser
from viser import infra
from viser.infra import _infra
from viser.infra._async_message_buffer import AsyncMessageBuffer

_NOBODY = -1
"""The client's number; those of browsers count from zero."""


def film_in(server: viser.ViserServer) -> tuple[viser.ClientHandle, infra.StateSerializer]:
    """A handle to draw with, and the film of all that is drawn; no browser sees any of it.

    viser writes down what all clients are sent. Each page has a scene of its own here, so a client
    is made up for the film; this is private to viser, and a test fails where it stops holding.
    """
    loop: Any = server._event_loop  # type: ignore[reportPrivateUsage]
    buffer = AsyncMessageBuffer(loop, persistent_messages=False)
    state = _infra._ClientHandleState(buffer, loop)  # type: ignore[reportPrivateUsage]
    connection = infra.WebsockClientConnection(_NOBODY, state)
    client = viser.ClientHandle(connection, server)
    # A camera that was never heard of refuses to be moved.
    camera = client.camera._state  # type: ignore[reportPrivateUsage]
    camera.update_timestamp = time.time()
    camera.position, camera.look_at = np.array([4.0, 3.0, 2.0]), np.zeros(3)
    camera.up_direction = np.array([0.0, 0.0, 1.0])
    film = connection.get_message_serializer(lambda one: one.include_in_scene_serialization)
    return client, film
