"""Define the input of `derive`, joint axes, and its result, a table with its derivation."""

from __future__ import annotations

from dataclasses import dataclass, field, replace
from typing import Literal, NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from helpers.arm import Arm, ArmError, Body, Joint
from helpers.inputs import finite_array, require_type, shorten
from helpers.rows import check_tensors

Array = NDArray[np.float64]
Case = Literal["skew", "intersecting", "parallel", "coincident"]

POINT = "a point (x, y, z) in m"


@dataclass(frozen=True)
class Axis:
    """A joint's axis in the drawn configuration.

    Args:
        point: A point on the axis, in m. A sliding joint needs none: its axis is then drawn through
            the next axis that turns, or through the tip.
        direction: Direction of positive motion, by the right-hand rule where the joint turns; its
            length does not matter.
        joint: A `Joint`, or its kind.

    Raises:
        ArmError: The point or the direction are not three finite numbers, the direction has length
            0, the joint is fixed, or a turning joint has no point.

    Example:
        >>> Axis((0, 0, 0.3), (0, 0, 2)).direction
        (0.0, 0.0, 1.0)
    """

    point: tuple[float, float, float] | None
    direction: tuple[float, float, float]
    joint: Joint = field(default_factory=Joint)

    def __post_init__(self) -> None:
        joint = Joint(self.joint) if isinstance(self.joint, str) else self.joint
        require_type(joint, Joint, "an axis's joint")
        if joint.kind == "fixed":
            raise ArmError("an axis's joint is fixed; expected revolute or prismatic")
        object.__setattr__(self, "joint", joint)
        # The vector is first divided by its largest component, so that its norm cannot overflow.
        expected = "a vector of three finite numbers, not all 0"
        vector = finite_array(self.direction, "an axis's direction", expected, (3,))
        largest = np.abs(vector).max()
        if not largest:
            raise ArmError(f"an axis's direction is {self.direction!r}; expected {expected}")
        unit = vector / largest / np.linalg.norm(vector / largest)
        object.__setattr__(self, "direction", tuple(map(float, unit)))
        if self.point is not None:
            point = finite_array(self.point, "an axis's point", POINT, (3,))
            object.__setattr__(self, "point", tuple(map(float, point)))
        elif joint.kind == "revolute":
            raise ArmError(f"the point of an axis that turns is None; expected {POINT}")


class Line(NamedTuple):
    """A line in space: a point on it and the unit vector along it."""

    point: Array
    z: Array


@dataclass(frozen=True, eq=False)
class DerivationStep:
    """The derivation of one row from the lines of z_{i-1} and z_i, in base axes.

    Attributes:
        number: Number i of the row, counted from 1.
        joint: The joint that moves the row; fixed for a row that only places the base or the tip.
        case: How the two lines lie to each other.
        opposite: Whether z_i points against z_{i-1}, where the lines are parallel or coincide.
        normal: The ends of the common normal on the two lines, shape (2, 3); equal where they meet.
        before: Frame i-1, 4x4.
        frame: Frame i, 4x4.
        a: Length along x_i, in m.
        alpha: Angle about x_i, in rad.
        d: Length along z_{i-1}, in m; a sliding joint's q_i is added to it.
        theta: Angle about z_{i-1}, in rad; a turning joint's q_i is added to it.
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
    """The table that `derive` found, and the steps of its derivation.

    Attributes:
        arm: The arm, with its table in the standard convention.
        steps: One `DerivationStep` for each row.
        lines: The joint axes in the drawn configuration, in base axes.
    """

    arm: Arm
    steps: tuple[DerivationStep, ...]
    lines: tuple[Line, ...]

    @property
    def frames(self) -> Array:
        """Frames 0 .. n in the drawn configuration, in base axes, shape (rows + 1, 4, 4)."""
        return np.array([self.steps[0].before, *(step.frame for step in self.steps)])

    def with_bodies(
        self, masses: ArrayLike, centres: ArrayLike, inertias: ArrayLike | None = None
    ) -> Arm:
        """Return the arm with the masses of its links.

        Args:
            masses: Mass of the link that each joint moves, shape (dof,), in kg.
            centres: Their centres of mass in the drawing, as the joint axes were given, shape
                (dof, 3), in m. Each is carried over into its link's frame.
            inertias: Their inertia tensors about the centres of mass, in the axes of the drawing,
                shape (dof, 3, 3), in kg m^2; 0 by default.

        Returns:
            The arm; rows that do not move have no mass.

        Raises:
            ArmError: A shape is wrong, or a mass is negative.
        """
        n = self.arm.dof
        expected = f"{n} masses in kg, none negative"
        kilograms = finite_array(masses, "masses", expected, (n,))
        if (kilograms < 0).any():
            raise ArmError(f"masses are {shorten(masses)}; expected {expected}")
        points = finite_array(centres, "centres", f"points of shape ({n}, 3) in m", (n, 3))
        tensors = check_tensors(
            np.zeros((n, 3, 3)) if inertias is None else inertias, (n, 3, 3), "inertias"
        )
        bodies = [Body(0, (0, 0, 0))] * len(self.arm.rows)
        for i, mass, point, I in zip(self.arm.joints, kilograms, points, tensors, strict=True):
            R, o = self.steps[i - 1].frame[:3, :3], self.steps[i - 1].frame[:3, 3]
            com = tuple(map(clean_length, R.T @ (point - o)))
            turned = R.T @ I @ R
            bodies[i - 1] = Body(float(mass), com, (turned + turned.T) / 2)
        return replace(self.arm, bodies=bodies)


def clean_length(value: float, tolerance: float = 1e-12) -> float:
    """Remove round-off from a length: 0.16390000000000005 becomes 0.1639.

    A length (m) within 2e-11 of one with seven decimals, or within `tolerance` of 0, becomes that.
    """
    rounded = round(float(value), 7)
    near = 2e-11 if rounded else tolerance
    return (rounded if abs(rounded - value) < near else float(value)) + 0.0
