"""All postures for a tool pose: what they are called, how they are found, and which is nearest."""
