"""The guarded step: a task solved under joint limits, planes, bodies and an entry point, and then checked."""
