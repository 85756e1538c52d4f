"""Reading files that people write and name.

Each function raises a HelicoideError with the reason alone; the caller adds the name of the file and what is valid.
"""
