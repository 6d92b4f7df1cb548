"""Whose hand it is: calm or hasty, with long ways or short, pressing hard or lightly."""

from dataclasses import dataclass

import numpy as np
from scipy.spatial.transform import Rotation

from keyphase.making.draws import Array, band_noise, log_uniform, low_noise


@dataclass(frozen=True)
class Hand:
    """How one person moves and presses.

    tempo      seconds that a stroke of usual length takes: 0.35 is hasty, 2 is calm
    stroke_m   usual length of a stroke
    turn_rad   how far the tool turns in a stroke, at most
    newton     usual contact force
    patience_s usual length of a rest
    tremor_m, sway_m   root mean square of its trembling (3 to 12 Hz) and swaying (under 1 Hz)
    """

    tempo: float
    stroke_m: float
    turn_rad: float
    newton: float
    patience_s: float
    tremor_m: float
    sway_m: float

    @classmethod
    def drawn(cls, rng: np.random.Generator) -> "Hand":
        """Any hand."""
        stroke_m = log_uniform(rng, 0.06, 0.5)
        size = min(stroke_m / 0.2, 1.0)
        return cls(
            tempo=log_uniform(rng, 0.35, 2.0),
            stroke_m=stroke_m,
            turn_rad=float(rng.choice([0.0, 0.1, 0.5])),
            newton=log_uniform(rng, 1.5, 40.0),
            patience_s=log_uniform(rng, 0.4, 2.0),
            tremor_m=size * log_uniform(rng, 1e-5, 4e-4),
            sway_m=size * log_uniform(rng, 5e-5, 1e-3),
        )

    def unsteady(
        self, rng: np.random.Generator, position: Array, rotation: Rotation, rate_hz: float
    ) -> tuple[Array, Rotation]:
        """The path as this hand goes along it: it trembles and sways, in place and in turning."""
        count = len(position)
        position = (
            position
            + low_noise(rng, count, rate_hz, 1.0, self.sway_m)
            + band_noise(rng, count, rate_hz, (3.0, 12.0), self.tremor_m)
        )
        turned = low_noise(rng, count, rate_hz, 1.0, log_uniform(rng, 1e-4, 4e-3))
        return position, rotation * Rotation.from_rotvec(turned)
