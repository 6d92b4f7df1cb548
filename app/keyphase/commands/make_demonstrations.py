"""`keyphase make-demonstrations`: recordings with exact truth, to try a segmentation on."""

from dataclasses import dataclass
from functools import partial
from pathlib import Path

from keyphase.commands.saying import say


@dataclass(frozen=True)
class MakeDemonstrations:
    """Make demonstrations with exact truth: recordings and one truth.json that can be scored."""

    output: Path
    """Folder to write to: FAMILY/SEED.npz and truth.json."""
    families: tuple[str, ...] = ()
    """Which kinds of demonstrations; without any, all by formula. Those called simulated-… are made
    in MuJoCo."""
    count: int = 10
    """How many of each family."""
    seed: int = 0
    """Seed of the first; the others follow. The same seed gives the same bytes."""
    replace: bool = False
    """Replace files in the way that keyphase did not write, or that were changed since."""

    def run(self) -> int:
        """Make and write."""
        from tqdm import tqdm

        from keyphase.commands.putting import put
        from keyphase.making import BY_FORMULA, FAMILIES, make_folder

        families = self.families or tuple(FAMILIES)
        putting = partial(put, replace=self.replace)
        makers = dict(BY_FORMULA)
        if any(family.startswith("simulated") for family in families):
            from keyphase.simulation.making import SIMULATED, make_simulated

            makers |= dict.fromkeys(SIMULATED, make_simulated)
        with tqdm(unit="demonstration", disable=None) as bar:

            def progress(done: int, total: int) -> None:
                bar.total = total
                bar.update(done - bar.n)

            truth = make_folder(
                families, self.count, self.seed, self.output, progress, makers, putting
            )
        say(f"{self.count * len(families)} demonstrations and {truth}")
        return 0
