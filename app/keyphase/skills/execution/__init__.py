"""Executing skills: pose, velocity and wrench in, reference out; no simulator, no demonstration."""
