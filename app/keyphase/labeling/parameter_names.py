"""What undo and redo call a change of parameters, such as "Threshold 23.9"."""

from collections.abc import Mapping

_PARAMETERS: Mapping[str, str] = {
    "force_threshold": "Threshold",
    "force_ratio": "Ratio",
    "min_distance_s": "Minimal distance",
    "persistence": "Persistence",
    "process_noise_ratio": "Process noise ratio",
    "measurement_noise": "Measurement noise",
    "engine": "Engine",
    "gaussians": "Gaussians",
    "variant": "Method",
    "mixture": "Mixture",
    "motion_threshold": "Motion threshold",
    "turns": "Turns",
    "least_step_N": "Least force step",
    "estimator": "Estimator",
    "seed": "Seed",
    "merge_tolerance_s": "Merge tolerance",
}

_VALUES: Mapping[tuple[str, object], str] = {("variant", "paper"): "as published"}
"""Values that the page calls otherwise."""


def parameters_name(changes: Mapping[str, object]) -> str:
    """Name of a change of parameters, given the new value of each."""
    if len(changes) != 1:
        return f"Change {len(changes)} parameters"
    ((name, value),) = changes.items()
    return parameter_text(name, value)


def parameter_text(name: str, value: object) -> str:
    """A parameter and its value, such as "Gaussians 5" or "Threshold automatic"."""
    shown = "automatic" if value is None else f"{value:.4g}" if isinstance(value, float) else value
    return f"{_PARAMETERS.get(name, name)} {_VALUES.get((name, value), shown)}"
