"""The memory of a server that runs for days.

Every thread that allocates gets a heap of its own from glibc, up to eight for each core, and what
is freed in one is not used by the others. A server whose pages come and go, each with threads of
its own, therefore grows without holding anything more.
"""

import ctypes
import sys

_M_ARENA_MAX = -8
"""The parameter's number in glibc's malloc.h."""


def keep_few_heaps(most: int = 2) -> None:
    """Let all threads of this process share at most so many heaps.

    To be called before threads are started; where the C library knows no such limit (macOS, musl)
    nothing is changed.
    """
    mallopt = getattr(ctypes.CDLL(None), "mallopt", None) if sys.platform == "linux" else None
    if mallopt is not None:
        mallopt(_M_ARENA_MAX, most)
