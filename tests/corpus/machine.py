"""Compute kinematics of a DH table by 4 x 4 products, one joint at a time.

The tests compare `helpers` with this module, so it shares no line with them.
"""

import math

import numpy as np

EYE = np.eye(4)


def move(x=0.0, y=0.0, z=0.0):
    """Return the 4 x 4 translation by x, y and z."""
    T = np.eye(4)
    T[:3, 3] = x, y, z
    return T


def step(a, alpha, d, theta):
    """Return Rot_z(theta) Trans_z(d) Trans_x(a) Rot_x(alpha), multiplied out."""
    c, s, ca, sa = math.cos(theta), math.sin(theta), math.cos(alpha), math.sin(alpha)
    return np.array(
        [[c, -s * ca, s * sa, a * c], [s, c * ca, -c * sa, a * s], [0, sa, ca, d], [0, 0, 0, 1.0]]
    )


def cross(u, v):
    """Return u x v of two 3-vectors. numpy.cross takes ten times as long."""
    return [
        u[1] * v[2] - u[2] * v[1],
        u[2] * v[0] - u[0] * v[2],
        u[0] * v[1] - u[1] * v[0],
    ]


class Machine:
    """A standard DH table of rows (kind, a, alpha, d, theta).

    The kind is "R" (revolute), "P" (prismatic) or "F" (fixed).
    """

    def __init__(self, rows, name="arm", bodies=None, values=None):
        self.rows = [tuple(row) for row in rows]
        self.name, self.bodies, self.values = name, bodies, values
        self.joints = [i for i, row in enumerate(self.rows) if row[0] != "F"]
        self.kinds = [self.rows[i][0] for i in self.joints]
        self.turns = np.array([kind == "R" for kind in self.kinds])
        self.dof = len(self.joints)

    def frames(self, q):
        """Return T_00 to T_0n at the joint values q."""
        T, frames, values = EYE, [EYE], iter(q)
        for kind, a, alpha, d, theta in self.rows:
            x = next(values) if kind != "F" else 0.0
            turn, slide = (theta + x, d) if kind == "R" else (theta, d + x)
            T = T @ step(a, alpha, slide, turn)
            frames.append(T)
        return frames

    def tip(self, q):
        """Return the tip's pose in the base frame."""
        return self.frames(q)[-1]

    def jacobian(self, q):
        """Return the 6 x dof geometric Jacobian in the base frame."""
        T = self.frames(q)
        p = T[-1][:3, 3]
        columns = []
        for i, kind in zip(self.joints, self.kinds, strict=True):
            z, o = T[i][:3, 2], T[i][:3, 3]
            columns.append([*cross(z, p - o), *z] if kind == "R" else [*z, 0, 0, 0])
        return np.array(columns).T

    def with_rows(self, rows):
        """Return a machine of the same name with other rows."""
        return Machine(rows, self.name, self.bodies, self.values)
