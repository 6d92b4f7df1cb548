"""Names of segments as formats want them."""

from collections import Counter
from collections.abc import Sequence


def numbered(names: Sequence[str]) -> tuple[str, ...]:
    """The names, each once: the second `insert` is `insert (2)`."""
    seen: Counter[str] = Counter()
    unique = []
    for name in names:
        seen[name] += 1
        unique.append(name if seen[name] == 1 else f"{name} ({seen[name]})")
    return tuple(unique)
