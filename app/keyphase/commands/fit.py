"""`keyphase fit`: the weights of the evidence, fitted anew from made demonstrations."""

from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING

from keyphase.commands.saying import say

if TYPE_CHECKING:
    from keyphase.making import Made
    from keyphase.segmentation.evidence.fitting.taught import Taught


_MADE_FROM = "keyphase fit"

SET_UPS = ("setup1", "setup2")
"""Families that the simulator records."""


@dataclass(frozen=True)
class FitWeights:
    """Fit the weights of the evidence on made demonstrations, and write them with provenance.

    The same count and seed give the same bytes. What keyphase ships was written by
    `keyphase fit --count 8 --seed 0`.
    """

    output: Path
    """File to write, JSON."""
    count: int = 8
    """How many demonstrations of each family."""
    seed: int = 0
    """Seed of the first of each family; the others follow."""
    families: tuple[str, ...] = ()
    """Families to fit on; none given: all by formula, and the two set-ups, recorded in MuJoCo."""
    replace: bool = False
    """Replace a file in the way that keyphase did not write, or that was changed since."""

    def run(self) -> int:
        """Make, look, fit and write."""
        import json

        from tqdm import tqdm

        from keyphase.commands.putting import put, refuse_in_the_way
        from keyphase.errors import MakingError
        from keyphase.making import FAMILIES
        from keyphase.segmentation.evidence.fitting.fit import fit
        from keyphase.segmentation.evidence.weights import weights_as_json

        refuse_in_the_way(self.output, _MADE_FROM, replace=self.replace)
        families = self.families or (*FAMILIES, *SET_UPS)
        jobs = [(family, self.seed + k) for family in families for k in range(self.count)]
        bar = tqdm(jobs, unit="demonstration", disable=None)
        weights = fit([_taught(_made(family, seed)) for family, seed in bar], bar.write)
        provenance = {
            "command": f"keyphase fit --count {self.count} --seed {self.seed}",
            "recordings": len(jobs),
            "families": list(families),
        }
        text = json.dumps(weights_as_json(weights, provenance), indent=1)
        data = f"{text}\n".encode()
        put(self.output, data, _MADE_FROM, replace=self.replace, refusal=MakingError)
        say(f"{len(jobs)} demonstrations and {self.output}")
        return 0


def _made(family: str, seed: int) -> "Made":
    if family not in SET_UPS:
        from keyphase.making import make

        return make(family, seed)
    from keyphase.simulation.making import recorded_set_up

    return recorded_set_up(family, seed)


def _taught(made: "Made") -> "Taught":
    import numpy as np

    from keyphase.segmentation.evidence.fitting.taught import Truth, taught

    def pairs(values: object) -> np.ndarray:
        return np.array(values, dtype=float).reshape(-1, 2)

    truth = Truth(
        time_s=np.array([event.time_s for event in made.events], dtype=float),
        window_s=pairs([event.window_s for event in made.events]),
        contact=np.array([event.kind == "contact" for event in made.events], dtype=bool),
        ignore=pairs(made.ignore_s),
        ignore_motion=pairs(made.ignore_motion_s),
    )
    return taught(made.family, made.demonstration, truth)
