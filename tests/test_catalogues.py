"""Every mistake of the catalogues, and every two of them, by the corpus's own kinematics."""

import math
from itertools import combinations, product

import numpy as np
import pytest

from helpers.arm import Body
from helpers.checks import jacobian_causes, torques_causes
from helpers.checks.jacobian import _other_ways
from helpers.reading.sentences import listed
from tests.corpus.arms import KNOWN
from tests.corpus.jacobians import before, in_frame, recipe
from tests.corpus.machine import Machine
from tests.corpus.torques import PANDA as LINKS
from tests.corpus.torques import craig, force, turned, weight
from tests.judge_words import arm_of

H, RAD = math.pi / 2, math.pi / 180
Q = np.array([0.41, -0.73, 0.52, -0.96, 0.67, 0.88, 0.29])
NEAR = {  # lengths that may be taken for one another
    "PANDA": {"a_3:a_6": (0.0825, 0.088), "a_6:a_3": (0.088, 0.0825)},
    "PANDA.lock(3)": {"a_3:a_6": (0.0825, 0.088), "a_6:a_3": (0.088, 0.0825)},
    "UR10E_HOMEWORK": {"a_2:a_3": (0.6127, 0.5716), "a_3:a_2": (0.5716, 0.6127)},
}
FLANGE = {"PANDA": -0.107, "PANDA.lock(3)": -0.107, "UR10E_HOMEWORK": 0.0922}
MIXED = Machine([("R", 0.1, H, 0.3, 0), ("F", 0.05, -0.4, 0.12, H), ("P", 0, H, 0.2, 0),
                 ("R", 0.3, 0.6, 0.15, 1)])  # fmt: skip


class Each:
    """Draws this number from any range."""

    def __init__(self, k):
        self.k = k

    def integers(self, *_):
        return self.k


def same(causes, made, expected):
    """Whether the catalogue holds what is expected, and nothing else."""
    found = sorted(zip([c.name for c in causes], made, strict=True), key=lambda x: x[0])
    expected = sorted(expected, key=lambda x: x[0])
    assert [name for name, _ in found] == [name for name, _ in expected]
    for (name, one), (_, other) in zip(found, expected, strict=True):
        np.testing.assert_allclose(one, other, rtol=1e-9, atol=1e-9, err_msg=name)


# Tables


def lengths(m):
    if m.name in FLANGE:
        yield "table.pen", m.with_rows([*m.rows[:-1], (*m.rows[-1][:3], FLANGE[m.name], 0)])
    for names, (x, y) in NEAR.get(m.name, {}).items():
        swapped = {x: y, -x: -y}
        rows = [(kind, swapped.get(a, a), *rest) for kind, a, *rest in m.rows]
        yield f"table.length:{names}", m.with_rows(rows)


def tables(m):
    yield from lengths(m)
    yield "table.offsets", m.with_rows([(*r[:4], 0 if r[0] == "R" else r[4]) for r in m.rows])
    yield "table.twists", m.with_rows([(k, a, -alpha, d, t) for k, a, alpha, d, t in m.rows])
    for i, row in enumerate(m.rows):
        slips = (
            {"table.twist": (2, -1), "table.no twist": (2, 0)}
            if math.sin(row[2]) ** 2 > 1e-9
            else {}
        )
        for x, k in ("a", 1), ("d", 3):
            slips |= {f"table.sign:{x}": (k, -1), f"table.missing:{x}": (k, 0)} if row[k] else {}
        slips |= {"table.offset": (4, 0)} if row[4] else {}
        for name, (k, by) in slips.items():
            wrong = (*row[:k], by * row[k], *row[k + 1 :])
            yield f"{name}:{i + 1}", m.with_rows([*m.rows[:i], wrong, *m.rows[i + 1 :]])


def degrees(m, q):
    for factor in (RAD, 1 / RAD):
        yield np.where(m.turns, factor * np.array(q), q)


def other_units(m, q):
    yield from (("J.degrees", x) for x in degrees(m, q))
    if not all(m.turns):
        yield "ik.slide in millimetres", np.where(m.turns, q, 1000 * np.array(q))


# Jacobians


def recipes(m, q):
    found = {name: J for k in range(1, len(m.rows)) for name, J in before(m, q, Each(k))}
    del found["J.cross"], found["J.degrees"]
    return [("J.point:0", recipe(m, q, point=0)), *found.items()]


def writings(m, q, frame):
    """Functions of one Jacobian or many in base axes."""
    R, rows = [T[:3, :3] for T in m.frames(q)], len(m.rows)

    def seen(J, v=frame, w=frame):
        return np.concatenate([R[v].T @ J[..., :3, :], R[w].T @ J[..., 3:, :]], axis=-2)

    def by(factors):
        return lambda J: seen(J * factors)

    yield "J.halves", lambda J: np.roll(seen(J), 3, axis=-2)
    turns = np.repeat([-1.0, 1.0], 3)[:, None] * m.turns + ~m.turns
    yield "J.cross", by(turns)
    scales = {"all signs": (-1, -1), "angular sign": (1, -1), "millimetres": (1000, 1),
              "centimetres": (100, 1), "angular zero": (1, 0), "linear zero": (0, 1)}  # fmt: skip
    for name, factors in scales.items():
        yield f"J.{name}", by(np.repeat(factors, 3)[:, None])
    for factor in (RAD, 1 / RAD):
        yield "J.per degree", by(np.where(m.turns, factor, 1.0))
    if m.dof == 6:
        yield "J.transposed", lambda J: np.swapaxes(seen(J), -1, -2)
    yield "J.reversed order", lambda J: seen(J)[..., ::-1]
    for k, i in enumerate(m.joints):
        yield f"J.column sign:{i + 1}", by(1.0 - 2.0 * np.eye(m.dof)[k])
    for k, n in combinations(range(m.dof), 2):
        order = np.arange(m.dof)
        order[[k, n]] = n, k
        name = f"J.columns exchanged:{m.joints[k] + 1}:{m.joints[n] + 1}"
        yield name, lambda J, order=order: seen(J)[..., order]
    for k in (rows, *range(rows)):
        if k != frame:
            yield f"J.frame:{k}", lambda J, k=k: seen(J, k, k)
            yield f"J.frame angular:{k}", lambda J, k=k: seen(J, w=k)
            yield f"J.frame linear:{k}", lambda J, k=k: seen(J, v=k)
    back = R[frame or rows]
    yield (
        "J.frame turned back",
        lambda J: np.concatenate([back @ J[..., :3, :], back @ J[..., 3:, :]], axis=-2),
    )


WRITING = ("halves", "millimetres", "per degree", "all signs", "cross", "frame", "angular zero",
           "transposed")  # fmt: skip


@pytest.mark.parametrize(
    ("m", "frame"),
    [(KNOWN["PANDA"], 0), (KNOWN["UR10E_HOMEWORK"], 6), (KNOWN["PANDA.lock(3)"], 2), (MIXED, 0)],
)
def test_every_mistaken_jacobian(m, frame):
    q, arm = Q[: m.dof], arm_of(m)

    def seen(J):
        return in_frame(m, q, J, frame)

    right, writes = m.jacobian(q), list(writings(m, q, frame))
    befores = [*recipes(m, q), *((name, m.jacobian(x)) for name, x in other_units(m, q))]
    befores += [(name, wrong.jacobian(q)) for name, wrong in tables(m)]
    known = jacobian_causes.singles(arm, q, frame)
    np.testing.assert_allclose(known.right, seen(right), atol=1e-9)
    afters = [(name, write(right)) for name, write in writes]
    if m.dof != 6:
        afters = [(name, J) for name, J in afters if J.shape == right.shape]
    same(known.causes, known.made, [*((name, seen(J)) for name, J in befores), *afters])


@pytest.mark.parametrize(("m", "frame"), [(KNOWN["PANDA.lock(3)"], 2), (MIXED, 0)])
def test_every_two_mistakes_of_a_jacobian(m, frame):
    q = Q[: m.dof]
    right, writes = m.jacobian(q), list(writings(m, q, frame))
    wrong = [(name, m, x) for name, x in other_units(m, q)]
    wrong += [(name, other, q) for name, other in tables(m)]
    befores = [*recipes(m, q), *((name, other.jacobian(x)) for name, other, x in wrong)]
    both = [(f"{b} + {a}", write(J)) for a, write in writes for b, J in befores]
    axes = m.frames(q)[frame][:3, :3]
    named = [x for x in writes if x[0][2:].split(":")[0] in WRITING]
    for (a, one), (b, two) in combinations(named, 2):
        for first, second in ((two, one), (one, two)):
            J = first(right)
            J = np.concatenate([axes @ J[:3], axes @ J[3:]])
            both.append((f"{a} + {b}", second(J)))
    for name, other, x in wrong:
        both += [(f"{name} + {r}", in_frame(m, q, J, frame)) for r, J in recipes(other, x)]
    known = jacobian_causes.pairs(arm_of(m), q, frame)
    np.testing.assert_allclose(known.right, in_frame(m, q, right, frame), atol=1e-9)
    same(known.causes, known.made, both)


def reversals(dof):
    """The joints' signs, and the joints that are reversed."""
    for some in product((False, True), repeat=dof):
        if any(some):
            yield np.where(some, -1.0, 1.0), np.flatnonzero(some)


@pytest.mark.parametrize("frame", [0, 3])
def test_every_choice_of_joints_that_are_reversed(frame):
    q, names = Q[:3], ("q_1", "q_3", "q_4")
    known = _other_ways(arm_of(MIXED), q, frame)
    expected = [
        (f"joints reversed:{listed([names[k] for k in some])}",
         in_frame(MIXED, s * q, MIXED.jacobian(s * q) * s, frame))
        for s, some in reversals(3)
    ]  # fmt: skip
    same(known.causes, known.made, expected)
    edits = [c.name.count("q_") for c in known.causes]
    assert edits == sorted(edits), "the fewest come first"


# Torques: at two poses, each under a wrench of its own


F = np.array([[3.0, -7.0, 11.0, 0.5, -2.0, 1.5], [-4.0, 6.0, 2.0, 1.0, 0.0, -0.5]])
HEAVY = [(2.5, 0.1, -0.05, 0.08), (0.0, 0.1, 0.1, 0.1), (1.7, -0.06, 0.12, 0.03),
         (0.9, 0.04, 0.07, -0.11)]  # fmt: skip


def heavy(m, links):
    arm = arm_of(m)
    return arm if arm.bodies else arm.with_bodies([Body(mass, tuple(c)) for mass, *c in links])


def load(m, links, g):
    q = np.stack([Q[: m.dof], Q[::-1][: m.dof]])
    return torques_causes.Load(heavy(m, links), q, F, np.array([0.0, 0.0, -g])), q


def weights(m, links, q, g):
    W = weight(m, links, q, g)
    down = [0, 0, -g * sum(mass for mass, *_ in links)]
    yield "", W
    yield "tau.weight missing", 0 * W
    yield "tau.weight sign", -W
    for other in (9.8, 10, 9.80665, 1):
        if g and g != other:
            yield f"tau.gravity:{other}", weight(m, links, q, other)
    yield "tau.craig centres", weight(m, craig(m, links), q, g)
    yield "tau.centres at origins", weight(m, [(mass, 0, 0, 0) for mass, *_ in links], q, g)
    yield "tau.tip weights", -m.jacobian(q)[:3].T @ down
    for i, (mass, *_) in enumerate(links):
        if mass:
            rest = [(0 if k == i else b[0], *b[1:]) for k, b in enumerate(links)]
            yield f"tau.mass missing:{i + 1}", weight(m, rest, q, g)


def forces(m, q, F):
    P, R = force(m, F, q), m.tip(q)[:3, :3]
    yield "", P
    yield "tau.force sign", -P
    yield "tau.force missing", 0 * P
    yield "tau.force in tool", force(m, turned(R, F), q)
    yield "tau.force turned back", force(m, turned(R.T, F), q)
    yield "tau.force and moment", force(m, np.roll(F, 3), q)
    yield "J.one frame late", recipe(m, q, axis=1, origin=1).T @ F


WRITTEN = {"": (1, 1), "tau.all signs": (-1, 1), "tau.newton millimetres": (1000, 1),
           "tau.reversed order": (1, -1)}  # fmt: skip


def mistaken(m, links, q, g, F, count):
    """(name, torques) of so many mistakes."""
    wholes = [("", m, links, q), *(("tau.degrees", m, links, x) for x in degrees(m, q))]
    for name, other in lengths(m):  # centres are measured in frames before the row's a and d
        off = [(b[1] - r[1], b[3] - r[3]) for b, r in zip(other.rows, m.rows, strict=True)]
        held = [(mass, x - a, y, z - d) for (mass, x, y, z), (a, d) in zip(links, off, strict=True)]
        wholes.append((name, other, held, q))
    for whole, *at, x in wholes:
        parts = product(weights(*at, x, g), forces(at[0], x, F), WRITTEN.items())
        for (first, W), (second, P), (third, (by, step)) in parts:
            names = [name for name in (whole, first, second, third) if name]
            if len(names) == count:
                yield " + ".join(names), by * (W - P)[::step]


@pytest.mark.parametrize("count", [1, 2])
@pytest.mark.parametrize(
    ("m", "links", "g"), [(KNOWN["PANDA"], LINKS, 9.81), (MIXED, HEAVY, 9.8), (MIXED, HEAVY, 0.0)]
)
def test_every_one_and_every_two_mistakes_of_torques(m, links, g, count):
    at, q = load(m, links, g)
    one, two = (mistaken(m, links, x, g, f, count) for x, f in zip(q, F, strict=True))
    expected = [(a, np.array([s, t])) for (a, s), (_, t) in zip(one, two, strict=True)]
    same(*torques_causes.catalogue(at, count), expected)


def test_every_choice_of_joints_that_are_reversed_in_the_torques():
    at, q = load(MIXED, HEAVY, 9.81)

    def torques(signs):
        both = zip(signs * q, F, strict=True)
        return np.array([weight(MIXED, HEAVY, x) - force(MIXED, f, x) for x, f in both])

    def names(sign, some):
        return listed([f"{sign}{(1, 3, 4)[k]}" for k in some])

    right = torques(1)
    expected = [(f"tau.signs:{names('tau_', some)}", s * right) for s, some in reversals(3)]
    for s, some in reversals(3):
        expected.append((f"tau.joints reversed:{names('q_', some)}", s * torques(s)))
    causes, made = torques_causes.reversed_joints(at, right)
    same(causes, made, expected)
    edits = [c.name.count(",") + c.name.count("and") for c in causes[:7]]
    assert edits == sorted(edits), "the fewest come first"


def test_every_choice_of_a_papers_centres():
    """Those of MIXED: y and z to the other side or not, and the last as far as d before it."""
    at, q = load(MIXED, HEAVY, 9.81)
    ways = [[(b[0], b[1], s * b[2], s * b[3]) for s in (1, -1)] for b in craig(MIXED, HEAVY)]
    (mass, x, *here), (*_, y, z) = ways[-1]
    ways[-1] += [(mass, x, here[0], here[1] + 0.15), (mass, x, y, z - 0.15)]
    key, expected = "tau.craig centres", []
    for name, by in ((key, 1), (f"{key} + tau.force sign", -1), (f"{key} + tau.force missing", 0)):
        for links in product(*ways):
            both = zip(q, F, strict=True)
            tau = [weight(MIXED, links, x) - by * force(MIXED, f, x) for x, f in both]
            expected.append((name, np.array(tau)))
    same(*torques_causes.paper_centres(at), expected)
