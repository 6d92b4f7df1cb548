"""Replay and trials of a plan at work, for whoever asked for them."""
