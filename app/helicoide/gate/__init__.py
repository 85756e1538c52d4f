"""Every condition between a wish and the arm: what comes from a browser is checked here, and becomes an Update. Pure.

A wish that cannot be granted leaves the state as it was, but for a notice that says why. Values are judged here and
nowhere else: a browser may send anything.
"""

from helicoide.gate.check import LATCH, PARKED, pose
from helicoide.gate.enclosure import (
    add_plane,
    add_plane_through,
    clear_planes,
    remove_plane,
    say,
    see,
    set_box,
    set_zones,
    take_planes,
    take_planes_of,
)
from helicoide.gate.entry import ENTRY, drag_entry, hold_entry, set_entry
from helicoide.gate.joints import NO_PARKING, get_ready, go_to, park, set_gripper, set_joint
from helicoide.gate.mapping import choose_map, clear_map, cut_map, end_map, fail_map, show_map, start_map, tell_map
from helicoide.gate.method import (
    HEAVIEST,
    LARGEST_GAIN,
    LEAST_GAIN,
    choose_method,
    choose_objective,
    compare_with,
    grow_weights,
    objective_as_row,
    set_gain,
    set_objective,
    set_option,
    weigh_objective,
)
from helicoide.gate.obstacles import (
    LARGEST,
    SMALLEST,
    add_obstacle,
    drag_obstacle,
    obstacle_handle,
    remove_obstacle,
    set_obstacle,
    set_obstacle_radius,
)
from helicoide.gate.path import pause, play, scrub
from helicoide.gate.planes import drag_plane, restore_planes
from helicoide.gate.replaying import replay, replay_motion
from helicoide.gate.stopping import stop
from helicoide.gate.target import Phase, drag_target, hold_orientation, let_go, set_target
from helicoide.gate.teaching import delete_waypoint, move_waypoint, record, rename_waypoint, take_waypoints

__all__ = [
    "ENTRY",
    "HEAVIEST",
    "LARGEST",
    "LARGEST_GAIN",
    "LATCH",
    "LEAST_GAIN",
    "NO_PARKING",
    "PARKED",
    "SMALLEST",
    "Phase",
    "add_obstacle",
    "add_plane",
    "add_plane_through",
    "choose_map",
    "choose_method",
    "choose_objective",
    "clear_map",
    "clear_planes",
    "compare_with",
    "cut_map",
    "delete_waypoint",
    "drag_entry",
    "drag_obstacle",
    "drag_plane",
    "drag_target",
    "end_map",
    "fail_map",
    "get_ready",
    "go_to",
    "grow_weights",
    "hold_entry",
    "hold_orientation",
    "let_go",
    "move_waypoint",
    "objective_as_row",
    "obstacle_handle",
    "park",
    "pause",
    "play",
    "pose",
    "record",
    "remove_obstacle",
    "remove_plane",
    "rename_waypoint",
    "replay",
    "replay_motion",
    "restore_planes",
    "say",
    "scrub",
    "see",
    "set_box",
    "set_entry",
    "set_gain",
    "set_gripper",
    "set_joint",
    "set_objective",
    "set_obstacle",
    "set_obstacle_radius",
    "set_option",
    "set_target",
    "set_zones",
    "show_map",
    "start_map",
    "stop",
    "take_planes",
    "take_planes_of",
    "take_waypoints",
    "tell_map",
    "weigh_objective",
]
