"""LeRobot datasets v2.1 and v3.0, into a copy: language columns, SARM stages, tasks, progress."""
