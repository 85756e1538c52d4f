"""The remote centre of motion: a link passes an entry point and may not push it aside, while the tool works beyond it.

Source: Coutinho 2015; the numbers of equations are those of its chapters 2 and 3.
"""
