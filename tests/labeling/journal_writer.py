"""A program that streams random edits into a journal until it is killed, saying what it does.

    python journal_writer.py RECORDING SEED

Before each save it prints "next DIGEST" with the digest of what it is about to save, after it
"done DIGEST".
"""

import hashlib
import random
import sys
from pathlib import Path

from handmade import demonstration, described, segmentation

from keyphase.errors import LabelingError
from keyphase.labeling.edits import Accept, Add, Keep, Label, Merge, Move, Plan, Remove
from keyphase.labeling.label import label
from keyphase.labeling.storage.journal import Journal
from keyphase.segmentation.parameters import Parameters


def digest(document):
    """Of everything a restart must bring back."""
    history = document.history
    return hashlib.sha256(repr((history, document.parameters)).encode()).hexdigest()


def random_change(document, labeling, chance):
    """The document after something a person might do."""
    a, b = chance.uniform(0, 10), chance.uniform(0, 10)
    edits = [
        Add(a),
        Remove(a),
        Move(a, a + chance.uniform(-0.1, 0.1)),
        Label(a, chance.choice("abcdefgh") * chance.randrange(1, 150)),
        Keep(a, chance.random() < 0.5),
        Accept(a),
        Merge(a, b),
        Plan(tuple(s.middle_s for s in labeling.segments if s.kept)[::-1]),
    ]
    match chance.randrange(12):
        case 0 | 1:
            return document.undo()
        case 2:
            return document.redo()
        case 3:
            return document.set_parameters(Parameters(force_ratio=chance.uniform(1, 100)))
        case _:
            return document.apply(chance.choice(edits), labeling)


def main(recording, seed):
    """Edit until killed."""
    demo = demonstration(path=recording)
    found = segmentation(made_from=demo)
    chance = random.Random(seed)
    journal = Journal(demo)
    document = journal.document
    print(f"done {digest(document)}", flush=True)
    while True:
        try:
            document = random_change(document, label(found, document.edits, described), chance)
        except LabelingError:
            continue
        print(f"next {digest(document)}", flush=True)
        journal.save(document)
        print(f"done {digest(document)}", flush=True)


if __name__ == "__main__":
    main(Path(sys.argv[1]), int(sys.argv[2]))
