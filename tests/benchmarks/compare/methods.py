"""The methods that are compared, each from a demonstration to boundaries.

The others know less of demonstrations than keyphase, so they are helped where that is possible:
where only contact is labelled they see the wrench alone, one is told the true number, and what
they find may be of any kind. They are given means at a rate, 25 Hz for accuracy; keyphase and the
paper's method see every sample.
"""

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from itertools import pairwise

import numpy as np
from samples import samples

from keyphase.demonstration import Demonstration
from keyphase.scoring import Claim, Truth
from keyphase.segmentation import Parameters, segment

MIN_DURATION_S = 0.3
PENALTY = 2.0
"""Of the kernel detector: the best of 0.25 to 25 on other made recordings, as
`python tests/benchmarks/compare --choose-penalty --count 2` tries them."""
SLOW = 0.05
MAX_STATES = 8


@dataclass(frozen=True)
class Method:
    """A way from a demonstration and its truth (of which most look at nothing but whether only
    contact is labelled) to boundaries, given the rate of the means it works on; `told` says what it
    is told beyond the recording."""

    name: str
    find: Callable[[Demonstration, Truth, float], list[Claim]]
    told: str = ""


def keyphase(demonstration: Demonstration, truth: Truth, rate_hz: float) -> list[Claim]:
    """The default."""
    return _claims(demonstration, Parameters())


def paper(demonstration: Demonstration, truth: Truth, rate_hz: float) -> list[Claim]:
    """The paper's method with the choices made for it here."""
    return _claims(demonstration, Parameters(variant="paper"))


def author(demonstration: Demonstration, truth: Truth, rate_hz: float) -> list[Claim]:
    """The paper's method with its author's constants: R1 = R2 = 0.01, height 10."""
    constants = Parameters(
        variant="paper",
        measurement_noise=0.01,
        force_threshold=10.0,
        force_ratio=0.0,
        persistence=0.0,
    )
    return _claims(demonstration, constants)


def kernel_true_number(demonstration: Demonstration, truth: Truth, rate_hz: float) -> list[Claim]:
    """ruptures' kernel change points (radial), told how many there are."""
    number = len(truth.judged.events)
    return _kernel(demonstration, truth, rate_hz, n_bkps=number) if number else []


def kernel_penalty(demonstration: Demonstration, truth: Truth, rate_hz: float) -> list[Claim]:
    """The same with a penalty for each change."""
    return _kernel(demonstration, truth, rate_hz, pen=PENALTY)


def hidden_markov(demonstration: Demonstration, truth: Truth, rate_hz: float) -> list[Claim]:
    """hmmlearn's Gaussian hidden Markov model, 2 to 8 states by BIC: its changes of state."""
    import logging

    from hmmlearn.hmm import GaussianHMM

    logging.getLogger("hmmlearn").setLevel(logging.ERROR)
    taken = samples(demonstration, rate_hz)
    features = taken.features(_contact_only(truth))
    best, best_states = np.inf, None
    for count in range(2, MAX_STATES + 1):
        model = GaussianHMM(count, "diag", min_covar=1e-3, n_iter=30, random_state=0)
        try:
            states = model.fit(features).predict(features)
            criterion = model.bic(features)
        except ValueError:
            continue
        if criterion < best:
            best, best_states = criterion, states
    if best_states is None:
        return []
    changes = np.flatnonzero(np.diff(best_states)) + 1
    return _found(taken.time_s[changes], truth)


def speed_threshold(demonstration: Demonstration, truth: Truth, rate_hz: float) -> list[Claim]:
    """Where the speed passes 5 % of its 98 % quantile and stays there for 0.1 s."""
    taken = samples(demonstration, rate_hz)
    slow = taken.speed_m_s < SLOW * np.quantile(taken.speed_m_s, 0.98)
    changes = [0, *(np.flatnonzero(np.diff(slow)) + 1).tolist(), len(slow)]
    kept = [b for a, b in pairwise(changes) if b - a >= 0.1 * rate_hz]
    return _found(taken.time_s[[each for each in kept if each < len(slow)]], truth)


METHODS = (
    Method("keyphase", keyphase),
    Method("the paper's method", paper),
    Method("its author's constants", author),
    Method("ruptures, true number", kernel_true_number, "how many"),
    Method("ruptures, penalty", kernel_penalty, "a penalty"),
    Method("HMM (hmmlearn)", hidden_markov),
    Method("speed threshold", speed_threshold),
)


def _claims(demonstration: Demonstration, parameters: Parameters) -> list[Claim]:
    return [
        Claim(b.time_s, b.contact_change, b.confidence, b.origin != "force")
        for b in segment(demonstration, parameters).boundaries
    ]


def _kernel(
    demonstration: Demonstration, truth: Truth, rate_hz: float, **number: float
) -> list[Claim]:
    import ruptures

    taken = samples(demonstration, rate_hz)
    features = taken.features(_contact_only(truth))
    least = max(2, round(MIN_DURATION_S * rate_hz))
    detector = ruptures.KernelCPD("rbf", min_size=least, params={"gamma": 1.0 / features.shape[1]})
    most = max(1, len(features) // least - 1)
    if "n_bkps" in number:
        number["n_bkps"] = min(int(number["n_bkps"]), most)
    ends = detector.fit(features).predict(**number)[:-1]
    return _found(taken.time_s[np.asarray(ends, int)] if ends else [], truth)


def _contact_only(truth: Truth) -> bool:
    return truth.judged.what == "contact"


def found_by_others(times_s: Sequence[float], truth: Truth) -> list[Claim]:
    """Boundaries of a method that knows no kinds: all of them are judged, as kindly as may be."""
    return _found(times_s, truth)


def _found(times_s: Sequence[float] | np.ndarray, truth: Truth) -> list[Claim]:
    return [Claim(float(time), _contact_only(truth), 0.5) for time in times_s]
