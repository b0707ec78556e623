"""Find the structure of an arm that gives its inverse kinematics a closed form.

The joint axes are taken as lines in space at a generic configuration. Which of them meet in a point
and which are parallel does not depend on how the Denavit-Hartenberg table is written, nor on a tool
or fixed rows. Source: Pieper (1968) for three axes that meet, Raghavan and Roth (1993) for the
count of solutions.
"""

from dataclasses import dataclass
from functools import lru_cache
from itertools import pairwise

import numpy as np

from helpers.arm import Arm
from helpers.inputs import ArmError
from helpers.inverse.axes import Array, JointAxis, cross, norm
from helpers.inverse.curves import find_flatness
from helpers.kinematics import link_frames

# Axes this close (in rad, or in lengths over the arm's size) count as meeting or parallel. Files
# round angles to four digits, and calibrated arms deviate by about as much. Newton's method then
# corrects each branch for the actual arm.
NEARLY = 1e-4
# Axes this close meet or are parallel up to round-off, so the closed form needs no correction.
EXACT = 1e-10

FIRST_THREE_MEET, WRIST, PARALLEL = "first three axes meet", "spherical wrist", "parallel axes"
POSITION, PLANAR_2R, PLANAR_3R = "position of the tip", "planar two-link arm", "planar arm"
SCARA = "SCARA arm"


@dataclass(frozen=True)
class Structure:
    """The axes of an arm that meet or are parallel.

    Attributes:
        kind: WRIST, FIRST_THREE_MEET, PARALLEL, PLANAR_3R, SCARA, PLANAR_2R or POSITION.
        axes: one `JointAxis` for each joint, at the configuration `reference`.
        size: the length of the arm from axis to axis, in m.
        reference: the generic configuration, (dof,).
        tip: the tip's pose there, (4, 4).
        centre: the point where three axes meet, (3, 1, 1), for WRIST and FIRST_THREE_MEET.
        first: the index of the first of three parallel axes, from 0, for PARALLEL.
        gap: by how much the axes miss the structure (rad, or lengths over the arm's size).
    """

    kind: str
    axes: tuple[JointAxis, ...]
    size: float
    reference: Array
    tip: Array
    centre: Array | None = None
    first: int = 0
    gap: float = 0.0

    @property
    def description(self) -> str:
        """Name the structure, its joints, and whether the arm has it only nearly."""
        joints = {
            WRIST: " (axes 4, 5 and 6 meet)",
            FIRST_THREE_MEET: "",
            PARALLEL: f" {self.first + 1}, {self.first + 2} and {self.first + 3}",
        }
        text = self.kind + joints.get(self.kind, "")
        return text if self.gap < EXACT else f"nearly: {text}"


@lru_cache(maxsize=64)
def find_structure(arm: Arm) -> Structure:
    """Find which axes of an arm meet or are parallel.

    Raises:
        ArmError: the arm has no structure that gives all solutions in closed form.
    """
    axes, size, reference, tip = axes_at_generic_configuration(arm)
    turns = tuple(axis.turns for axis in axes)
    arguments = (axes, size, reference, tip)
    if len(axes) == 6:
        for kind, three, placing in (
            (WRIST, axes[3:], axes[:3]),
            (FIRST_THREE_MEET, axes[:3], axes[:2:-1]),
        ):
            met, gap = meeting_point(three, size), crossing_gap(placing, size)
            if met is not None and gap < NEARLY:
                return Structure(kind, *arguments, centre=met[0], gap=max(met[1], gap))
        for first in range(4 if all(turns) else 0):
            rest = [(first + 3 + i) % 6 for i in range(3)]
            gap = parallel_gap(axes[first : first + 3])
            neighbours = [(axes[i], axes[j]) for i, j in pairwise(rest) if j == i + 1]
            gaps = [met[1] for pair in neighbours if (met := meeting_point(pair, size))]
            if gap < NEARLY and gaps:
                return Structure(PARALLEL, *arguments, first=first, gap=max(gap, min(gaps)))
    elif sum(turns) == 3 and len(axes) in (3, 4) and parallel_gap(axes) < NEARLY:
        kind = PLANAR_3R if len(axes) == 3 else SCARA
        return Structure(kind, *arguments, gap=parallel_gap(axes))
    elif len(axes) == 3 and crossing_gap(axes, size) < NEARLY:
        return Structure(POSITION, *arguments, gap=crossing_gap(axes, size))
    elif turns == (True, True) and parallel_gap(axes) < NEARLY:
        return Structure(PLANAR_2R, *arguments, gap=parallel_gap(axes))
    if len(axes) > 6:
        raise ArmError(
            f"{arm.name} has {len(axes)} joints, more than the six that a pose can fix, so"
            " its solutions form families; lock joints until six are left, as in arm.lock(3), or"
            " use helpers.inverse.solve, which finds one solution near a start"
        )
    raise ArmError(
        f"{arm.name} has no structure with a closed form: its {len(axes)} joint axes neither meet"
        " nor are parallel in the right places; expected a spherical wrist or three parallel axes"
        " among six, a planar or SCARA arm, or three joints with neighbours that meet or are"
        " parallel; use helpers.inverse.solve, which finds one solution near a start"
    )


def axes_at_generic_configuration(arm: Arm) -> tuple[tuple[JointAxis, ...], float, Array, Array]:
    """Return the axes as lines at a generic configuration, and this configuration.

    The configuration is a generic one: at q = 0 axes that differ are often one line. Each axis has
    the foot of the perpendicular from the point before as its point, since the common normals of
    nearly parallel axes may lie far away.

    Returns:
        The axes, the arm's size in m, the configuration (dof,) and the tip's pose (4, 4).
    """
    reference = np.random.default_rng(7).uniform(0.3, 1.2, arm.dof)
    frames = link_frames(arm, reference)
    axes, last, size = [], frames[0, :3, 3], 0.0
    for joint, turns in zip(arm.joints, arm.turning, strict=True):
        direction, origin = frames[joint - 1, :3, 2], frames[joint - 1, :3, 3]
        foot = origin + direction * (direction @ (last - origin))
        size, last = size + float(np.linalg.norm(foot - last)), foot
        axes.append(JointAxis(direction[:, None, None], foot[:, None, None], bool(turns)))
    size += float(np.linalg.norm(frames[-1, :3, 3] - last))
    return tuple(axes), size, reference, frames[-1]


def meeting_point(axes: tuple[JointAxis, ...], size: float) -> tuple[Array, float] | None:
    """Return the point (3, 1, 1) where revolute axes meet, and their largest distance from it.

    None where an axis slides, two neighbours are parallel, or the axes miss each other by more
    than NEARLY times the arm's size.
    """
    twists = [
        float(norm(cross(one.direction, other.direction))[0, 0]) for one, other in pairwise(axes)
    ]
    if not all(axis.turns for axis in axes) or min(twists) < NEARLY:
        return None
    normals: list[Array] = [np.eye(3) - np.outer(axis.direction, axis.direction) for axis in axes]
    right = sum(P @ axis.point[:, 0, 0] for P, axis in zip(normals, axes, strict=True))
    point = np.asarray(np.linalg.solve(sum(normals), right), np.float64)[:, None, None]
    gap = max(float(norm(cross(axis.direction, point - axis.point))[0, 0]) for axis in axes) / size
    return (point, gap) if gap < NEARLY else None


def crossing_gap(axes: tuple[JointAxis, ...], size: float) -> float:
    """Return how far the curves of joints 1 and 3 are from a crossing with a closed form.

    They do where one of them is a segment, where both are parabolas (slides beside a turning joint)
    or both are circles (turns about the direction of a slide). Otherwise the crossings are the
    roots of a quartic, which this book leaves out.
    """
    first, second, third = axes
    widths = [find_flatness(axis, second, size).width for axis in (first, third)]
    if not first.turns and not third.turns:
        return 0.0
    if not second.turns and first.turns and third.turns:
        return min(*widths, parallel_gap((first, third)))
    return min(widths)


def parallel_gap(axes: tuple[JointAxis, ...]) -> float:
    """Return the largest angle between neighbouring axes, 0 for parallel or antiparallel ones."""
    return max(
        float(norm(cross(one.direction, other.direction))[0, 0]) for one, other in pairwise(axes)
    )
