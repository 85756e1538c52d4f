"""The setup of a step on its way to an arm. Until the arm has followed it, the goal of the step means nothing."""

from __future__ import annotations

from helicoide.command import Command, HoldPosition
from helicoide.state import State, Update


class StepSetup:
    """An update that remembers which command it made. The clock's thread applies it."""

    def __init__(self, setup: Update) -> None:
        self.setup, self.is_applied = setup, False
        self.command: Command | None = None

    def __call__(self, state: State) -> State:
        """The state after the setup."""
        self.is_applied = True
        after = self.setup(state)
        self.command = after.request.command
        return after

    def is_under_way(self, state: State) -> bool:
        """Whether the arm is still on its way to the start of the step."""
        if not self.is_applied:
            return True
        return self.command is state.request.command and not isinstance(self.command, HoldPosition)
