"""Another segmentation of a recording: how it agrees with this one, and taking it over."""
