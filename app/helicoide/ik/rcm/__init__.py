"""The remote centre of motion: a link passes through an entry point without moving it sideways.

Source: Coutinho 2015. Equation numbers refer to its chapters 2 and 3.
"""
