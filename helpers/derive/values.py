"""The joint axes that are drawn, and what `derive` makes of them: a table, and how each row came
about."""

from dataclasses import dataclass, field, replace
from typing import Literal, NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from helpers.arm import Arm, ArmError, Body, Joint
from helpers.inputs import must_be, numbers, shown

Array = NDArray[np.float64]
Case = Literal["skew", "intersecting", "parallel", "coincident"]

POINT = "a point (x, y, z) in m"


@dataclass(frozen=True)
class Axis:
    """A joint's axis in the drawn pose: a point on it (m), its direction, and what moves there.

    The direction is that of positive motion, by the right-hand rule where the joint turns; its
    length does not matter. `joint` is a `Joint`, or only its kind. An axis that slides has a
    direction but no place of its own: it is laid where it is drawn, or, without a `point`, through
    the next axis that turns (through the tip if none does).

    Raises:
        ArmError: no point or direction of three finite numbers, a direction of length 0, a kind
            that does not move, or an axis that turns without a point.
    """

    point: tuple[float, float, float] | None
    direction: tuple[float, float, float]
    joint: Joint = field(default_factory=Joint)

    def __post_init__(self) -> None:
        joint = Joint(self.joint) if isinstance(self.joint, str) else self.joint
        must_be(joint, Joint, "an axis's joint")
        if joint.kind == "fixed":
            raise ArmError("an axis's joint is fixed; expected revolute or prismatic")
        object.__setattr__(self, "joint", joint)
        object.__setattr__(self, "direction", _unit(self.direction))
        if self.point is not None:
            point = numbers(self.point, "an axis's point", POINT, (3,))
            object.__setattr__(self, "point", tuple(map(float, point)))
        elif joint.kind == "revolute":
            raise ArmError(f"the point of an axis that turns is None; expected {POINT}")


def _unit(direction: ArrayLike) -> tuple[float, ...]:
    wanted = "a vector of three finite numbers, not all 0"
    vector = numbers(direction, "an axis's direction", wanted, (3,))
    largest = np.abs(vector).max()
    if not largest:
        raise ArmError(f"an axis's direction is {direction!r}; expected {wanted}")
    vector = vector / largest
    return tuple(map(float, vector / np.linalg.norm(vector)))


class Line(NamedTuple):
    """A line in space: a point on it and the unit vector along it."""

    point: Array
    z: Array


@dataclass(frozen=True, eq=False)
class Step:
    """How one row came about: from the line of z_{i-1} to the line of z_i, in base axes in the
    drawn pose.

    Attributes:
        number: the row i, from 1.
        joint: what moves the row; fixed for one that only places the base or the tip.
        case: how the two lines lie to each other.
        opposite: whether z_i points against z_{i-1}, where the lines are parallel or one.
        normal: the feet of the common normal on the two lines, shape (2, 3), equal where the lines
            meet.
        before, frame: frames i-1 and i, each 4x4.
        a, alpha, d, theta: the four numbers (m, rad); q_i, which is 0 in the drawing, is added to
            theta or to d.
    """

    number: int
    joint: Joint
    case: Case
    opposite: bool
    normal: Array
    before: Array
    frame: Array
    a: float
    alpha: float
    d: float
    theta: float


@dataclass(frozen=True, eq=False)
class Derivation:
    """The table that `derive` found, and how.

    Attributes:
        arm: the arm, its table in the standard convention.
        steps: one `Step` for each row of that table.
        lines: the joint axes, in base axes in the drawn pose.
    """

    arm: Arm
    steps: tuple[Step, ...]
    lines: tuple[Line, ...]

    @property
    def frames(self) -> Array:
        """Frames 0 .. n in base axes in the drawn pose, shape (rows + 1, 4, 4)."""
        return np.array([self.steps[0].before, *(step.frame for step in self.steps)])

    def with_bodies(self, masses: ArrayLike, centres: ArrayLike) -> Arm:
        """The arm with its links' masses (kg), shape (dof,), and centres of mass (m), shape (dof,
        3).

        The centres are points of the drawing, given as the joint axes were; each is carried over
        into the frame that moves with its link. Rows that do not move get no mass. Raises ArmError
        for another shape or a negative mass.
        """
        n = self.arm.dof
        wanted = f"{n} masses in kg, none negative"
        kilograms = numbers(masses, "masses", wanted, (n,))
        if (kilograms < 0).any():
            raise ArmError(f"masses are {shown(masses)}; expected {wanted}")
        points = numbers(centres, "centres", f"points of shape ({n}, 3) in m", (n, 3))
        bodies = [Body(0, (0, 0, 0))] * len(self.arm.rows)
        for i, mass, point in zip(self.arm.joints, kilograms, points, strict=True):
            R, o = self.steps[i - 1].frame[:3, :3], self.steps[i - 1].frame[:3, 3]
            bodies[i - 1] = Body(float(mass), tuple(map(clean_length, R.T @ (point - o))))
        return replace(self.arm, bodies=bodies)


def clean_length(value: float, tolerance: float = 1e-12) -> float:
    """A length freed from rounding: 0.1639 rather than 0.16390000000000005."""
    short = round(float(value), 7)
    near = 2e-11 if short else tolerance
    return (short if abs(short - value) < near else float(value)) + 0.0
