"""The recording in the scene: its path and marks, the ground below, where it is seen from."""
