"""The 3D scene through viser."""
