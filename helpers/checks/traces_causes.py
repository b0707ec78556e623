"""Why a run misses its path: by the shape that the tip drew, by the loop that made it."""

from collections.abc import Iterator
from typing import Any

import numpy as np
from numpy.typing import NDArray

from helpers.arm import Arm
from helpers.checks.chains import Chain, chain, columns
from helpers.checks.digits import Typed
from helpers.checks.jacobian_causes import wrong_recipes, wrong_tables
from helpers.checks.ranking import Cause, cause
from helpers.motion.paths import Path
from helpers.reading.sentences import size

Array = NDArray[Any]

_SAMPLE = 100
_CLEARLY = 0.7  # of what the right loop leaves: what another must stay below to be named


def _off(path: Path, points: Array) -> Array:
    return np.linalg.norm(points - path.positions, axis=1)


# By the shape


def path_cause(path: Path, tip: Array, allowed: float) -> Cause | None:
    """What would explain every point, the likelier first."""
    return next(_shapes(path, tip, allowed), None)


def _shapes(path: Path, tip: Array, allowed: float) -> Iterator[Cause]:
    def follows(points: Array) -> bool:
        return bool(_off(path, points).max() <= allowed)

    if follows(tip[::-1]):
        yield cause("trace.backwards")
    mirrored = 2 * path.positions[0] - tip
    shift = (tip - path.positions).mean(axis=0)
    if np.linalg.norm(shift) > allowed and follows(tip - shift):
        yield cause("trace.displaced", _by=_vector(shift))
    fraction = _fraction(path, tip, allowed)
    if fraction:
        yield cause("trace.fraction", _share=size(100 * fraction), _over=size(1 / fraction))
    middle = tip.mean(axis=0)
    wanted = path.positions - path.positions.mean(axis=0)
    scale = float(np.linalg.norm(tip - middle)) / max(float(np.linalg.norm(wanted)), 1e-12)
    if abs(scale - 1) > 0.02:
        shape = scale * wanted
        off = (tip - middle - shape, tip - tip[0] - (shape - shape[0]))
        if min(np.linalg.norm(x, axis=1).max() for x in off) <= allowed * min(1.0, max(scale, 0.1)):
            yield cause("trace.scaled", _scale=size(round(scale, 6), 4))
    if follows(mirrored):
        yield cause("trace.other side")
    for i, j in ((0, 1), (0, 2), (1, 2)):
        order = [0, 1, 2]
        order[i], order[j] = j, i
        centre = path.positions.mean(axis=0)
        if follows(centre + (tip - middle)[:, order]):
            yield cause("trace.axes exchanged", first="xyz"[i], second="xyz"[j])
    if _phase(path, tip, allowed):
        yield cause("trace.phase")


def _fraction(path: Path, tip: Array, allowed: float) -> float | None:
    """The share of the path that was drawn at even pace, where that is all: half speed, a quarter,
    dt against T.
    """
    drawn = float(np.linalg.norm(np.diff(tip, axis=0), axis=1).sum())
    whole = float(np.linalg.norm(np.diff(path.positions, axis=0), axis=1).sum())
    share = drawn / whole if whole else 1.0
    if not 1e-3 < abs(share) < 50 or abs(share - 1) < 0.02:
        return None
    nice = min((1 / n for n in (2, 3, 4, 5, 8, 10, 20, 40, 50, 100)), key=lambda x: abs(x - share))
    for f in (nice, share, round(share) or share):
        start = path.times[0]
        points = path.position(start + f * (path.times - start))
        if np.linalg.norm(tip - points, axis=1).max() <= allowed * max(1.0, 2 * f):
            return f
    return None


def _phase(path: Path, tip: Array, allowed: float) -> bool:
    """Whether a closed path is drawn from another point on: its last point equals its first."""
    once = tip[:-1]
    wanted = path.positions[:-1]
    if np.linalg.norm(once[0] - wanted[0]) <= 2 * allowed:
        return False
    near = np.linalg.norm(once - wanted[0], axis=1).argmin()
    return any(
        np.linalg.norm(np.roll(once, -k, axis=0) - wanted, axis=1).max() <= allowed
        for k in range(int(near) - 2, int(near) + 3)
        if k % len(once)
    )


def _vector(metres: Array) -> str:
    return "(" + ", ".join(size(float(x) + 0.0) for x in np.round(1e3 * metres, 3)) + ")"


# By the loop


def loop_cause(typed: Typed, arm: Arm, path: Path) -> Cause | None:
    """The rule by which each step's joints follow from the one before: another Jacobian, or another
    step's velocity.

    For a step of Euler's method J(q_k) (q_{k+1} - q_k) / dt is the velocity of step k; a wrong J or
    a wrong velocity makes it so in its own way. What a rule leaves is counted in units of what the
    digits of q leave; the best one is named if the right one leaves clearly more.
    """
    q, dt = typed.values, np.diff(path.times)
    if len(q) < 4:
        return None
    pick = np.unique(np.linspace(0, len(q) - 3, _SAMPLE).astype(int))
    rate = (q[pick + 1] - q[pick]) / dt[pick, None]
    at = chain(arm, q[pick])
    J = columns(at)
    speed = float(np.abs(path.velocities).max())
    # Two roundings, each even within a unit, through each row of J.
    digits = float(typed.units.max(initial=0.0)) / float(dt.min()) / np.sqrt(6)
    noise = digits * np.sqrt((J**2).sum(axis=2).mean(axis=0)) + 1e-4 * speed
    (_, right), *rules = _rules(arm, at, J, rate, path.velocities, pick, noise)
    best, left = min(rules, key=lambda rule: rule[1])
    fits = left < 1.5 or left * float(noise.max()) < 0.02 * speed
    return best if fits and right > 1.8 and left < _CLEARLY * right else None


def _rules(
    arm: Arm, at: Chain, J: Array, rate: Array, v: Array, pick: Array, noise: Array
) -> Iterator[tuple[Cause | None, float]]:
    """Each rule with the largest of the six velocities by which it fails on the whole, in units of
    the noise.
    """

    def fails(K: Array, linear: Array) -> float:
        got = np.einsum("nij,nj->ni", K, rate)
        off = np.hstack([got[:, :3] - linear, got[:, 3:]])
        return float((np.sqrt((off**2).mean(axis=0)) / noise).max())

    def differs(wanted: Array) -> float:
        off = np.abs(np.einsum("nij,nj->ni", np.abs(J), np.abs(rate - wanted)))
        return float((np.sqrt((off**2).mean(axis=0)) / noise).max())

    yield None, fails(J, v[pick])
    if len(v) > pick.max() + 1:
        yield cause("trace.next velocity"), fails(J, v[pick + 1])
    for c, K in wrong_recipes(at):
        yield c, fails(K, v[pick])
    for c, other in wrong_tables(arm, at):
        yield c, fails(columns(other), v[pick])
    if J.shape[-1] > 3:
        free = np.einsum("nij,nj->ni", np.linalg.pinv(J[:, :3]), v[pick])
        yield cause("trace.position only"), differs(free)
        yield cause("trace.transpose"), differs(np.einsum("nji,nj->ni", J[:, :3], v[pick]))
