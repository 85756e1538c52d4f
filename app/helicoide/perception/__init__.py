"""Seeing the enclosure: point clouds from files and depth cameras, and the planes in them."""
