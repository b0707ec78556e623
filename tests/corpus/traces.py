"""Trace circles as a student's program does, by Euler's or Runge-Kutta's method.

A mistake is put into the Jacobian, the table or the velocity. The joint trajectory follows from it.
"""

import math

import numpy as np


def velocity(plane, t, radius, period, phase=0.0):
    """Return the velocity at time t on a circle that starts on the first axis of `plane`."""
    w = 2 * math.pi / period
    v = np.zeros(3)
    v["xyz".index(plane[0])] = -math.sin(w * t + phase)
    v["xyz".index(plane[1])] = math.cos(w * t + phase)
    return radius * w * v


def point(plane, t, radius, period):
    """Return the position at time t relative to the circle's first point."""
    w = 2 * math.pi / period
    p = np.zeros(3)
    p["xyz".index(plane[0])] = math.cos(w * t) - 1
    p["xyz".index(plane[1])] = math.sin(w * t)
    return radius * p


def inverse(J):
    """Return the inverse of a square Jacobian, else its pseudo-inverse."""
    return np.linalg.inv(J) if J.shape[0] == J.shape[1] else np.linalg.pinv(J)


def solved(J, twist):
    """Return the joint rates of a twist, or raise LinAlgError if J cannot produce it."""
    rates = inverse(J) @ twist
    if np.abs(J @ rates - twist).max() > 1e-6:
        raise np.linalg.LinAlgError
    return rates


def turn_off(R, R0):
    """Return the small rotation vector from R to R0, in base axes."""
    E = R0 @ R.T
    return 0.5 * np.array([E[2, 1] - E[1, 2], E[0, 2] - E[2, 0], E[1, 0] - E[0, 1]])


class Task:
    """A circle that a machine draws from a start configuration."""

    def __init__(self, machine, start, plane, radius, period, steps):
        self.machine, self.start = machine, np.array(start, float)
        self.plane, self.radius, self.period, self.steps = plane, radius, period, steps
        self.first = machine.tip(self.start)

    def path(self):
        """Return the arguments of `helpers.motion.circle` for this circle."""
        centre = self.first[:3, 3].copy()
        centre["xyz".index(self.plane[0])] -= self.radius
        return dict(
            centre=[float(x) for x in centre],
            radius=self.radius,
            plane=self.plane,
            period=self.period,
            steps=self.steps,
        )

    def run(
        self,
        method="euler",
        machine=None,
        radius=None,
        late=0,
        rate=1.0,
        signs=(1, 1, 1),
        order=(0, 1, 2),
        phase=0.0,
        J=None,
        steps=None,
        dt=None,
        rule=None,
        plane=None,
        gain=0.0,
    ):
        """Return the joint trajectory, (steps + 1, dof).

        The defaults trace the circle without a mistake. Each option changes one step of the method.
        """
        machine = machine or self.machine
        radius, steps = radius or self.radius, steps or self.steps
        plane = plane or self.plane
        dt = dt or self.period / self.steps
        J = J or (lambda q: machine.jacobian(q))
        R0, p0 = self.first[:3, :3], self.first[:3, 3]

        def slope(q, t):
            v = rate * velocity(plane, t + late * dt, radius, self.period, phase)
            v = (v * signs)[list(order)]
            w = np.zeros(3)
            if gain:
                T = self.machine.tip(q)
                v = v + gain * (p0 + point(plane, t, radius, self.period) - T[:3, 3])
                w = gain * turn_off(T[:3, :3], R0)
            return rule(q, v) if rule else solved(J(q), [*v, *w])

        q, rows = self.start, [self.start]
        for k in range(steps):
            t = k * dt
            if method == "rk4":
                a = slope(q, t)
                b = slope(q + dt / 2 * a, t + dt / 2)
                c = slope(q + dt / 2 * b, t + dt / 2)
                q = q + dt / 6 * (a + 2 * b + 2 * c + slope(q + dt * c, t + dt))
            else:
                q = q + dt * slope(q, t)
            rows.append(q)
        return np.array(rows)
