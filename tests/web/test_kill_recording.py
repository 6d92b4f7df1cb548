"""A server that is killed while it records loses the last second at most."""

import os
import re
import signal
import subprocess
import sys
from pathlib import Path

import pytest

from keyphase.readers import read

RECORDS = """
import sys, threading
from pathlib import Path
from keyphase.web.server import PageServer

server = PageServer([], folder=Path(sys.argv[1]))
lead = server.workbench.enter("page").lead
lead.record("setup1")
pause = threading.Event()
while True:
    pause.wait(0.05)
    print(f"{lead.status().running.recorded_s:.3f}", flush=True)
"""


@pytest.mark.slow
def test_at_most_a_second_is_lost_and_the_rest_is_recovered(tmp_path: Path) -> None:
    recorder = subprocess.Popen(
        [sys.executable, "-c", RECORDS, str(tmp_path)], stdout=subprocess.PIPE, text=True
    )
    assert recorder.stdout is not None
    recorded_s = next(s for line in recorder.stdout if (s := float(line)) > 2.0)
    os.kill(recorder.pid, signal.SIGKILL)
    recorder.wait()
    recorder.stdout.close()

    assert [path.name for path in tmp_path.glob("*.npz*")] == ["setup1_01.npz.take"]
    assert "Recovered" in started_and_stopped(tmp_path)
    recovered = read(tmp_path / "setup1_01.npz")
    assert recovered.duration_s > recorded_s - 1.0
    assert recovered.metadata["recovered"] is True
    assert not list(tmp_path.glob("*.take"))


def started_and_stopped(folder: Path) -> str:
    """What `keyphase open` says of a folder on standard error."""
    keyphase = Path(sys.executable).parent / "keyphase"
    if not keyphase.exists():
        pytest.skip("the command keyphase is not installed beside this Python")
    command = [str(keyphase), "open", "--no-browser", str(folder)]
    server = subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
    assert server.stdout is not None
    assert server.stderr is not None
    link = server.stdout.readline()
    assert re.match(r"http://127\.0\.0\.1:\d+/\?token=", link)
    server.send_signal(signal.SIGINT)
    _, said = server.communicate(timeout=30)
    return said
