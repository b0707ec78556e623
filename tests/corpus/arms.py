"""Define the arms of the homework, typed independently of `helpers`, and random arms."""

import math

from tests.corpus.machine import Machine

H = math.pi / 2

# Typed from the homework's statement and the makers' data sheets, not taken from helpers.robots.
_PANDA = [
    ("R", 0, H, 0.333, 0),
    ("R", 0, -H, 0, 0),
    ("R", 0.0825, -H, 0.316, 0),
    ("R", -0.0825, H, 0, 0),
    ("R", 0, H, 0.384, 0),
    ("R", 0.088, -H, 0, 0),
    ("R", 0, 0, -0.207, 0),
]
_UR_HOMEWORK = [
    ("R", 0, -H, 0.128, 0),
    ("R", 0.6127, math.pi, 0, -H),
    ("R", 0.5716, math.pi, 0, 0),
    ("R", 0, H, 0.1639, H),
    ("R", 0, -H, 0.1157, 0),
    ("R", 0, 0, 0.1922, 0),
]
_UR = [
    ("R", 0, H, 0.1807, 0),
    ("R", -0.6127, 0, 0, 0),
    ("R", -0.57155, 0, 0, 0),
    ("R", 0, H, 0.17415, 0),
    ("R", 0, -H, 0.11985, 0),
    ("R", 0, 0, 0.21655, 0),
]
_STANFORD = [
    ("R", 0, -H, 0, 0),
    ("R", 0, H, 0.154, 0),
    ("P", 0, 0, 0, 0),
    ("R", 0, -H, 0, 0),
    ("R", 0, H, 0, 0),
    ("R", 0, 0, 0.263, 0),
]
_ELBOW = [("R", 0, H, 0.5, 0), ("R", 0.4, 0, 0, 0), ("R", 0.3, 0, 0, 0)]
_LOCKED = [("F", *row[1:]) if i == 2 else row for i, row in enumerate(_PANDA)]

KNOWN = {
    "PANDA": Machine(_PANDA, "PANDA"),
    "UR10E_HOMEWORK": Machine(_UR_HOMEWORK, "UR10E_HOMEWORK"),
    "UR10E": Machine(_UR, "UR10E"),
    "STANFORD": Machine(_STANFORD, "STANFORD"),
    "ELBOW": Machine(_ELBOW, "ELBOW"),
    "PANDA.lock(3)": Machine(_LOCKED, "PANDA.lock(3)"),
}


# Every arm of the catalogue, copied by hand from its source and not from helpers. Random hand-ins
# are made for the arms in `KNOWN`.
_PANDA_HOMEWORK = [
    (kind, math.copysign(0.088, a) if abs(a) == 0.0825 else a, *rest) for kind, a, *rest in _PANDA
]
_TWO_LINK = [("R", 0.5, 0, 0, 0), ("R", 0.4, 0, 0, 0)]
CATALOGUE = KNOWN | {
    "PANDA_HOMEWORK": Machine(_PANDA_HOMEWORK, "PANDA_HOMEWORK"),
    "TWO_LINK": Machine(_TWO_LINK, "TWO_LINK"),
    "THREE_LINK": Machine([*_TWO_LINK, ("R", 0.2, 0, 0, 0)], "THREE_LINK"),
}

_EVERYWHERE, _STRONG = (-math.inf, math.inf), (math.inf, math.inf)
_UR_TURNS = (-math.radians(360), math.radians(360))
# Lower and upper limit, largest speed and largest torque of each joint, in rad, m, s and N m: from
# Franka's data sheet, q_2 and q_4 in the signs of the table, and from Universal Robots' manual.
_PANDA_LIMITS = [
    (-2.8973, 2.8973, 2.175, 87),
    (-1.7628, 1.7628, 2.175, 87),
    (-2.8973, 2.8973, 2.175, 87),
    (0.0698, 3.0718, 2.175, 87),
    (-2.8973, 2.8973, 2.61, 12),
    (-0.0175, 3.7525, 2.61, 12),
    (-2.8973, 2.8973, 2.61, 12),
]
_UR_LIMITS = [
    *[(*_UR_TURNS, math.radians(120), 330)] * 2,
    (*_UR_TURNS, math.radians(180), 150),
    *[(*_UR_TURNS, math.radians(180), 56)] * 3,
]
# An arm that is not here has no limits. The Stanford arm's rod is ours.
LIMITS = {
    "PANDA": _PANDA_LIMITS,
    "PANDA_HOMEWORK": _PANDA_LIMITS,
    "UR10E": _UR_LIMITS,
    "UR10E_HOMEWORK": _UR_LIMITS,
    "STANFORD": [
        (0.1, 1.0, *_STRONG) if kind == "P" else (*_EVERYWHERE, *_STRONG) for kind, *_ in _STANFORD
    ],
}


def random_machine(rng, rows=None):
    """Return a random table of mixed joints and angles.

    Now and then it has a locked joint, a fixed row for the base or a fixed row for the tool.
    """
    rows = rows or int(rng.integers(3, 8))
    table = []
    for k in range(rows):
        kind = "P" if rng.random() < 0.15 and k else "R"
        if rng.random() < 0.08 and 0 < k < rows - 1:
            kind = "F"
        alpha = rng.choice(
            [0, H, -H, math.pi, round(float(rng.uniform(-1.2, 1.2)), 3)],
            p=[0.2, 0.3, 0.3, 0.05, 0.15],
        )
        a = 0 if rng.random() < 0.35 else round(float(rng.uniform(0.05, 0.6)), 4)
        d = 0 if rng.random() < 0.35 else round(float(rng.uniform(0.05, 0.6)), 4)
        theta = (
            rng.choice([0, H, -H, math.pi], p=[0.7, 0.13, 0.13, 0.04])
            if kind != "P"
            else rng.choice([0, H])
        )
        if not a and not d and kind == "R":
            a = round(float(rng.uniform(0.05, 0.6)), 4)
        table.append((kind, a, float(alpha), d, float(theta)))
    if rng.random() < 0.08:
        table = [("F", 0.1, float(rng.choice([0, H, -H])), 0.25, float(rng.choice([0, H]))), *table]
    if rng.random() < 0.08:
        table = [*table, ("F", 0.05, float(rng.choice([0, H, -H])), 0.12, 0.0)]
    return Machine(table, "random")


def some_machine(rng):
    """Return a known machine or a random one of at least three joints."""
    if rng.random() < 0.5:
        return KNOWN[str(rng.choice(list(KNOWN)))]
    while (machine := random_machine(rng)).dof < 3:
        pass
    return machine


def draw_configuration(machine, rng, decimals=3):
    """Return random joint values away from 0, rounded as a student types them."""
    q = []
    for kind in machine.kinds:
        x = rng.uniform(0.2, 1.4) * rng.choice([-1, 1]) if kind == "R" else rng.uniform(0.1, 0.6)
        q.append(round(float(x), decimals))
    return q
