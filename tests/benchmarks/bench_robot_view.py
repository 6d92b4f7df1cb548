"""The robot in the page: time for each pose on the server, and bytes a page loads.

Poses are set as the playhead sets them, on a server that a client listens to; the time is the
processor's for the whole update of the robot, kinematics included. Bytes are those on the wire,
compressed as they are sent, of everything a browser asks for until robot, parts and path stand in
the scene.
"""

import gzip
import re
import shutil
import statistics
import sys
import time
from dataclasses import replace
from http.client import HTTPConnection
from pathlib import Path
from urllib.parse import urljoin

import numpy as np
import pytest
from websockets.sync.client import connect

sys.path.insert(0, str(Path(__file__).parents[1] / "web"))
from framing import Frame, frame
from talking import PAGE, PageClient, cookie

from keyphase.files.shipped import shipped
from keyphase.web.server import PageServer

UPDATES = 600
RATE_HZ = 60.0
MAX_MS = 2.0
MAX_LATE_MS = 50.0
MAX_BYTES = 4_000_000
QUIET_S = 3.0


@pytest.fixture(scope="module")
def server(tmp_path_factory):
    folder = tmp_path_factory.mktemp("recordings")
    server = PageServer([Path(shutil.copy(shipped("data") / "setup1.npz", folder))])
    yield server
    server.stop()


@pytest.fixture
def framed(server):
    """A page whose frame listens, with robot, parts and path in it."""
    with PageClient(server) as page:
        page.wait_for("document")
        with frame(server) as framed:
            framed.settle()
            yield framed


def received_bytes(socket, quiet_s=QUIET_S):
    total = 0
    while True:
        try:
            message = socket.recv(timeout=quiet_s)
        except TimeoutError:
            return total
        total += len(message)


def at_sixty_hertz(framed: Frame):
    """Set poses all along the recording: milliseconds of each, and how late the last was."""
    robot, head = framed.scene.robot, framed.server.workbench.find_view(PAGE).playhead
    times = np.linspace(head.start_s, head.end_s, UPDATES).tolist()
    taken, begun = [], time.perf_counter()
    for number, time_s in enumerate(times):
        before = time.thread_time()
        robot.show_playhead(replace(head, time_s=time_s))
        taken.append(1e3 * (time.thread_time() - before))
        due = begun + (number + 1) / RATE_HZ
        time.sleep(max(0.0, due - time.perf_counter()))
    return taken, 1e3 * (time.perf_counter() - begun - UPDATES / RATE_HZ)


def test_sixty_poses_a_second(framed):
    time.sleep(QUIET_S)
    before = framed.bytes
    taken, late = at_sixty_hertz(framed)
    time.sleep(QUIET_S)
    arrived = framed.bytes - before
    median, worst = statistics.median(taken), float(np.quantile(taken, 0.95))
    rate = 1e-3 * arrived * RATE_HZ / UPDATES
    print(
        f"\none pose: median {median:.2f} ms, 95 % under {worst:.2f} ms; the last of {UPDATES} "
        f"{max(late, 0.0):.1f} ms late; {rate:.0f} kB/s"
    )
    assert median < MAX_MS
    assert worst < MAX_MS
    assert late < MAX_LATE_MS


def test_page_load(server, framed):
    http = sum(loaded_bytes(server).values())
    time.sleep(QUIET_S)
    scene = framed.bytes
    url = f"ws://127.0.0.1:{server.port}/app/ws"
    with connect(url, additional_headers=cookie(server), max_size=None) as socket:
        page = received_bytes(socket)
    total = http + scene + page
    print(
        f"\nfiles {http / 1e6:.2f} MB, scene {scene / 1e6:.2f} MB, page {page / 1e6:.2f} MB, "
        f"together {total / 1e6:.2f} MB"
    )
    assert scene > 500_000, "the robot must have been in it"
    assert total < MAX_BYTES


def loaded_bytes(server):
    """Bytes of every file our page and viser's client are made of, by path."""
    sizes, wanted = {}, ["/", f"/viser/{PAGE}/"]
    while wanted:
        path = wanted.pop()
        if path in sizes:
            continue
        body, text = get(server, path)
        sizes[path] = body
        if path.startswith("/viser/"):
            continue
        found = re.findall(
            r"""(?:src|href)="([^"]+)"|(?:from|import) "([^"]+)"|url\("?([^")]+)""", text
        )
        for link in (next(filter(None, groups)) for groups in found):
            if link.endswith((".js", ".css", ".svg")):
                base = "/app/static/" if path == "/" else path
                wanted.append(urljoin(base, link))
    return sizes


def get(server, path):
    connection = HTTPConnection("127.0.0.1", server.port)
    connection.request("GET", path, headers={**cookie(server), "Accept-Encoding": "gzip"})
    answer = connection.getresponse()
    body = answer.read()
    assert answer.status == 200, path
    text = gzip.decompress(body) if answer.getheader("Content-Encoding") == "gzip" else body
    return len(body), text.decode("utf-8", "ignore")
