"""Report how well a trace follows its path, in numbers too small for a picture."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from helpers.arm import Arm
from helpers.inverse.numeric import solve
from helpers.kinematics import jacobian
from helpers.motion.paths import Path
from helpers.motion.rates import format_size

Array = NDArray[np.floating]

_LARGE_ERROR = 1e-3  # m: above this error the report checks whether the path is within reach


@dataclass(frozen=True)
class TraceReport:
    """The report of a trace.

    Lengths are in m, angles in rad, speeds in rad/s or m/s.

    Attributes:
        arm: Name of the arm.
        position_error: Largest distance from the path.
        off_wall: Largest distance from the wall.
        pen_tilt: Largest angle between the tool's z axis and the one at the start.
        closing_gap: Distance between the tip's first and last position.
        joint_gap: Largest difference between a joint's first and last value.
        smallest_singular_value: Smallest singular value of J.
        largest_condition: Largest condition number of J.
        largest_speed: Largest joint speed.
        speed_share: Largest ratio of a joint's speed to its limit.
        largest_acceleration: Largest joint acceleration.
        speed_from_rest: Largest joint speed in the first or the last step. An arm that stands
            before and after would have to reach it, or lose it, at once.
        beyond_limits: Joints outside their range, each with its largest excess.
        beyond_speed: Joints above their speed limit, each with its largest excess.
        sliding: Joints whose excess is in m or m/s.
        ranges: Whether the arm's table has any range.
        speeds: Whether the arm's table has any speed limit.
        out_of_reach: How far the path leads out of reach: the distance that
            `helpers.inverse.solve` leaves at the point of the largest error; 0 where it reaches
            the point, or where no error is above 1 mm.
    """

    arm: str
    position_error: float
    off_wall: float
    pen_tilt: float
    closing_gap: float
    joint_gap: float
    smallest_singular_value: float
    largest_condition: float
    largest_speed: float
    speed_share: float
    largest_acceleration: float
    speed_from_rest: float
    beyond_limits: tuple[tuple[int, float], ...]
    beyond_speed: tuple[tuple[int, float], ...]
    sliding: tuple[int, ...] = ()
    ranges: bool = True
    speeds: bool = True
    out_of_reach: float = 0.0

    @property
    def executable(self) -> bool:
        """True if no joint leaves its range or exceeds its speed.

        Accelerations are reported only, since the table has no limits for them. A trace that begins
        at speed needs a run-up, or a path made by `rest_to_rest`.
        """
        return not self.beyond_limits and not self.beyond_speed

    def rows(self) -> list[tuple[str, str]]:
        """Return pairs (quantity, value as text), in the units that people read."""
        share = f"{100 * self.speed_share:.0f} % of the limit"
        beyond_limits = self._list_joints(self.beyond_limits, "")
        beyond_speed = self._list_joints(self.beyond_speed, "/s")
        acceleration = format_size(self.largest_acceleration)
        start_speed = format_size(self.speed_from_rest)
        reach = f"the path leads {_format_length(self.out_of_reach)} out of the arm's reach"
        return [
            ("largest position error", _format_length(self.position_error)),
            *([("reason of the error", reach)] if self.out_of_reach else []),
            ("largest distance off the wall", _format_length(self.off_wall)),
            ("largest tilt of the pen", _format_angle(self.pen_tilt)),
            ("gap between the tip's start and end", _format_length(self.closing_gap)),
            ("largest difference of a joint between start and end", _format_angle(self.joint_gap)),
            ("smallest singular value of J", format_size(self.smallest_singular_value)),
            ("largest condition number of J", _format_condition(self.largest_condition)),
            (
                "largest joint speed",
                f"{self.largest_speed:.3g} rad/s, {share if self.speeds else 'no limit is known'}",
            ),
            ("largest joint acceleration", f"{acceleration} rad/s²"),
            ("largest jump of a joint's speed at the start or the end", f"{start_speed} rad/s"),
            ("joints beyond their range", beyond_limits if self.ranges else "no range is known"),
            ("joints beyond their speed", beyond_speed if self.speeds else "no limit is known"),
        ]

    def _list_joints(self, excess: tuple[tuple[int, float], ...], per: str) -> str:
        unit = {i: "m" for i in self.sliding}
        texts = (f"joint {i} by {x:.2g} {unit.get(i, 'rad')}{per}" for i, x in excess)
        return ", ".join(texts) or "none"

    def __str__(self) -> str:
        width = max(len(label) for label, _ in self.rows()) + 1
        return "\n".join(f"{label:<{width}}{value}" for label, value in self.rows())

    __repr__ = __str__

    def _repr_markdown_(self) -> str:
        lines = [f"| {what} | {value} |" for what, value in self.rows()]
        return "\n".join([f"| {self.arm} | |", "|:--|:--|", *lines])


def report_trace(arm: Arm, path: Path, q: Array, q_dot: Array, poses: Array) -> TraceReport:
    """Report on a trace.

    Args:
        arm: The arm.
        path: The path that it follows.
        q: Joint values, shape (steps + 1, dof).
        q_dot: Joint rates, shape (steps + 1, dof).
        poses: Poses of the tip, shape (steps + 1, 4, 4).
    """
    error = poses[:, :3, 3] - path.positions
    lower, upper = arm.limits
    beyond = np.maximum(q - upper, lower - q).max(axis=0)
    speed = np.abs(q_dot).max(axis=0)
    sizes = np.linalg.svd(jacobian(arm, q), compute_uv=False)
    axis, axes = poses[0, :3, 2], poses[:, :3, 2]
    tilts = np.arctan2(np.linalg.norm(np.cross(axes, axis), axis=-1), axes @ axis)
    # Leave out the last rate, which is a copy of the previous one.
    accelerations = np.abs(np.diff(q_dot[:-1], axis=0)) / np.diff(path.times)[:-1, None]
    # Joint limits are ignored when the reach is computed, because a trace may exceed them.
    distances, reach = np.linalg.norm(error, axis=1), 0.0
    worst = int(distances.argmax())
    if distances[worst] >= _LARGE_ERROR:
        nearest = solve(arm, path.positions[worst], start=q[worst], limits=False, restarts=8)
        distance = float(nearest.position_error)
        reach = distance if distance > _LARGE_ERROR / 10 else 0.0
    return TraceReport(
        arm=arm.name,
        position_error=float(distances[worst]),
        off_wall=float(np.abs(error @ path.normal).max()),
        pen_tilt=float(tilts.max()),
        closing_gap=float(np.linalg.norm(poses[-1, :3, 3] - poses[0, :3, 3])),
        joint_gap=float(np.abs(q[-1] - q[0]).max()),
        smallest_singular_value=float(sizes[:, -1].min()),
        largest_condition=float((sizes[:, 0] / np.maximum(sizes[:, -1], 1e-300)).max()),
        largest_speed=float(speed.max()),
        speed_share=float((speed / arm.speed_limits).max()),
        largest_acceleration=float(accelerations.max(initial=0.0)),
        speed_from_rest=float(np.abs(q_dot[[0, -1]]).max()),
        beyond_limits=_positive_excess(arm, beyond),
        beyond_speed=_positive_excess(arm, speed - arm.speed_limits),
        sliding=tuple(arm.joints[k] for k in np.flatnonzero(~arm.turning)),
        ranges=bool(np.isfinite([lower, upper]).any()),
        speeds=bool(np.isfinite(arm.speed_limits).any()),
        out_of_reach=reach,
    )


def _positive_excess(arm: Arm, excess: Array) -> tuple[tuple[int, float], ...]:
    """Return (joint, excess) for each joint beyond its limit by more than round-off."""
    return tuple((arm.joints[k], float(excess[k])) for k in np.flatnonzero(excess > 1e-9))


def _format_length(value: float) -> str:
    """Write a length in m or mm with three digits.

    Below 1e-10 m it is round-off.
    """
    if value < 1e-10:
        return "below 1e-10 m"
    return f"{1e3 * value:.3g} mm" if value >= 1e-6 else f"{value:.1e} m"


def _format_angle(value: float) -> str:
    """Write an angle in degrees with four digits.

    Below 1e-6° it is round-off.
    """
    degrees = float(np.degrees(value))
    return f"{degrees:.4g}°" if degrees >= 1e-6 else "below 1e-6°"


def _format_condition(value: float) -> str:
    """Write a condition number with three digits.

    Above 1e12 it is round-off.
    """
    return f"{value:.3g}" if value <= 1e12 else "above 1e12"
