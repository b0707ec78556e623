"""What mistakes make of right torques tau = g(q) - J^T F: in the weight, in the force, in both, and
in how they are written.
"""

from collections.abc import Iterator
from functools import cached_property
from itertools import product
from typing import Any

import numpy as np
from numpy.typing import NDArray

from helpers.arm import Arm
from helpers.checks.chains import chain, columns, weights
from helpers.checks.lengths import wrong_lengths
from helpers.checks.ranking import Cause, cause
from helpers.reading.sentences import listed

Array = NDArray[Any]
Part = tuple[Cause | None, Array]


class Load:
    """An arm with masses at some poses, under a wrench: g(q) and J^T F from one set of frames."""

    def __init__(self, arm: Arm, q: Array, wrench: Array, gravity: Array) -> None:
        self.arm, self.wrench, self.gravity = arm, wrench, gravity
        self.chain = chain(arm, q)
        self.T = self.chain.frames
        self.J = columns(self.chain)
        self.masses = np.array([arm.number(b.mass) for b in arm.bodies])
        self.centres = np.array([[arm.number(c) for c in b.com] for b in arm.bodies])

    def weight(self, masses: Array | None = None, centres: Array | None = None) -> Array:
        """g(q), with other masses or centres where given."""
        m = self.masses if masses is None else masses
        c = self.centres if centres is None else centres
        return weights(self.chain, m, c, self.gravity)

    def force(self, wrench: Array | None = None) -> Array:
        """J^T F."""
        return _through(self.J, self.wrench if wrench is None else wrench)

    @cached_property
    def others(self) -> list[tuple[Cause | None, "Load"]]:
        """The load itself, and what a wrong arm or q makes of it."""
        return list(_loads(self))

    def torques(self) -> Array:
        """g(q) - J^T F."""
        return self.weight() - self.force()


def catalogue(load: Load, count: int) -> tuple[list[Cause], Array]:
    """Every single cause, or every pair of them, and the torques (causes, poses, dof) that they
    give.
    """
    causes, torques = [], []
    for whole, other in load.others:
        for (first, weight), (second, force) in product(_weights(other), _forces(other)):
            named = [c for c in (whole, first, second) if c is not None]
            for third, write in _WRITINGS:
                made = [*named, third] if third else named
                if len(made) == count:
                    causes.append(sum(made[1:], made[0]))
                    torques.append(write(weight - force))
    return causes, np.stack(torques)


def reversed_joints(load: Load, right: Array) -> tuple[list[Cause], Array]:
    """Joints that count the other way in the torques, and in q as well, fewest first."""
    dof = load.arm.dof
    chosen = sorted(
        (s for s in product((1.0, -1.0), repeat=dof) if min(s) < 0), key=lambda s: -sum(s)
    )
    signs = np.array(chosen)
    here = right * signs[:, None, :]
    turned = Load(load.arm, signs[:, None, :] * load.chain.q, load.wrench, load.gravity)
    there = turned.torques() * signs[:, None, :]
    causes = [
        cause(key, joints=listed([f"{name}{load.arm.joints[k]}" for k in np.flatnonzero(row < 0)]))
        for key, name in (("tau.signs", "tau_"), ("tau.joints reversed", "q_"))
        for row in signs
    ]
    return causes, np.concatenate([here, there])


def paper_centres(load: Load) -> tuple[list[Cause], Array]:
    """Centres of mass as a paper gives them, unconverted: in the maker's Craig frames, whose axes x
    are the table's.

    Where the maker's joint counts the other way, y and z point the other way; the last frame may
    stand before its offset d. All choices are tried, with the force as it is, reversed and missing.
    """
    craig = _craig_centres(load.arm, load.centres)
    count, last = len(craig), load.arm.numeric[-1].d
    parts = []
    for i, (mass, (x, y, z)) in enumerate(zip(load.masses, craig, strict=True)):
        ways = [(x, y, z), (x, -y, -z)]
        if i == count - 1 and last:
            ways += [(x, y, z + last), (x, -y, -z - last)]
        alone = np.where(np.arange(count) == i, mass, 0.0)
        spread = [
            load.weight(alone, np.where(np.arange(count)[:, None] == i, way, 0.0)) for way in ways
        ]
        parts.append(spread)
    weight = np.stack([sum(chosen) for chosen in product(*parts)])
    key, force = cause("tau.craig centres"), load.force()
    scaled = ((key, 1), (key + cause("tau.force sign"), -1), (key + cause("tau.force missing"), 0))
    causes = [c for c, _ in scaled for _ in weight]
    return causes, np.concatenate([weight - sign * force for _, sign in scaled])


def _loads(load: Load) -> Iterator[tuple[Cause | None, Load]]:
    yield None, load
    arm, q = load.arm, load.chain.q

    def other(arm: Arm, q: Array) -> Load:
        return Load(arm, q, load.wrench, load.gravity)

    for change in (np.radians, np.degrees):
        yield cause("tau.degrees"), other(arm, np.where(arm.turning, change(q), q))
    for found, wrong in wrong_lengths(arm):
        yield found, other(wrong, q)


def _weights(load: Load) -> Iterator[Part]:
    right = load.weight()
    yield None, right
    yield cause("tau.weight missing"), 0 * right
    yield cause("tau.weight sign"), -right
    much = float(np.linalg.norm(load.gravity))
    if much:
        for g in (9.8, 10.0, 9.80665, 1.0):
            if abs(g - much) > 1e-9:
                yield cause("tau.gravity", g=f"{g:g}"), right * g / much
    yield cause("tau.craig centres"), load.weight(centres=_craig_centres(load.arm, load.centres))
    yield cause("tau.centres at origins"), load.weight(centres=0 * load.centres)
    tip = np.einsum("...ij,i->...j", load.J[..., :3, :], load.masses.sum() * load.gravity)
    yield cause("tau.tip weights"), -tip
    for i, mass in enumerate(load.masses):
        if mass:
            without = np.where(np.arange(len(load.masses)) == i, 0.0, load.masses)
            yield cause("tau.mass missing", link=i + 1), load.weight(without)


def _craig_centres(arm: Arm, centres: Array) -> Array:
    """Centres of mass given in Craig's frames, used as if they were in the table's: a turn by alpha
    and a step of a apart.
    """
    found = []
    for row, (x, y, z) in zip(arm.numeric, centres, strict=True):
        c, s = row.cos_alpha, row.sin_alpha
        found.append((x + row.a, c * y - s * z, s * y + c * z))
    return np.array(found)


def _forces(load: Load) -> Iterator[Part]:
    right = load.force()
    yield None, right
    if not np.any(load.wrench):
        return
    R = load.T[..., -1, :3, :3]
    yield cause("tau.force sign"), -right
    yield cause("tau.force missing"), 0 * right
    yield cause("tau.force in tool"), load.force(_turned(R, load.wrench))
    yield cause("tau.force turned back"), load.force(_turned(np.swapaxes(R, -1, -2), load.wrench))
    yield cause("tau.force and moment"), load.force(np.roll(load.wrench, 3, -1))
    late = np.array(load.chain.joints)
    yield (
        cause("J.one frame late"),
        _through(columns(load.chain, axis=late, origin=late), load.wrench),
    )


def _through(J: Array, wrench: Array) -> Array:
    return np.einsum("...ij,...i->...j", J, wrench)


def _turned(R: Array, wrench: Array) -> Array:
    """What a wrench becomes if its numbers are meant in the axes R."""
    halves = [np.einsum("...ij,...j->...i", R, half) for half in (wrench[..., :3], wrench[..., 3:])]
    return np.concatenate(halves, axis=-1)


_WRITINGS = (
    (None, lambda tau: tau),
    (cause("tau.all signs"), lambda tau: -tau),
    (cause("tau.newton millimetres"), lambda tau: 1000 * tau),
    (cause("tau.reversed order"), lambda tau: tau[..., ::-1]),
)


def mended(c: Cause, off: Array) -> Array:
    """What torques (poses, dof) are off by, in N m and by joint, however a mistake in how they are
    written has scaled and ordered them.
    """
    scaled = off / 1000 if "tau.newton millimetres" in c.keys else off
    return scaled[:, ::-1] if "tau.reversed order" in c.keys else scaled
