"""The guarded step: a task within hard rows of limits, planes, bodies and an entry point, solved and then checked."""
