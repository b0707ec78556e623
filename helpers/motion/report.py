"""What a run along a path was worth, in numbers that a picture hides."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from helpers.arm import Arm
from helpers.kinematics import jacobian
from helpers.motion.paths import Path
from helpers.motion.rates import magnitude

Array = NDArray[np.floating]


@dataclass(frozen=True)
class Report:
    """The standard report of every run; lengths in m, angles in rad, speeds in rad/s or m/s.

    `speed_from_rest` is the largest speed that a joint has in the first or the last step: an arm
    that stands before and after would have to take it on, or lose it, at once. `sliding` are the
    joints whose excess is in m or m/s. `ranges` and `speeds` tell whether the arm's table has any:
    where it has none, none can be exceeded.
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

    @property
    def executable(self) -> bool:
        """Whether the real arm could do it, no joint beyond its range or its speed.

        Accelerations are told, not judged: the table has no limits for them. A run that begins at
        speed needs a run-up, or a path made by `rest_to_rest`.
        """
        return not self.beyond_limits and not self.beyond_speed

    def rows(self) -> list[tuple[str, str]]:
        """What and how much, in the units people read."""
        share = f"{100 * self.speed_share:.0f} % of the limit"
        within = self._joints(self.beyond_limits, ""), self._joints(self.beyond_speed, "/s")
        return [
            ("largest position error", _length(self.position_error)),
            ("largest distance off the wall", _length(self.off_wall)),
            ("largest tilt of the pen", _angle(self.pen_tilt)),
            ("gap between the tip's start and end", _length(self.closing_gap)),
            ("largest change of a joint over the whole path", _angle(self.joint_gap)),
            ("smallest singular value of J", magnitude(self.smallest_singular_value)),
            ("largest condition number of J", _condition(self.largest_condition)),
            (
                "largest joint speed",
                f"{self.largest_speed:.3g} rad/s, {share if self.speeds else 'no limit is known'}",
            ),
            ("largest joint acceleration", f"{magnitude(self.largest_acceleration)} rad/s²"),
            ("joint speed to take on or lose at once", f"{magnitude(self.speed_from_rest)} rad/s"),
            ("joints beyond their range", within[0] if self.ranges else "no range is known"),
            ("joints beyond their speed", within[1] if self.speeds else "no limit is known"),
        ]

    def _joints(self, excess: tuple[tuple[int, float], ...], per: str) -> str:
        unit = {i: "m" for i in self.sliding}
        told = (f"joint {i} by {x:.2g} {unit.get(i, 'rad')}{per}" for i, x in excess)
        return ", ".join(told) or "none"

    def __str__(self) -> str:
        return "\n".join(f"{what:<46}{value}" for what, value in self.rows())

    __repr__ = __str__

    def _repr_markdown_(self) -> str:
        lines = [f"| {what} | {value} |" for what, value in self.rows()]
        return "\n".join([f"| {self.arm} | |", "|:--|:--|", *lines])


def run_report(arm: Arm, path: Path, q: Array, q_dot: Array, poses: Array) -> Report:
    """The report of a run: q and q_dot of shape (steps + 1, dof), poses of shape (steps + 1, 4,
    4)."""
    error = poses[:, :3, 3] - path.positions
    lower, upper = arm.limits
    beyond = np.maximum(q - upper, lower - q).max(axis=0)
    speed = np.abs(q_dot).max(axis=0)
    sizes = np.linalg.svd(jacobian(arm, q), compute_uv=False)
    return Report(
        arm=arm.name,
        position_error=float(np.linalg.norm(error, axis=1).max()),
        off_wall=float(np.abs(error @ path.normal).max()),
        pen_tilt=float(_angles(poses[:, :3, 2], poses[0, :3, 2]).max()),
        closing_gap=float(np.linalg.norm(poses[-1, :3, 3] - poses[0, :3, 3])),
        joint_gap=float(np.abs(q[-1] - q[0]).max()),
        smallest_singular_value=float(sizes[:, -1].min()),
        largest_condition=float((sizes[:, 0] / np.maximum(sizes[:, -1], 1e-300)).max()),
        largest_speed=float(speed.max()),
        speed_share=float((speed / arm.speed_limits).max()),
        largest_acceleration=float(_accelerations(path, q_dot).max(initial=0.0)),
        speed_from_rest=float(np.abs(q_dot[[0, -1]]).max()),
        beyond_limits=_over(arm, beyond),
        beyond_speed=_over(arm, speed - arm.speed_limits),
        sliding=tuple(arm.joints[k] for k in np.flatnonzero(~arm.turning)),
        ranges=bool(np.isfinite([lower, upper]).any()),
        speeds=bool(np.isfinite(arm.speed_limits).any()),
    )


def _angles(axes: Array, wanted: Array) -> Array:
    return np.arctan2(np.linalg.norm(np.cross(axes, wanted), axis=-1), axes @ wanted)


def _accelerations(path: Path, q_dot: Array) -> Array:
    """From step to step; the last rate is that of the step before."""
    return np.abs(np.diff(q_dot[:-1], axis=0)) / np.diff(path.times)[:-1, None]


def _over(arm: Arm, excess: Array) -> tuple[tuple[int, float], ...]:
    return tuple((arm.joints[k], float(excess[k])) for k in np.flatnonzero(excess > 1e-9))


def _length(value: float) -> str:
    """A length in m or mm with three digits; below a tenth of a nanometre it is rounding."""
    if value < 1e-10:
        return "below 1e-10 m"
    return f"{1e3 * value:.3g} mm" if value >= 1e-6 else f"{value:.1e} m"


def _angle(value: float) -> str:
    """An angle in degrees with four digits; below a millionth of a degree it is rounding."""
    degrees = float(np.degrees(value))
    return f"{degrees:.4g}°" if degrees >= 1e-6 else "below 1e-6°"


def _condition(value: float) -> str:
    """A condition number with three digits; above 1e12 it is rounding."""
    return f"{value:.3g}" if value <= 1e12 else "above 1e12"
