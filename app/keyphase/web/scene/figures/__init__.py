"""Things that move in the scene: robots, parts, forces."""
