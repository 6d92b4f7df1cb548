"""One warm process that tries case after case and writes a line before and after each.

    python worker.py SEED FIRST LAST [KIND …]

The time of a case is the processor's: one that takes more than TIME_S ends the process.
"""

import json
import random
import resource
import signal
import sys
import tempfile
import warnings
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parents[1]))

from fuzzing.kinds import KINDS, Kind
from fuzzing.mutating import mutated, reseal
from keyphase.errors import KeyphaseError

TIME_S = 10
TIMES_ITS_SIZE = 4
CONSTANT_BYTES = 64 * 1024**2
"""What a case may take beside: tables of types, code that is loaded when first needed."""
ROOM_BYTES = 4 * 1024**3


def main() -> None:
    """Try the cases FIRST to LAST."""
    seed, first, last = (int(word) for word in sys.argv[1:4])
    resource.setrlimit(resource.RLIMIT_AS, (ROOM_BYTES, ROOM_BYTES))
    wanted = sys.argv[4:] or list(KINDS)
    kinds = {name: KINDS[name] for name in wanted}
    names = [name for name, kind in kinds.items() for _ in range(kind.weight)]
    with tempfile.TemporaryDirectory() as folder:
        sound = {}
        for number, (name, kind) in enumerate(kinds.items()):
            place = Path(folder, f"sound-{number}")
            place.mkdir()
            sound[name] = kind.make(place)
            kind.use(sound[name])
        for case in range(first, last):
            chance = random.Random(f"{seed}/{case}")
            name = names[case % len(names)]
            _say(case=case, kind=name)
            _say(**_tried(KINDS[name], sound[name], Path(folder), chance))


def _tried(kind: Kind, sound: Path, folder: Path, chance: random.Random) -> dict[str, object]:
    target = _target(kind, sound, chance)
    before = target.read_bytes()
    change = reseal if chance.random() < 0.5 else _plainly
    data = change(target.name, before, chance)
    target.write_bytes(data)
    try:
        with _limited() as peak, warnings.catch_warnings():
            warnings.simplefilter("ignore")
            outcome, said = _outcome(kind, sound)
        allowed = TIMES_ITS_SIZE * _size(sound) + CONSTANT_BYTES
        if peak[0] > allowed:
            outcome, said = "memory", f"{peak[0] >> 20} MB for {_size(sound)} bytes; {said}"
        return {"outcome": outcome, "said": said}
    finally:
        target.write_bytes(before)


def _plainly(_name: str, data: bytes, chance: random.Random) -> bytes:
    return mutated(data, chance)


def _target(kind: Kind, sound: Path, chance: random.Random) -> Path:
    if not kind.target:
        return sound
    return chance.choice(sorted(p for p in sound.parent.glob(kind.target) if p.is_file()))


def _outcome(kind: Kind, path: Path) -> tuple[str, str]:
    try:
        kind.use(path)
    except KeyphaseError as error:
        text = str(error)
        return ("a message of several lines", text) if "\n" in text else ("refused", "")
    except AssertionError as error:
        return "differs", str(error)
    except BaseException as error:
        return "unexpected", _where(error)
    return "read", ""


def _where(error: BaseException) -> str:
    import traceback

    frames = traceback.extract_tb(error.__traceback__)
    own = [f"{Path(f.filename).name}:{f.lineno}" for f in frames if "keyphase" in f.filename]
    return f"{type(error).__name__}: {str(error)[:150]} at {' '.join(own[-3:])}"


@contextmanager
def _limited() -> Iterator[list[int]]:
    """Memory at its peak [bytes] beyond what was taken before, in processor time of TIME_S."""
    peak = [0]
    before = _memory("VmRSS")
    Path("/proc/self/clear_refs").write_text("5")
    signal.setitimer(signal.ITIMER_PROF, TIME_S)
    try:
        yield peak
    finally:
        signal.setitimer(signal.ITIMER_PROF, 0)
        peak[0] = _memory("VmHWM") - before


def _memory(key: str) -> int:
    for line in Path("/proc/self/status").read_text().splitlines():
        if line.startswith(key):
            return int(line.split()[1]) * 1024
    return 0


def _size(path: Path) -> int:
    files = [path] if path.is_file() else [p for p in path.rglob("*") if p.is_file()]
    return sum(file.stat().st_size for file in files)


def _say(**line: object) -> None:
    sys.stdout.write(json.dumps(line) + "\n")
    sys.stdout.flush()


if __name__ == "__main__":
    main()
