"""The command `keyphase record`: a scripted operator in a simulated workcell."""

from dataclasses import dataclass
from pathlib import Path

import tyro


@dataclass(frozen=True)
class Record:
    """Record a demonstration of a scripted operator in a simulated workcell."""

    workcell: tyro.conf.Positional[str]
    """setup1 or setup2."""
    output: Path
    """The recording to write (NPZ)."""
    seed: int = 0
    """The same seed gives the same recording."""

    def run(self) -> int:
        """Record and write."""
        from keyphase.readers import save_npz
        from keyphase.simulation import record

        demonstration = record(self.workcell, seed=self.seed)
        save_npz(demonstration, self.output)
        print(f"{self.output}: {demonstration.duration_s:.2f} s at {demonstration.rate_hz:g} Hz")
        return 0
