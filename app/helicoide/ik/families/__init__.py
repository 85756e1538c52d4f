"""Families of arms that closed forms know: recognised from their axes, with the geometry of their plane and elbow."""
