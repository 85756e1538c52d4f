"""Files that people write and name.

Each function raises a HelicoideError that holds the reason alone; who calls it adds which file it is and what is valid.
"""
