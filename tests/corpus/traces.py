"""Runs along the homework's circle by Euler's method, right and steered by mistakes."""

import math

import numpy as np

from tests.corpus.arms import KNOWN
from tests.corpus.jacobians import recipe

ARM = KNOWN["PANDA.lock(3)"]
HOME = [0, 0, math.pi / 2, 0, math.pi, 0]
TOP = ARM.tip(HOME)[:3, 3]


def circle(t, radius, period, phase=0.0):
    """Velocities of the circle in y and z that begins at its top and moves towards +y."""
    w = 2 * math.pi / period
    return radius * w * np.array([0, math.cos(w * t + phase), -math.sin(w * t + phase)])


def run(
    steps, period=5.0, machine=ARM, radius=0.1, start=HOME, late=0, rate=1.0, plain=True, **how
):
    """Joints (steps + 1, 6); `how` spoils the Jacobian's recipe."""
    dt, q = period / steps, np.array(start, float)
    rows = [q]
    for k in range(steps):
        J = recipe(machine, q, **how)
        if not plain:
            J = np.vstack([recipe(machine, q)[:3], J[3:]])
        v = rate * circle((k + late) * dt, radius, period)
        q = q + dt * np.linalg.solve(J, [*v, 0, 0, 0])
        rows.append(q)
    return np.array(rows)


def mistakes(steps, rng):
    longer = ARM.with_rows([(k, math.copysign(0.088, a) if a else 0, *r) for k, a, *r in ARM.rows])
    yield "J.z_i angular", lambda: run(steps, axis=1, origin=1, plain=False)
    yield "table.length:a_3:a_6", lambda: run(steps, machine=longer)
    yield "trace.next velocity", lambda: run(steps, late=1)
    yield "trace.backwards", lambda: run(steps)[::-1]
    yield "trace.degrees", lambda: np.degrees(run(steps))
    yield "trace.scaled", lambda: run(steps, radius=float(rng.choice([0.05, 0.08, 0.12])))
    yield "trace.scaled", lambda: run(steps, rate=5 / 200)
    yield "trace.one more", lambda: run(steps + 1, period=5.0 * (steps + 1) / steps)
    yield (
        "trace.spins",
        lambda: run(steps) + np.outer(np.linspace(0, 2 * math.pi, steps + 1), np.eye(6)[5]),
    )
    k = int(rng.integers(steps // 3, 2 * steps // 3))
    flip = np.array([0, 0, 0, math.pi, 0, math.pi])
    yield "trace.jump", lambda: run(steps) + np.where(np.arange(steps + 1)[:, None] >= k, flip, 0)
    yield "trace.fraction", lambda: quarter(steps)


def quarter(steps):
    """The circle's first quarter in the whole time."""
    return run(4 * steps, period=5.0)[: steps + 1]


def cases(rng, count):
    made = 0
    while made < count:
        steps, d = int(rng.choice([150, 250])), int(rng.choice([5, 6, 7]))
        options = list(mistakes(steps, rng))
        right = rng.random() < 0.25
        cause, q = (
            (None, run(steps))
            if right
            else (lambda o: (o[0], o[1]()))(options[made % len(options)])
        )
        rows = [[f"{x:.{d}f}" for x in row] for row in q]
        form = str(rng.choice(["array", "csv"]))
        typed = (
            [[float(x) for x in row] for row in rows]
            if form == "array"
            else "\n".join(",".join(r) for r in rows)
        )
        yield dict(
            topic="trace",
            arm="PANDA.lock(3)",
            typed=typed,
            form=form,
            digits=d,
            kind="right" if right else "single",
            cause=cause,
            path=dict(
                centre=[float(TOP[0]), float(TOP[1]), float(TOP[2]) - 0.1],
                radius=0.1,
                plane="zy",
                period=5.0,
                steps=steps,
            ),
        )
        made += 1
