"""Compute the torques that hold an arm against gravity and a force at its tip.

Gravity is a vector in base axes, so an arm on a wall or a ceiling is the same arm with another
`gravity`. A wrench is the force and the moment (N, N m) that the world exerts on the tool, in base
axes at the tip.
Source: Spong, Hutchinson and Vidyasagar, Robot Modeling and Control, sections 4.10 and 6.2.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace

import numpy as np
from numpy.typing import ArrayLike, NDArray

from helpers.arm import Arm, Body
from helpers.inputs import ArmError, broadcast_shape, finite_array, finite_number, require_type
from helpers.kinematics import (
    Vector,
    frame_columns,
    jacobian,
    linear_combination,
    rotate_about_x,
)
from helpers.program import RowMotion, Value, run_recursion

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
    """Compute the potential energy P = -sum m_i g . c_i.

    A mass at the base's origin has none.

    Args:
        arm: The arm, with its bodies.
        q: Joint values, shape (..., dof), in rad or m.
        gravity: Gravity in base axes, shape (3,), in m/s^2.

    Returns:
        Energies, shape (...), in J.

    Raises:
        ArmError: The arm has no masses, or `gravity` is no vector.

    Example:
        >>> from helpers.robots import UR10E
        >>> float(potential_energy(UR10E, UR10E.home).round(3))
        176.165
    """
    return run_recursion(arm, q, _compute_energy, (), _upward_vector(arm, gravity))[()]


def gravity_torque(arm: Arm, q: ArrayLike, gravity: ArrayLike = GRAVITY) -> Array:
    """Compute the torques g(q) = dP/dq that hold an arm against gravity.

    From the tip to the base, each row carries the mass M and the first moment S of the links beyond
    it, in its own axes; a turn about z_{i-1} lifts them at the rate -g . (z_{i-1} x S).

    Args:
        arm: The arm, with its bodies.
        q: Joint values, shape (..., dof), in rad or m.
        gravity: Gravity in base axes, shape (3,), in m/s^2.

    Returns:
        Torques, shape (..., dof), in N m; in N for a joint that slides.

    Example:
        >>> from helpers.robots import UR10E
        >>> gravity_torque(UR10E, [0, 0, 0, 0, 0, 0])[:3].round(2)
        array([   0.  , -121.29,  -39.3 ])
    """
    up = _upward_vector(arm, gravity)
    return run_recursion(arm, q, _compute_torques, (arm.dof,), up)


def static_torque(arm: Arm, q: ArrayLike, wrench: ArrayLike, gravity: ArrayLike = GRAVITY) -> Array:
    """Compute the torques tau = g(q) - J^T F that hold an arm against gravity and a wrench.

    Args:
        arm: The arm, with its bodies.
        q: Joint values, shape (..., dof), in rad or m.
        wrench: Force and moment that the world exerts on the tool, in base axes at the tip,
            shape (..., 6), in N and N m.
        gravity: Gravity in base axes, shape (3,), in m/s^2.

    Returns:
        Torques, shape (..., dof), in N m; in N for a joint that slides.

    Raises:
        ArmError: The wrench has another shape, or holds NaN.

    Example:
        >>> from helpers.robots import UR10E
        >>> static_torque(UR10E, [0, 0, 0, 0, 0, 0], wrench=[0, 0, -10, 0, 0, 0])[:3].round(2)
        array([   0.  , -133.13,  -45.01])
    """
    F = check_wrench(wrench)
    g = gravity_torque(arm, q, gravity)
    broadcast_shape("configurations and wrenches", g.shape[:-1], F.shape[:-1])
    return g - np.einsum("...ij,...i->...j", jacobian(arm, q), F)


def check_wrench(wrench: ArrayLike) -> Array:
    """Convert wrenches to an array of shape (..., 6).

    Raises ArmError for any different shape and for NaN.
    """
    expected = "six finite numbers (fx, fy, fz, mx, my, mz)"
    return finite_array(wrench, "wrench", expected, (6,), many=True)


def with_payload(arm: Arm, mass: float, com: ArrayLike = (0.0, 0.0, 0.0)) -> Arm:
    """Return the arm with a mass fixed to its last link, such as a tool or a load.

    Args:
        arm: The arm, with its bodies.
        mass: Mass of the payload, in kg.
        com: The payload's centre of mass in the last frame, shape (3,), in m.

    Returns:
        The arm; the last link's mass, centre and inertia tensor include the payload, a point mass.

    Example:
        >>> from helpers.robots import UR10E
        >>> with_payload(UR10E, 2.0).bodies[-1].mass
        2.615
    """
    require_bodies(arm)
    masses, coms = _masses_and_centres(arm)
    mass = finite_number(mass, "mass", "a finite number of kg, 0 or more", least=0)
    payload_centre = finite_array(com, "com", "three finite coordinates in m", (3,))
    if not mass:
        return arm
    total = masses[-1] + mass
    centre = (masses[-1] * np.array(coms[-1]) + mass * payload_centre) / total
    inertia = np.array(arm.bodies[-1].inertia)
    for part, point in ((masses[-1], np.array(coms[-1])), (mass, payload_centre)):
        r = point - centre  # parallel axis theorem
        inertia = inertia + part * ((r @ r) * np.eye(3) - np.outer(r, r))
    body = Body(float(total), tuple(map(float, centre)), inertia.tolist())
    return replace(arm, bodies=(*arm.bodies[:-1], body))


def centres_in(frames_to: ArrayLike, frames_from: ArrayLike, centres: ArrayLike) -> Array:
    """Convert one point per link from one set of link frames to another.

    Use it for centres of mass from a paper whose frames are not those of the table.

    Args:
        frames_to: Frames in which the points are asked for, at one configuration, shape (n, 4, 4).
        frames_from: Frames in which the points are given, at the same configuration, shape
            (n, 4, 4).
        centres: The points, shape (n, 3), in m.

    Returns:
        The same points in the axes of `frames_to`, shape (n, 3), in m.

    Example:
        >>> to, start = np.eye(4), np.eye(4)
        >>> to[:3, 3] = 0, 0, 0.5
        >>> centres_in([to], [start], [[0.1, 0, 0.7]]).round(3)
        array([[0.1, 0. , 0.2]])
    """
    to = finite_array(frames_to, "frames_to", "frames (n, 4, 4)", (None, 4, 4))
    start = finite_array(frames_from, "frames_from", "frames (n, 4, 4)", (None, 4, 4))
    points = finite_array(centres, "centres", "points (n, 3)", (None, 3))
    if not len(to) == len(start) == len(points):
        raise ArmError(
            f"frames {to.shape}, {start.shape} and points {points.shape} do not fit; expected (n,"
            " 4, 4) twice and (n, 3)"
        )
    world = np.einsum("nij,nj->ni", start[:, :3, :3], points) + start[:, :3, 3]
    return np.einsum("nji,nj->ni", to[:, :3, :3], world - to[:, :3, 3])


def require_bodies(arm: Arm) -> None:
    """Raise ArmError for an arm without masses."""
    require_type(arm, Arm, "arm")
    if not arm.bodies:
        raise ArmError(
            f"{arm.name} has no masses; give bodies, one Body for each of its {len(arm.rows)} rows"
        )


# Recursions over the links, which `helpers.program` records; `up` is -gravity in base axes


def _compute_energy(arm: Arm, motions: Sequence[RowMotion], *up: Value) -> Sequence[Value]:
    """Sum m (up . c) over the links, c being the centre of mass in base axes."""
    total = 0.0
    _, *frames = frame_columns(motions)
    for (x, y, z, origin), m, com in zip(frames, *_masses_and_centres(arm), strict=True):
        in_plane = linear_combination(com[0], x, com[1], y)
        centre = linear_combination(1.0, in_plane, 1.0, linear_combination(com[2], z, 1.0, origin))
        total = total + m * sum(u * c for u, c in zip(up, centre, strict=True))
    return [total]


def _compute_torques(arm: Arm, motions: Sequence[RowMotion], *up: Value) -> Sequence[Value]:
    """Sum mass and first moment (x, y, z) from the tip to the base, and compute each torque."""
    mass, (x, y, z), torques = 0.0, (0.0, 0.0, 0.0), []
    links = zip(motions, _upward_in_rows(motions, up), *_masses_and_centres(arm), strict=True)
    for (row, c, s, d), row_up, m, com in reversed(list(links)):
        x, y, z, mass = x + m * com[0], y + m * com[1], z + m * com[2], mass + m
        y, z = row.cos_alpha * y - row.sin_alpha * z, row.cos_alpha * z + row.sin_alpha * y
        x, z = x + mass * row.a, z + mass * d
        if row.kind == "revolute":
            torques.append(row_up[1] * x - row_up[0] * y)
        elif row.kind == "prismatic":
            torques.append(mass * row_up[2])
        x, y = c * x - s * y, s * x + c * y
    return torques[::-1]


def _upward_in_rows(motions: Sequence[RowMotion], up: Vector) -> Iterator[Vector]:
    """Yield `up` in the axes of each row, after its turn about z and before that about x."""
    x, y, z = up
    for row, c, s, _ in motions:
        x, y = c * x + s * y, c * y - s * x
        yield x, y, z
        (y,), (z,) = rotate_about_x(row, (y,), (z,))


def _upward_vector(arm: Arm, gravity: ArrayLike) -> list[float]:
    """Check the arm and gravity, and return -gravity."""
    require_bodies(arm)
    expected = "a vector of three finite numbers in m/s^2"
    return (-finite_array(gravity, "gravity", expected, (3,))).tolist()


def _masses_and_centres(arm: Arm) -> tuple[list[float], list[list[float]]]:
    """Return the links' masses (rows) in kg and centres of mass (rows, 3) in m."""
    masses = [arm.number(body.mass) for body in arm.bodies]
    return masses, [[arm.number(c) for c in body.com] for body in arm.bodies]
