"""Measuring the enclosure: point clouds from files and depth cameras, and planes fitted to them."""
