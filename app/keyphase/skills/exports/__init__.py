"""Skills for other programs: files, behaviour trees, robot programs, listings."""
