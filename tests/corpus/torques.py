"""Compute right and mistaken torques g(q) - J^T F.

The gravity term sums the rise of each centre of mass under each joint.
"""

import math

import numpy as np

from tests.corpus import tables
from tests.corpus.machine import cross

# Masses and centres of the Panda's links (Gaz et al. 2019) in the table's frames, typed anew.
PANDA = [
    (4.970684, 0.003875, -0.04762, -0.002081),
    (0.646926, -0.003141, 0.003495, 0.02872),
    (3.228604, -0.054982, 0.066502, 0.039252),
    (3.587895, 0.02933, -0.027454, 0.104419),
    (1.225946, -0.011953, -0.038437, -0.041065),
    (1.666555, -0.027851, 0.010517, -0.014117),
    (0.735522, 0.010517, 0.004252, 0.145403),
]


# The same masses in the frames of the paper.
PAPER = [
    (4.970684, 0.003875, 0.002081, -0.04762),
    (0.646926, -0.003141, -0.02872, 0.003495),
    (3.228604, 0.027518, 0.039252, -0.066502),
    (3.587895, -0.05317, 0.104419, 0.027454),
    (1.225946, -0.011953, 0.041065, -0.038437),
    (1.666555, 0.060149, -0.014117, -0.010517),
    (0.735522, 0.010517, -0.004252, 0.061597),
]


def bodies(m, rng):
    """Return (mass, x, y, z) per link: the Panda's own, or random ones."""
    if m.name == "PANDA":
        return PANDA
    return [
        (
            round(float(rng.uniform(0.5, 6)), 3),
            *(round(float(x), 3) for x in rng.uniform(-0.15, 0.15, 3)),
        )
        for _ in m.rows
    ]


def weight(m, links, q, g=9.81):
    """Return the gravity torques dP/dq (N m) from the rise of each centre of mass."""
    T = m.frames(q)
    tau = np.zeros(m.dof)
    for k, (mass, *c) in enumerate(links):
        p = (T[k + 1] @ [*c, 1])[:3]
        for j, (i, kind) in enumerate(zip(m.joints, m.kinds, strict=True)):
            if i <= k:
                z, o = T[i][:3, 2], T[i][:3, 3]
                tau[j] += mass * g * (cross(z, p - o)[2] if kind == "R" else z[2])
    return tau


def force(m, F, q):
    """Return J^T F for a wrench F at the tip, in base axes."""
    return m.jacobian(q).T @ F


def turned(R, F):
    """Return the wrench F with both halves turned by R."""
    return np.concatenate([R @ F[:3], R @ F[3:]])


def mistakes(m, links, q, F, rng):
    """Yield (cause, torques) for each single mistake."""
    W, P = weight(m, links, q), force(m, F, q)
    R = m.tip(q)[:3, :3]
    yield "tau.force sign", W + P
    yield "tau.force missing", W
    yield "tau.weight missing", -P
    yield "tau.weight sign", -W - P
    yield "tau.gravity:9.8", W * 9.8 / 9.81 - P
    yield "tau.force in tool", W - force(m, turned(R, F), q)
    if links == PANDA:
        yield "tau.paper centres", weight(m, PAPER, q) - P
    alone = [weight(m, [(b[0] * (k == i), *b[1:]) for k, b in enumerate(links)], q)
             for i in m.joints]  # fmt: skip
    yield "tau.own link", np.array([alone[k][k] for k in range(m.dof)]) - P
    masses = [*(b[0] for b in links[1:]), 0]
    moved = [(mass, *b[1:]) for mass, b in zip(masses, links, strict=True)]
    yield "tau.masses moved", weight(m, moved, q) - P
    yield "tau.gravity:10", W * 10 / 9.81 - P
    yield "tau.all signs", P - W
    yield "tau.reversed order", (W - P)[::-1]
    i = int(rng.integers(len(links)))
    without = [(0 if k == i else b[0], *b[1:]) for k, b in enumerate(links)]
    yield f"tau.mass missing:{i + 1}", weight(m, without, q) - P
    degrees = [math.radians(x) if k == "R" else x for x, k in zip(q, m.kinds, strict=True)]
    yield "tau.degrees", weight(m, links, degrees) - force(m, F, degrees)
    if m.name == "PANDA":
        short = m.with_rows(*tables.without_pen(m))
        links_of_short = [*links[:-1], (*links[-1][:3], links[-1][3] - 0.1)]
        yield "table.pen", weight(short, links_of_short, q) - force(short, F, q)


def pairs(m, links, q, F, rng):
    """Yield (causes, torques) for pairs of mistakes."""
    mistaken_weights = {
        "tau.gravity:9.8": weight(m, links, q, 9.8),
        "tau.weight sign": -weight(m, links, q),
    }
    P = force(m, F, q)
    for name, W in mistaken_weights.items():
        yield f"{name} + tau.force sign", W + P
        yield f"{name} + tau.all signs", P - W
        yield f"{name} + tau.force missing", W
