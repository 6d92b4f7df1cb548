"""A bound on memory while a library in C looks into a file it may misread.

A damaged size or a ring of references in a file of some kilobytes makes such a library take all
memory there is; the system then ends whatever program it likes.
"""

import threading
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

_TIMES_THE_FILE = 32
"""So many times a file's size what is in it may take: channels that are held are packed well."""
_ROOM_BYTES = 64 << 20
_ONE_AT_A_TIME = threading.RLock()
"""The bound is the whole process's; two could not be told apart."""


@contextmanager
def memory_bounded(path: Path) -> Iterator[None]:
    """Within, taking more than 32 times the file's size, and 64 MB, raises MemoryError.

    Of a folder the files right in it count. Only where the system keeps such a bound (Linux);
    elsewhere nothing is bounded.
    """
    taken = _address_space_bytes()
    if taken is None:
        yield
        return
    import resource

    files = path.iterdir() if path.is_dir() else [path]
    size = sum(file.stat().st_size for file in files if file.is_file())
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
