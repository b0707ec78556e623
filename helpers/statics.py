"""What holds an arm still: potential energy, gravity torques, and the torques against a force at
the tip.

Gravity is a vector in base axes, so a wall- or ceiling-mounted arm is the same arm with another
`gravity`. A wrench is (force, moment) on the tool, by the world, in base axes at the tip (N, N m).
Source: Spong, Hutchinson and Vidyasagar, Robot Modeling and Control, sections 4.10 and 6.2.
"""

from collections.abc import Iterator, Sequence
from dataclasses import replace

import numpy as np
from numpy.typing import ArrayLike, NDArray

from helpers.arm import Arm, Body
from helpers.inputs import ArmError, common_shape, must_be, number, numbers
from helpers.kinematics import (
    Step,
    Vector,
    evaluated,
    frame_columns,
    jacobian,
    mixed,
    tilted,
)
from helpers.program import Value

__all__ = [
    "GRAVITY",
    "centres_in",
    "gravity_torque",
    "potential_energy",
    "static_torque",
    "with_payload",
]

Array = NDArray[np.float64]

GRAVITY = (0.0, 0.0, -9.81)  # m/s^2, for an arm that stands on the floor


def potential_energy(arm: Arm, q: ArrayLike, gravity: ArrayLike = GRAVITY) -> Array:
    """P = -sum m_i g . c_i in J, shape (...), for q of shape (..., dof); zero for a mass at the
    base's origin.

    Raises ArmError where the arm has no masses or `gravity` is no vector.
    """
    return evaluated(arm, q, _energy, (), _lift(arm, gravity))[()]


def gravity_torque(arm: Arm, q: ArrayLike, gravity: ArrayLike = GRAVITY) -> Array:
    """g(q) = dP/dq, the torques (N m; N where a joint slides) that hold the arm, shape (..., dof).

    From the tip inwards, each row carries the mass M and the first moment S of the links beyond it,
    in its own axes; a turn about z_{i-1} lifts them at the rate -g . (z_{i-1} x S).
    """
    lift = _lift(arm, gravity)
    return evaluated(arm, q, _torques, (arm.dof,), lift)


def static_torque(arm: Arm, q: ArrayLike, wrench: ArrayLike, gravity: ArrayLike = GRAVITY) -> Array:
    """tau = g(q) - J^T F, shape (..., dof): what the motors give while the world exerts `wrench`,
    shape (..., 6).

    Raises ArmError for a wrench of another shape or with NaN in it.
    """
    F = forces(wrench)
    g = gravity_torque(arm, q, gravity)
    common_shape("poses and wrenches", g.shape[:-1], F.shape[:-1])
    return g - np.einsum("...ij,...i->...j", jacobian(arm, q), F)


def forces(wrench: ArrayLike) -> Array:
    """Wrenches of shape (..., 6); raises ArmError for another shape or NaN in it."""
    wanted = "six finite numbers (fx, fy, fz, mx, my, mz)"
    return numbers(wrench, "wrench", wanted, (6,), many=True)


def with_payload(arm: Arm, mass: float, com: ArrayLike = (0.0, 0.0, 0.0)) -> Arm:
    """The arm with a mass (kg) fixed to its last link, its centre in the last frame (m): a tool, a
    pen, a load."""
    must_have_bodies(arm)
    masses, coms = _bodies(arm)
    mass = number(mass, "mass", "a finite number of kg, 0 or more", least=0)
    added = numbers(com, "com", "three finite coordinates in m", (3,))
    if not mass:
        return arm
    total = masses[-1] + mass
    centre = (masses[-1] * np.array(coms[-1]) + mass * added) / total
    return replace(arm, bodies=(*arm.bodies[:-1], Body(float(total), tuple(map(float, centre)))))


def centres_in(frames_to: ArrayLike, frames_from: ArrayLike, centres: ArrayLike) -> Array:
    """Points given in one set of link frames, told in another: both (n, 4, 4) at one pose, the
    points (n, 3).

    For centres of mass from a paper whose frames are not the table's.
    """
    to = numbers(frames_to, "frames_to", "frames (n, 4, 4)", (None, 4, 4))
    start = numbers(frames_from, "frames_from", "frames (n, 4, 4)", (None, 4, 4))
    points = numbers(centres, "centres", "points (n, 3)", (None, 3))
    if not len(to) == len(start) == len(points):
        raise ArmError(
            f"frames {to.shape}, {start.shape} and points {points.shape} do not fit; expected (n,"
            " 4, 4) twice and (n, 3)"
        )
    world = np.einsum("nij,nj->ni", start[:, :3, :3], points) + start[:, :3, 3]
    return np.einsum("nji,nj->ni", to[:, :3, :3], world - to[:, :3, 3])


def _energy(arm: Arm, steps: Sequence[Step], *lift: Value) -> Sequence[Value]:
    """Each mass times the lift of its centre."""
    total = 0.0
    _, *frames = frame_columns(steps)
    for (x, y, z, origin), m, com in zip(frames, *_bodies(arm), strict=True):
        point = mixed(1.0, mixed(com[0], x, com[1], y), 1.0, mixed(com[2], z, 1.0, origin))
        total = total + m * sum(up * place for up, place in zip(lift, point, strict=True))
    return [total]


def _torques(arm: Arm, steps: Sequence[Step], *lift: Value) -> Sequence[Value]:
    mass, (x, y, z), torques = 0.0, (0.0, 0.0, 0.0), []
    links = zip(steps, _lifts(steps, lift), *_bodies(arm), strict=True)
    for (row, c, s, d), up, m, com in reversed(list(links)):
        x, y, z, mass = x + m * com[0], y + m * com[1], z + m * com[2], mass + m
        y, z = row.cos_alpha * y - row.sin_alpha * z, row.cos_alpha * z + row.sin_alpha * y
        x, z = x + mass * row.a, z + mass * d
        if row.kind == "revolute":
            torques.append(up[1] * x - up[0] * y)
        elif row.kind == "prismatic":
            torques.append(mass * up[2])
        x, y = c * x - s * y, s * x + c * y
    return torques[::-1]


def _lifts(steps: Sequence[Step], lift: Vector) -> Iterator[Vector]:
    """What holds a mass of 1 kg up, -gravity, in the axes of each row after its turn about z and
    before that about x."""
    x, y, z = lift
    for row, c, s, _ in steps:
        x, y = c * x + s * y, c * y - s * x
        yield x, y, z
        (y,), (z,) = tilted(row, (y,), (z,))


def _lift(arm: Arm, gravity: ArrayLike) -> list[float]:
    """-gravity, once both are known to be in order."""
    must_have_bodies(arm)
    wanted = "a vector of three finite numbers in m/s^2"
    return (-numbers(gravity, "gravity", wanted, (3,))).tolist()


def must_have_bodies(arm: Arm) -> None:
    """Raise ArmError for an arm without masses."""
    must_be(arm, Arm, "arm")
    if not arm.bodies:
        raise ArmError(
            f"{arm.name} has no masses; give bodies, one Body for each of its {len(arm.rows)} rows"
        )


def _bodies(arm: Arm) -> tuple[list[float], list[list[float]]]:
    """Masses (rows) and centres of mass (rows, 3)."""
    masses = [arm.number(body.mass) for body in arm.bodies]
    return masses, [[arm.number(c) for c in body.com] for body in arm.bodies]
