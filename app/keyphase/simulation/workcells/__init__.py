"""Simulated workcells: parts, seating, and the two set-ups."""
