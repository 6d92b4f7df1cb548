"""Two pages act at random on a server for as long as asked: its memory and threads meanwhile.

python tests/benchmarks/bench_memory.py --minutes 60
"""

import argparse
import json
import random
import shutil
import statistics
import sys
import tempfile
import threading
import time
from collections import Counter
from collections.abc import Callable
from contextlib import suppress
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parents[1] / "web"))
sys.path.insert(0, str(Path(__file__).parents[1] / "workbench"))

from serving import Served, serving
from talking import Message, PageClient
from two_pages import act
from websockets.exceptions import ConnectionClosed

from keyphase.files.shipped import shipped

NAMES = "abcde"
WARM_UP_S = 300.0
"""So long all that is used is used often, so that caches are full before anyone looks: every desk
then remembers as many revisions as it ever will."""

WARM_UP_PER_SECOND = 10.0
LOOK_EVERY_S = 5.0
FLAT = 0.05


class ActingPage:
    """A page on a socket, as `act` needs it: it knows what it was told last of each kind."""

    def __init__(self, served: Served) -> None:
        self.told: dict[str, Message] = {}
        self.counts: Counter[str] = Counter()
        self._known = threading.Event()
        self._client = PageClient(served)  # type: ignore[arg-type]
        self._thread = threading.Thread(target=self._listen)
        self._thread.start()

    def document(self) -> Message:
        """What is looked at, waited for."""
        if not self._known.wait(60.0):
            raise TimeoutError("a page was told of no document within a minute")
        return self.told["document"]

    def until(self, holds: Callable[[Message], bool]) -> None:
        """Wait until what is looked at is as it should be; a minute at most."""
        end = time.monotonic() + 60.0
        while not holds(self.document()):
            if time.monotonic() > end:
                raise TimeoutError
            time.sleep(0.05)

    def say(self, kind: str, document: Message | None = None, /, **fields: object) -> None:
        """Say something, about a document as this page saw it."""
        self.counts[kind] += 1
        about = {"recording": document["id"], "revision": document["revision"]} if document else {}
        self._client.send_raw(json.dumps({"type": kind, **about, **fields}))

    def leave(self) -> None:
        """Close the page."""
        self._client.close()
        self._thread.join()

    def _listen(self) -> None:
        try:
            while True:
                told = self._client.receive()
                if isinstance(told, dict):
                    self.told[told["type"]] = told
                    if told["type"] == "document":
                        self._known.set()
        except (ConnectionClosed, TimeoutError):
            return


def main() -> int:
    """Run; the exit status says whether memory was flat and no thread was left over."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--minutes", type=float, default=60.0)
    parser.add_argument("--per-second", type=float, default=2.0, help="actions of each page")
    parser.add_argument("--slow", type=float, default=0.002, help="share that fits anew")
    parser.add_argument("--stay-s", type=float, default=120.0, help="how long a page stays")
    parser.add_argument("--seed", type=int, default=1)
    options = parser.parse_args()
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        for recording in NAMES:
            shutil.copy(shipped("data") / "synthetic_setup1.npz", folder / f"{recording}.npz")
        with serving(folder) as served:
            _warm_up(served, options.seed)
            looks, actions = _run(served, options)
    return _tell(looks, actions, options.minutes)


def _warm_up(served: Served, seed: int) -> None:
    """Every recording is fitted by both methods, then two pages act fast."""
    page = ActingPage(served)
    page.document()
    for item in page.told["recordings"]["items"]:
        page.say("open", id=item["id"])
        page.until(lambda document, shown=item: document["id"] == shown["id"])
        for variant in ("paper", "evidence"):
            page.say("set", page.document(), parameter="variant", value=variant)
            page.until(lambda document, now=variant: document["parameters"]["variant"] == now)
    page.leave()
    workers = [
        threading.Thread(target=_act_fast, args=(served, 1000 * seed + 500 + number, str(number)))
        for number in range(2)
    ]
    for worker in workers:
        worker.start()
    for worker in workers:
        worker.join()


def _act_fast(served: Served, seed: int, own: str) -> None:
    page, chance, end = ActingPage(served), random.Random(seed), time.monotonic() + WARM_UP_S
    with suppress(ConnectionClosed):
        while time.monotonic() < end:
            act(page, chance, own, slow=0.01)
            time.sleep(chance.expovariate(WARM_UP_PER_SECOND))
    page.leave()


def _run(served: Served, options: argparse.Namespace) -> tuple[list[tuple[float, float, int]], int]:
    """Looks (seconds, MB resident, threads), and how many actions there were."""
    begun = time.monotonic()
    over = threading.Event()
    counts = [Counter[str](), Counter[str]()]
    workers = [
        threading.Thread(target=_act_on, args=(served, options, number, over, counts[number]))
        for number in range(2)
    ]
    for worker in workers:
        worker.start()
    looks = []
    while time.monotonic() - begun < 60.0 * options.minutes:
        time.sleep(LOOK_EVERY_S)
        looks.append((time.monotonic() - begun, *_status(served.pid)))
        if len(looks) % 12 == 0:
            seconds, megabytes, threads = looks[-1]
            print(f"{seconds:6.0f} s  {megabytes:7.1f} MB  {threads:3d} threads", flush=True)
    over.set()
    for worker in workers:
        worker.join()
    return looks, sum(count.total() for count in counts)


def _act_on(
    served: Served,
    options: argparse.Namespace,
    number: int,
    over: threading.Event,
    counts: Counter[str],
) -> None:
    """One person: acts, closes the page now and then, and opens another."""
    chance = random.Random(1000 * options.seed + number)
    while not over.is_set():
        page, stays_until = ActingPage(served), time.monotonic() + options.stay_s
        # A busy machine answers a ping too late now and then; a page connects again.
        with suppress(ConnectionClosed):
            while time.monotonic() < stays_until and not over.is_set():
                act(page, chance, str(number), options.slow)
                over.wait(chance.expovariate(options.per_second))
        page.leave()
        counts.update(page.counts)


def _status(pid: int) -> tuple[float, int]:
    text = Path(f"/proc/{pid}/status").read_text()
    kilobytes = int(text.split("VmRSS:")[1].split()[0])
    return kilobytes / 1024, int(text.split("Threads:")[1].split()[0])


def _tell(looks: list[tuple[float, float, int]], actions: int, minutes: float) -> int:
    tenth = max(len(looks) // 10, 1)
    first = statistics.median(look[1] for look in looks[:tenth])
    last = statistics.median(look[1] for look in looks[-tenth:])
    threads = [max(look[2] for look in part) for part in (looks[:tenth], looks[-tenth:])]
    hours = (looks[-1][0] - looks[0][0]) / 3600.0
    growth = last / first - 1.0
    print(
        f"{actions} actions in {minutes:g} min: {first:.1f} MB after warming up, {last:.1f} MB at "
        f"the end ({growth:+.1%}, {(last - first) / hours:+.1f} MB an hour); at most "
        f"{threads[0]} threads then, {threads[1]} at the end"
    )
    return 0 if abs(growth) <= FLAT and threads[1] <= threads[0] else 1


if __name__ == "__main__":
    sys.exit(main())
