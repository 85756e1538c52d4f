"""All postures for a tool pose: their solvers, their names, and the choice of the nearest."""
