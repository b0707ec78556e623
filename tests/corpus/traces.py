"""Runs along circles, by Euler's method or by Runge and Kutta's, as a student's program makes them:
a mistake stands in the Jacobian, in the table or in the velocity, and the run is what comes of it.
"""

import math

import numpy as np


def velocity(plane, t, radius, period, phase=0.0):
    """Velocity of a circle whose two axes are named in order; it sets out along the second."""
    w = 2 * math.pi / period
    v = np.zeros(3)
    v["xyz".index(plane[0])] = -math.sin(w * t + phase)
    v["xyz".index(plane[1])] = math.cos(w * t + phase)
    return radius * w * v


def point(plane, t, radius, period):
    """Where the circle is at t, from its first point."""
    w = 2 * math.pi / period
    p = np.zeros(3)
    p["xyz".index(plane[0])] = math.cos(w * t) - 1
    p["xyz".index(plane[1])] = math.sin(w * t)
    return radius * p


def inverse(J):
    return np.linalg.inv(J) if J.shape[0] == J.shape[1] else np.linalg.pinv(J)


def solved(J, twist):
    """Joint rates of a twist; a Jacobian that cannot give it makes no run."""
    rates = inverse(J) @ twist
    if np.abs(J @ rates - twist).max() > 1e-6:
        raise np.linalg.LinAlgError
    return rates


def turn_off(R, R0):
    """The small turn that takes R to R0, in base axes."""
    E = R0 @ R.T
    return 0.5 * np.array([E[2, 1] - E[1, 2], E[0, 2] - E[2, 0], E[1, 0] - E[0, 1]])


class Task:
    """A circle to be drawn by a machine from a start."""

    def __init__(self, machine, start, plane, radius, period, steps):
        self.machine, self.start = machine, np.array(start, float)
        self.plane, self.radius, self.period, self.steps = plane, radius, period, steps
        self.first = machine.tip(self.start)

    def path(self):
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
        """Joints (steps + 1, dof)."""
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
