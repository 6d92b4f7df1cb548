"""Where the thresholds lie when nobody has moved them: the notches on their sliders."""

from keyphase.segmentation.evidence.weights import shipped_weights
from keyphase.segmentation.segmentation import Segmentation


def automatic_threshold(segmentation: Segmentation) -> float | None:
    """The automatic force threshold; None where no force was recorded."""
    if segmentation.curve is None:
        return None
    if segmentation.parameters.variant == "paper":
        return segmentation.curve.automatic_threshold
    return shipped_weights().contact_calibration.line


def automatic_motion_threshold(segmentation: Segmentation) -> float | None:
    """The automatic threshold for boundaries of motion; None in variant paper."""
    if segmentation.motion_threshold is None:
        return None
    return shipped_weights().motion_calibration.line
