"""Clifford algebras, rigid motions and rotations: pure numpy, without robots."""
