"""The threads of a server share few heaps, so that its memory does not grow with its pages."""

import platform
import subprocess
import sys
from pathlib import Path

import pytest

_HEAPS = """
import ctypes, sys, threading

if sys.argv[1] == "few":
    from keyphase.web.memory import keep_few_heaps

    keep_few_heaps()
held, meet = [], threading.Barrier(9)

def allocate():
    held.append(bytearray(100_000))
    meet.wait()

threads = [threading.Thread(target=allocate) for _ in range(8)]
for thread in threads:
    thread.start()
libc = ctypes.CDLL(None)
libc.fopen.restype = ctypes.c_void_p
file = ctypes.c_void_p(libc.fopen(sys.argv[2].encode(), b"w"))
libc.malloc_info(0, file)
libc.fclose(file)
meet.wait()
"""


def heaps(folder: Path, how: str) -> int:
    told = folder / how
    subprocess.run([sys.executable, "-c", _HEAPS, how, str(told)], check=True)
    return told.read_text().count("<heap ")


@pytest.mark.skipif(platform.libc_ver()[0] != "glibc", reason="other C libraries have no arenas")
def test_threads_share_two_heaps(tmp_path: Path) -> None:
    assert heaps(tmp_path, "few") <= 2
    assert heaps(tmp_path, "many") > 2
