"""Journals that other programs delete, replace or cut while a page edits, and two servers at once.

python tests/benchmarks/touch_journals.py --times 200
"""

import argparse
import random
import shutil
import sys
import tempfile
from collections import Counter
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parents[1] / "workbench"))

from two_pages import TalkingPage, workbench_on

from keyphase.labeling.edits import Label
from keyphase.labeling.storage.journal import Journal
from keyphase.readers import read
from keyphase.workbench.workbench import Settings, Workbench


def delete(journal: Path, chance: random.Random) -> None:
    """As a person deletes it."""
    journal.unlink()


def delete_folder(journal: Path, chance: random.Random) -> None:
    """As a person deletes all that is hidden."""
    shutil.rmtree(journal.parent)


def replace(journal: Path, chance: random.Random) -> None:
    """By the same bytes, as programs do that keep folders alike."""
    copy = journal.with_name("copy")
    shutil.copy(journal, copy)
    copy.replace(journal)


def put_back(journal: Path, chance: random.Random) -> None:
    """By an older state, as a backup does."""
    lines = journal.read_bytes().splitlines(keepends=True)
    copy = journal.with_name("copy")
    copy.write_bytes(b"".join(lines[: chance.randrange(len(lines))]))
    copy.replace(journal)


def cut(journal: Path, chance: random.Random) -> None:
    """In place, anywhere."""
    data = journal.read_bytes()
    journal.write_bytes(data[: chance.randrange(len(data))])


TOUCHES = (delete, delete_folder, replace, put_back, cut)


def main() -> int:
    """Touch as often as asked; the exit status says whether anything was lost or unmentioned."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--times", type=int, default=200)
    parser.add_argument("--seed", type=int, default=1)
    options = parser.parse_args()
    chance = random.Random(options.seed)
    with tempfile.TemporaryDirectory() as name:
        lost = _touched(Path(name), options.times, chance)
    with tempfile.TemporaryDirectory() as name:
        lost += _two_servers(Path(name), options.times, chance)
    return 1 if lost else 0


def _touched(folder: Path, times: int, chance: random.Random) -> int:
    workbench = workbench_on(folder, "a")
    page = TalkingPage(workbench, "page")
    journal = folder / ".keyphase" / "a.npz.journal"
    counts: Counter[str] = Counter()
    unmentioned = 0
    confirmed = [_label(page, 0)]
    for number in range(1, times + 1):
        touch = chance.choice(TOUCHES)
        counts[touch.__name__] += 1
        touch(journal, chance)
        confirmed.append(_label(page, number))
        told = page.told["document"]["notices"]
        unmentioned += not any("Another program touched" in notice["text"] for notice in told)
    workbench.close()
    lost = _lost(folder, confirmed)
    what = ", ".join(f"{count} {name}" for name, count in sorted(counts.items()))
    print(f"{times} journals touched while open ({what}): {len(confirmed)} edits confirmed, "
          f"{lost} lost, {unmentioned} touches unmentioned")  # fmt: skip
    return lost + unmentioned


def _two_servers(folder: Path, times: int, chance: random.Random) -> int:
    """Both try to edit one recording; now and then the one that may closes, and comes back."""
    first = workbench_on(folder, "a")
    servers = [first, Workbench([folder / "a.npz"], Settings(folder=folder))]
    pages = [TalkingPage(server, f"page {k}") for k, server in enumerate(servers)]
    confirmed: list[str] = []
    refused = 0
    for number in range(times):
        who = chance.randrange(2)
        label = _label(pages[who], number)
        if label:
            confirmed.append(label)
        refused += not label
        if chance.random() < 0.05:
            servers[who].close()
            servers[who] = Workbench([folder / "a.npz"], Settings(folder=folder))
            pages[who] = TalkingPage(servers[who], f"page {who}")
    for server in servers:
        server.close()
    lost = _lost(folder, confirmed)
    print(f"two servers on one folder: {len(confirmed)} edits confirmed, {refused} refused, "
          f"{lost} lost")  # fmt: skip
    return lost


def _label(page: TalkingPage, number: int) -> str:
    """An edit; its label where it was confirmed, nothing where it was refused."""
    label, document = f"edit {number}", page.document()
    revision, before = document["revision"], len(page.refused)
    edit = {"kind": "label", "time_s": 0.1, "label": label}
    page.say("edit", document, edit=edit, event=number)
    page.wait_for(
        lambda: page.told["document"]["revision"] != revision or len(page.refused) > before
    )
    return label if len(page.refused) == before else ""


def _lost(folder: Path, confirmed: list[str]) -> int:
    with Journal(read(folder / "a.npz"), read_only=True) as journal:
        edits = journal.document.edits.values()
    there = [edit.label for edit in edits if isinstance(edit, Label)]
    return sum(label not in there for label in confirmed)


if __name__ == "__main__":
    sys.exit(main())
