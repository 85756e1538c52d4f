"""A browser lab for learning and driving robot arms through screws, quaternions and Clifford algebra."""

__version__ = "0.1.0"
