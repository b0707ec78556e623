"""Runs along circles: by Euler's method, by Runge and Kutta's, with the miss fed back, or by exact
joints at every step; right ones, and ones steered by a mistake.

Each is made as a student's program makes it: the mistake stands in the Jacobian, in the table, in
the velocity or in what is handed in, and the run is what comes of it.
"""

import math

import numpy as np

from tests.corpus.arms import KNOWN, random_machine
from tests.corpus.jacobians import recipe

HOMES = {
    "PANDA.lock(3)": [0, 0, math.pi / 2, 0, math.pi, 0],
    "UR10E": [0.3, -1.2, 1.3, -1.5, -1.2, 0.4],
    "UR10E_HOMEWORK": [0.2, 0.7, 1.1, 0.5, -1.2, 0.4],
    "STANFORD": [0.4, 0.9, 0.45, 0.6, 0.8, -0.3],
    "PANDA": [0.2, 0.4, -0.3, 1.4, 0.3, 1.5, 0.5],
}
PLANES = ("zy", "yz", "xy", "zx", "xz")


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

    def exact(self, machine=None):
        """Joints that are on the path at every time, by Newton's method from the step before."""
        machine = machine or self.machine
        q, rows = self.start.copy(), []
        R0, p0 = machine.tip(q)[:3, :3], self.first[:3, 3]
        for k in range(self.steps + 1):
            goal = p0 + point(self.plane, k * self.period / self.steps, self.radius, self.period)
            for _ in range(12 if k else 60):
                T = machine.tip(q)
                off = np.array([*(goal - T[:3, 3]), *turn_off(T[:3, :3], R0)])
                q = q + np.clip(inverse(machine.jacobian(q)) @ off, -0.3, 0.3)
                if np.abs(off).max() < 1e-11:
                    break
            else:
                raise np.linalg.LinAlgError
            rows.append(q)
        return np.array(rows)


def changed(m, k, **entries):
    row = dict(zip(("kind", "a", "alpha", "d", "theta"), m.rows[k], strict=True))
    return m.with_rows([*m.rows[:k], tuple({**row, **entries}.values()), *m.rows[k + 1 :]])


def in_the_loop(task, rng, method):
    """Mistakes in the recipe, the table or the velocity; (name, run)."""
    m, k = task.machine, int(rng.integers(len(task.machine.rows)))

    def with_J(J):
        return lambda: task.run(method, J=J)

    def halves(q):
        late = recipe(m, q, axis=1, origin=1)
        return np.vstack([recipe(m, q)[:3], late[3:]])

    yield "J.z_i angular", with_J(halves)
    yield "J.z_i", with_J(lambda q: recipe(m, q, axis=1))
    yield "J.one frame late", with_J(lambda q: recipe(m, q, axis=1, origin=1))
    yield "J.origin late", with_J(lambda q: recipe(m, q, origin=1))
    yield "J.lever tip", with_J(lambda q: recipe(m, q, lever="o_n"))
    yield "J.rows of T", with_J(lambda q: recipe(m, q, rows=True))
    if m.joints != list(range(m.dof)):
        yield "J.z counted on", with_J(lambda q: recipe(m, q, count=True))
    if "P" in m.kinds:
        yield "J.slide turns", with_J(lambda q: recipe(m, q, slides=False))
    kind, a, alpha, d, _ = m.rows[k]
    if abs(math.sin(alpha)) > 0.1:
        yield (
            f"table.twist:{k + 1}",
            lambda: task.run(method, machine=changed(m, k, alpha=-alpha)),
        )
    for name, x in (("a", a), ("d", d)):
        if x and kind != "P":
            wrong = {name: -x}
            yield (
                f"table.sign:{name}:{k + 1}",
                lambda wrong=wrong: task.run(method, machine=changed(m, k, **wrong)),
            )
    if m.name.startswith("PANDA"):
        longer = m.with_rows([(k, math.copysign(0.088, a) if a else 0, *r) for k, a, *r in m.rows])
        yield "table.length:a_3:a_6", lambda: task.run(method, machine=longer)
    if m.name in ("PANDA", "PANDA.lock(3)", "UR10E", "UR10E_HOMEWORK"):
        shorter = m.rows[-1][3] + (0.1 if m.name.startswith("P") else -0.1)
        pen = changed(m, len(m.rows) - 1, d=shorter)
        # At held orientation the pen moves as the flange does: only another turn would show it.
        yield "harmless pen", lambda: task.run(method, machine=pen)
    if method == "euler":
        yield "trace.next velocity", lambda: task.run(late=1)
    yield (
        "trace.position only",
        lambda: task.run(method, rule=lambda q, v: np.linalg.pinv(m.jacobian(q)[:3]) @ v),
    )
    yield (
        "trace.transpose",
        lambda: task.run(method, rule=lambda q, v: m.jacobian(q)[:3].T @ v),
    )


def by_the_table(task, rng, method):
    """Inverse kinematics at every step, with a wrong table; (name, run)."""
    m = task.machine
    # Not the last row: there a sign of d draws the same points as one of the twist before it.
    for k, (kind, a, _, d, _) in enumerate(m.rows[:-1]):
        for name, x in (("a", a), ("d", d)):
            if x and kind != "P":
                for key, wrong in (("sign", -x), ("missing", 0)):
                    other = changed(m, k, **{name: wrong})
                    yield f"table.{key}:{name}:{k + 1}", lambda other=other: task.exact(other)
    if m.name in ("PANDA", "PANDA.lock(3)", "UR10E", "UR10E_HOMEWORK"):
        pen = changed(m, len(m.rows) - 1, d=m.rows[-1][3] + (0.1 if m.name[0] == "P" else -0.1))
        yield "table.pen", lambda: task.exact(pen)


def of_the_path(task, rng, method):
    """Another path than the one asked for, rightly followed; (name, run)."""
    i, j = ("xyz".index(axis) for axis in task.plane)
    mirror = np.ones(3)
    mirror[i] = -1
    swap = [0, 1, 2]
    swap[i], swap[j] = j, i
    yield "trace.backwards", lambda: task.run(method, signs=tuple(1.0 - 2 * (np.arange(3) == j)))
    yield "trace.other side", lambda: task.run(method, rate=-1.0)
    factor = float(rng.choice([0.5, 0.8, 1.2]))
    yield "trace.scaled", lambda: task.run(method, radius=factor * task.radius)
    yield "trace.scaled", lambda: task.run(method, rate=task.period / 200)
    share = int(rng.choice([2, 4]))
    yield (
        "trace.fraction",
        lambda: task.run(method, dt=task.period / task.steps / share),
    )
    yield "trace.displaced", lambda: displaced(task, rng)


def displaced(task, rng):
    """The whole circle somewhere else: another start."""
    by = rng.uniform(0.02, 0.03, 3) * rng.choice([-1, 1], 3)
    q = task.start.copy()
    goal = task.first[:3, 3] + by
    for _ in range(12):
        T = task.machine.tip(q)
        off = [*(goal - T[:3, 3]), *turn_off(T[:3, :3], task.first[:3, :3])]
        q = q + inverse(task.machine.jacobian(q)) @ off
    other = Task(task.machine, q, task.plane, task.radius, task.period, task.steps)
    return other.run()


def of_the_rows(task, rng, method):
    """What is handed in; (name, run)."""
    m, steps = task.machine, task.steps

    def right():
        return task.run(method)

    yield "trace.backwards", lambda: right()[::-1]
    yield "trace.degrees", lambda: np.where(m.turns, np.degrees(right()), right())
    yield "trace.one more", lambda: task.run(method, steps=steps + 1)
    yield "trace.shape", lambda: right()[: steps // 2]
    if m.name != "random":
        last = np.eye(m.dof)[-1]
        round_ = np.linspace(0, 2 * math.pi, steps + 1)
        yield "trace.spins", lambda: right() + np.outer(round_, last)
    if m.name == "PANDA.lock(3)":
        k = int(rng.integers(steps // 3, 2 * steps // 3))
        flip = np.array([0, 0, 0, math.pi, 0, math.pi])
        yield "trace.jump", lambda: right() + np.where(np.arange(steps + 1)[:, None] >= k, flip, 0)


def some_task(rng):
    while True:
        name = str(rng.choice([*HOMES, "random"], p=[0.3, 0.13, 0.13, 0.13, 0.11, 0.2]))
        if name == "random":
            m = random_machine(rng, 6)
            if m.dof != 6:
                continue
            start = rng.uniform(0.3, 1.2, 6) * rng.choice([-1, 1], 6)
            start = np.where(np.array(m.kinds) == "P", np.abs(start) / 2, start)
        else:
            m, start = KNOWN[name], np.array(HOMES[name])
            if name != "PANDA.lock(3)" or rng.random() < 0.4:
                start = start + rng.uniform(-0.2, 0.2, m.dof)
        start = np.round(start, 4)
        if np.linalg.svd(m.jacobian(start))[1][5] < 0.05:
            continue
        radius = float(rng.choice([0.05, 0.08, 0.1]))
        steps = int(rng.choice([100, 150, 250, 500], p=[0.3, 0.3, 0.3, 0.1]))
        period = float(rng.choice([5.0, 2.0, 200.0]))
        return Task(m, start, str(rng.choice(PLANES)), radius, period, steps)


def smooth(q):
    return np.isfinite(q).all() and np.abs(np.diff(q, axis=0)).max() < 0.25


def miss(task, q):
    """The largest distance from the path (m) and turn from the first pose (rad)."""
    far = turned = 0.0
    for k in range(min(len(q), task.steps + 1)):
        T = task.machine.tip(q[k])
        goal = task.first[:3, 3] + point(
            task.plane, k * task.period / task.steps, task.radius, task.period
        )
        R = task.first[:3, :3].T @ T[:3, :3]
        far = max(far, float(np.linalg.norm(T[:3, 3] - goal)))
        turned = max(turned, math.acos(max(-1.0, min(1.0, (np.trace(R) - 1) / 2))))
    return far, turned


def right_run(task, rng):
    how = str(rng.choice(["euler", "rk4", "gain", "exact"]))
    if how == "exact":
        return how, task.exact()
    return how, task.run(
        "rk4" if how == "rk4" else "euler", gain=2.0 / task.period if how == "gain" else 0.0
    )


def some_run(rng, wrong):
    """A task, a run of it and what spoils that, None where nothing does; None where it came to
    nothing."""
    task = some_task(rng)
    with np.errstate(all="ignore"):
        try:
            how, q = right_run(task, rng)
            if not smooth(q) or max(miss(task, q)) > 1.2e-3:
                return None
            if not wrong:
                return task, q, None
            how = "rk4" if rng.random() < 0.25 else "euler"
            rules = (in_the_loop, of_the_path, of_the_rows, by_the_table)
            options = list(rules[rng.integers(7) % 4](task, rng, how))
            cause, make = options[int(rng.integers(len(options)))]
            q = make()
        except np.linalg.LinAlgError:
            return None
    if not np.isfinite(q).all() or np.abs(q).max() > 1e4 or cause == "harmless pen":
        return None
    hidden = shows(cause) and (not smooth(q) or apart(task, q, task.run(how)) < 8e-3)
    return None if hidden else (task, q, cause)


def apart(task, q, right):
    """The largest distance (m) or turn (rad) between the tips of two runs."""
    found = 0.0
    for x, y in zip(q[::5], right[::5], strict=False):
        A, B = task.machine.tip(x), task.machine.tip(y)
        turn = np.linalg.norm(A[:3, :3] - B[:3, :3]) / math.sqrt(2)
        found = max(found, float(np.linalg.norm(A[:3, 3] - B[:3, 3])), float(turn))
    return found


def shows(cause):
    """Whether a mistake is one that a run may hide: then it is kept only where the tip shows it."""
    return cause is not None and cause not in (
        "trace.degrees",
        "trace.one more",
        "trace.shape",
        "trace.jump",
        "trace.spins",
    )
