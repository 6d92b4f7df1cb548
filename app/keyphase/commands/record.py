"""The command `keyphase record`: a scripted operator in a simulated workcell."""

from dataclasses import dataclass
from pathlib import Path

import tyro

from keyphase.commands.saying import say


@dataclass(frozen=True)
class Record:
    """Record a demonstration of a scripted operator in a simulated workcell."""

    workcell: tyro.conf.Positional[str]
    """setup1 or setup2."""
    output: Path
    """The recording to write (NPZ)."""
    seed: int = 0
    """The same seed gives the same recording."""
    replace: bool = False
    """Replace a file in the way that is not of this workcell and seed as keyphase wrote it."""

    def run(self) -> int:
        """Record and write."""
        from keyphase.commands.putting import put, refuse_in_the_way
        from keyphase.readers import npz_data
        from keyphase.simulation import record

        made_from = f"{self.workcell}, seed {self.seed}"
        refuse_in_the_way(self.output, made_from, replace=self.replace)
        demonstration = record(self.workcell, seed=self.seed)
        put(self.output, npz_data(demonstration), made_from, replace=self.replace)
        say(f"{self.output}: {demonstration.duration_s:.2f} s at {demonstration.rate_hz:g} Hz")
        return 0
