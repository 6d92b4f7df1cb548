"""A bound on memory while a library in C looks into a file it may misread.

A damaged size or a ring of references in a file of some kilobytes makes such a library take all
memory there is; the system then ends whatever program it likes.
"""

import threading
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

_TIMES_THE_FILE = 4
_ROOM_BYTES = 64 << 20
_ONE_AT_A_TIME = threading.RLock()
"""The bound is the whole process's; two could not be told apart."""


@contextmanager
def memory_bounded(path: Path) -> Iterator[None]:
    """Within, taking more than four times the file's size, and 64 MB, raises MemoryError.

    Only where the system keeps such a bound (Linux); elsewhere nothing is bounded.
    """
    taken = _address_space_bytes()
    if taken is None:
        yield
        return
    import resource

    size = path.stat().st_size if path.is_file() else 0
    with _ONE_AT_A_TIME:
        soft, hard = resource.getrlimit(resource.RLIMIT_AS)
        most = taken + _TIMES_THE_FILE * size + _ROOM_BYTES
        bound = min(limit for limit in (most, soft, hard) if limit != resource.RLIM_INFINITY)
        resource.setrlimit(resource.RLIMIT_AS, (bound, hard))
        try:
            yield
        finally:
            resource.setrlimit(resource.RLIMIT_AS, (soft, hard))


def _address_space_bytes() -> int | None:
    try:
        pages = int(Path("/proc/self/statm").read_text().split()[0])
    except (OSError, ValueError, IndexError):
        return None
    import resource

    return pages * resource.getpagesize()
