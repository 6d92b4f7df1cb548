"""Any robot with a named tool frame: its looks for display, and one arm's kinematics.

Built on Pinocchio (kinematics) and yourdfpy (meshes); nothing here draws or moves anything.
"""
