"""The ball that can be grasped, and its stands."""

from __future__ import annotations

import viser

from helicoide.arrays import Array
from helicoide.kinematics.ball import BALL_RADIUS
from helicoide.view.layers import Stage
from helicoide.view.window_view import View

NAME = "ball"
SHARED = True

WHITE, WOOD = (245, 245, 240), (150, 111, 70)
STAND = 0.014


def build(stage: Stage) -> BallLayer:
    """The ball, hidden at first, without stands."""
    sphere = stage.scene.add_icosphere("/ball", BALL_RADIUS, WHITE, cast_shadow=False)
    sphere.visible = False
    return BallLayer(stage, sphere)


class BallLayer:
    """The ball, and a column from the floor for each stand. Columns are made again when the stands change."""

    def __init__(self, stage: Stage, sphere: viser.IcosphereHandle) -> None:
        self.stage, self.sphere = stage, sphere
        self.columns: list[viser.CylinderHandle] = []

    def update(self, old: View | None, new: View) -> None:
        """Follow the ball."""
        ball, before = new.state.ball, None if old is None else old.state.ball
        if old is not None and ball is before:
            return
        self.sphere.visible = ball is not None
        if ball is not None:
            self.sphere.position = ball.centre
        if before is None or ball is None or ball.supports is not before.supports:
            self._stand([] if ball is None else list(ball.supports))

    def _stand(self, tops: list[Array]) -> None:
        scene, floor = self.stage.scene, self.stage.robot.floor
        for column in self.columns:
            column.remove()
        self.columns = [
            scene.add_cylinder(
                f"/stands/{k}",
                STAND,
                max(float(top[2]) - floor, 1e-3),
                WOOD,
                cast_shadow=False,
                position=(float(top[0]), float(top[1]), (float(top[2]) + floor) / 2),
            )
            for k, top in enumerate(tops)
        ]
