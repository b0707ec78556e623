"""Why a run misses its path: by the shape that the tip drew, by the loop that made it."""

from collections.abc import Iterator
from dataclasses import dataclass
from functools import cached_property
from typing import Any

import numpy as np
from numpy.typing import NDArray

from helpers.arm import Arm
from helpers.checks.chains import Chain, chain, columns
from helpers.checks.digits import Typed
from helpers.checks.jacobian_causes import wrong_recipes, wrong_tables
from helpers.checks.ranking import Cause, cause
from helpers.motion.paths import Path
from helpers.reading.sentences import listed, size

Array = NDArray[Any]

_ALIKE = 1e-9  # m: misses nearer to each other than this are the same
_SAMPLE = 100
_ALONG = 40  # windows in a run: few enough for many steps each, enough to see a circle's turns
_PLAIN = 0.1  # of the miss: what another path without a free number may leave
_PLAIN_PATHS = ("trace.backwards", "trace.other side")
_HOLDS = 1.5  # times the noise: what a rule that holds may leave
_LOOSE = 4.0  # times the noise: what one may leave that is ten times better than the right one
_NICE = tuple(1 / n for n in (2, 3, 4, 5, 8, 10, 20, 40, 50, 100))
_FINE = 3e-4  # of the speed: below, the digits show a thousandth of it
_CLEARLY = 0.7  # of what the right loop leaves: what another must stay below to be named


def offs(path: Path, points: Array) -> Array:
    """How far each point is from where the path has it."""
    return np.linalg.norm(points - path.positions, axis=1)


# By the shape


def path_cause(path: Path, tip: Array, allowed: float, blur: float) -> Cause | None:
    """What would explain every point; of those that leave as little, the likelier.

    A run by Euler's method is off its own path by a step or two, so as much may be left, but no
    more than a quarter of the miss; of a path drawn smaller, less in proportion. `blur` is what the
    digits of the joints leave of each point (m).
    """
    miss = float(offs(path, tip).max())
    usual = near(path, miss, allowed)
    found = [
        (c, left)
        for c, left in _shapes(path, tip, blur)
        if left <= (max(usual, _PLAIN * miss) if c.keys[0] in _PLAIN_PATHS else usual)
    ]
    if not found:
        return None
    least = min(left for _, left in found)
    return next(c for c, left in found if left <= 1.5 * least + 0.1 * allowed)


def near(path: Path, miss: float, allowed: float) -> float:
    """How much a cause may leave of a miss (m): two of the path's steps, a quarter of the miss."""
    step = float(np.linalg.norm(np.diff(path.positions, axis=0), axis=1).max())
    return min(max(allowed, 2 * step), miss / 4)


def _shapes(path: Path, tip: Array, blur: float) -> Iterator[tuple[Cause, float]]:
    """Other paths than the one asked for, the likelier first, each with what it leaves (m)."""

    def left(points: Array) -> float:
        return float(offs(path, points).max())

    yield cause("trace.backwards"), left(tip[::-1])
    shift = (tip - path.positions).mean(axis=0)
    missing = _left_out(path, shift, near(path, left(tip), blur))
    if missing:
        yield cause("trace.centre", axes=missing), left(tip - shift)
    yield cause("trace.displaced", _by=_vector(shift)), left(tip - shift)
    share, rest = _fraction(path, tip, blur)
    if share:
        yield cause("trace.fraction", _share=size(100 * share), _over=size(1 / share)), rest
    middle, centre = tip.mean(axis=0), path.positions.mean(axis=0)
    wanted = path.positions - centre
    scale = float(np.linalg.norm(tip - middle)) / max(float(np.linalg.norm(wanted)), 1e-12)
    if abs(scale - 1) > 0.02 and scale > 1e-3:
        rest = float(np.linalg.norm(tip - middle - scale * wanted, axis=1).max())
        yield cause("trace.scaled", _scale=size(round(scale, 6), 4)), _share(rest, scale, blur)
    yield cause("trace.other side"), left(2 * path.positions[0] - tip)
    for i, j in ((0, 1), (0, 2), (1, 2)):
        order = [0, 1, 2]
        order[i], order[j] = j, i
        points = centre + (tip - middle)[:, order]
        yield cause("trace.axes exchanged", first="xyz"[i], second="xyz"[j]), left(points)
    yield cause("trace.phase"), _phase(path, tip)


def _left_out(path: Path, shift: Array, much: float) -> str:
    """The coordinates of the path's centre that are left out, where a path's displacement is just
    theirs; none where it is another.
    """
    centre = path.positions.mean(axis=0)
    kept, gone = (np.abs(x) <= much for x in (shift, shift + centre))
    out = ["xyz"[k] for k in np.flatnonzero(~kept)]
    return listed(out) if out and (kept | gone).all() else ""


def _share(rest: float, scale: float, blur: float) -> float:
    """What a path drawn smaller leaves, as if it had its size."""
    return max(0.0, rest - blur) / min(1.0, scale)


def _fraction(path: Path, tip: Array, blur: float) -> tuple[float | None, float]:
    """The share of the path that was drawn at even pace, and what it leaves: half speed, a quarter,
    dt against T.
    """
    drawn = float(np.linalg.norm(np.diff(tip, axis=0), axis=1).sum())
    whole = float(np.linalg.norm(np.diff(path.positions, axis=0), axis=1).sum())
    share = drawn / max(whole, 1e-12)
    shares = [f for f in (*_NICE, share, float(round(share))) if f and abs(f - 1) > 0.02]
    if not 1e-3 < share < 50 or abs(share - 1) < 0.02:
        return None, np.inf
    found = []
    start = path.times[0]
    most = float(offs(path, tip).max()) / 2  # a run astray is as long as many a share
    for f in shares:
        points = path.position(start + f * (path.times - start))
        left = float(np.linalg.norm(tip - points, axis=1).max())
        if left <= most:
            found.append((_share(left / max(1.0, 2 * f), f, blur), f))
    left, best = min(found, default=(np.inf, None))
    return best, left


def _phase(path: Path, tip: Array) -> float:
    """What is left where a closed path is drawn from another point on: its last point equals its
    first.
    """
    once = tip[:-1]
    wanted = path.positions[:-1]
    nearest = int(np.linalg.norm(once - wanted[0], axis=1).argmin())
    turns = [k for k in range(nearest - 2, nearest + 3) if k % len(once)]
    return min(
        (float(np.linalg.norm(np.roll(once, -k, axis=0) - wanted, axis=1).max()) for k in turns),
        default=np.inf,
    )


def _vector(metres: Array) -> str:
    """A vector in mm, to three digits of its largest coordinate at most."""
    far = 1e3 * float(np.abs(metres).max())
    places = sum(far < least for least in (100, 10, 1))
    return "(" + ", ".join(size(float(x) + 0.0) for x in np.round(1e3 * metres, places)) + ")"


# By the table


def table_cause(q: Array, arm: Arm, path: Path, allowed: float) -> Cause | None:
    """The wrong table by which these joints do follow the path, as joints from inverse kinematics
    do; none where it leaves more than a quarter of the miss.
    """
    right = chain(arm, q)
    most = min(allowed, float(offs(path, right.frames[:, -1, :3, 3]).max()) / 4)
    found = [
        (c, float(offs(path, other.frames[:, -1, :3, 3]).max()))
        for c, other in wrong_tables(arm, right)
    ]
    least = min((left for _, left in found), default=np.inf)
    return next(c for c, left in found if left <= least + _ALIKE) if least <= most else None


# By the loop


def loop_cause(typed: Typed, arm: Arm, path: Path, wrong: bool) -> Cause | None:
    """The rule by which each step's joints follow from the one before: another Jacobian, or another
    step's velocity.

    For a step of Euler's method J(q_k) (q_{k+1} - q_k) / dt is the velocity of step k, for Runge's
    and Kutta's the one in the middle of the step; a wrong J or a wrong velocity makes it so in its
    own way. What a rule leaves is counted in units of what the digits of q leave; the best one is
    named if the right one leaves clearly more. Where the right one holds in a run that is `wrong`,
    its steps are too long.
    """
    if len(typed.values) < 4:
        return None
    euler, middle = (_Steps.of(typed, arm, path, share) for share in (0.0, 0.5))
    right = min(euler.right, middle.right)
    if right < _HOLDS:
        coarse = wrong and euler.right < _HOLDS and euler.clear
        return cause("trace.coarse", _steps=len(path.times) - 1) if coarse else None
    rules = [rule for steps in (euler, middle) for rule in steps.rules()]
    least = min(left for _, left, _ in rules)
    best, left, fits = next(rule for rule in rules if rule[1] <= 1.05 * least)
    fits = fits or left < min(_LOOSE, 0.1 * right)
    return best if fits and right > 1.8 and left < _CLEARLY * right else None


def holds(typed: Typed, arm: Arm, path: Path) -> bool:
    """Whether each step is clearly right by Euler's method."""
    steps = _Steps.of(typed, arm, path, 0.0)
    return steps.clear and steps.right < _HOLDS


@dataclass(frozen=True)
class _Steps:
    """A sample of a run's steps, in windows of neighbours over which what a rule leaves is
    averaged, for there the roundings cancel.

    Each is looked at from a share of the way on: the arm and J there, the joints' rates, the
    velocities asked for, and what the digits leave of the tip's six velocities and of the joints'
    own.
    """

    arm: Arm
    at: Chain
    J: Array
    rate: Array
    velocity: Array
    later: Array
    noise: Array
    own: Array
    speed: float
    window: int

    @classmethod
    def of(cls, typed: Typed, arm: Arm, path: Path, share: float) -> "_Steps":
        q, dt = typed.values, np.diff(path.times)
        window = max(1, (len(q) - 2) // _ALONG)
        last = max(0, len(q) - 2 - window)
        first = np.unique(np.linspace(0, last, max(12, _SAMPLE // window)).astype(int))
        pick = (first[:, None] + np.arange(window)).ravel()
        step = q[pick + 1] - q[pick]
        at = chain(arm, q[pick] + share * step)
        J = columns(at)
        times = path.times[pick] + share * dt[pick]
        velocity, later = (path.velocity(t) for t in (times, times + dt[pick]))
        speed = float(np.abs(path.velocities).max())
        # Two roundings, each even within a unit, through each row of J; and what a step's own
        # curvature leaves of its middle.
        digits = typed.units.max(axis=0) / float(dt.min()) / np.sqrt(6) / window
        bend = float(np.abs(later - velocity).max()) / max(speed, 1e-12)
        rest = 1e-4 + (0.5 * bend**2 if share else 0.0)
        noise = np.sqrt(((J * digits) ** 2).sum(axis=2).mean(axis=0)) + rest * speed
        rate = step / dt[pick, None]
        own = digits + rest * np.sqrt((rate**2).mean()) + 1e-12
        return cls(arm, at, J, rate, velocity, later, noise, own, speed, window)

    @cached_property
    def right(self) -> float:
        return self._fails(self.J, self.velocity)

    @property
    def clear(self) -> bool:
        """Whether the digits show the velocities at all."""
        return float(self.noise.max()) < 0.1 * self.speed

    def rules(self) -> Iterator[tuple[Cause, float, bool]]:
        """Each wrong rule, by how much it fails on the whole in units of the noise, and whether
        that is little.
        """
        v = self.velocity
        yield cause("trace.other side"), *self._held(self.J, -v)
        yield cause("trace.millimetres"), *self._held(self.J, 1e3 * v)
        if float(self.noise.max()) < _FINE * self.speed:
            left = self._fails(self.J, 1e-3 * v)
            yield cause("J.millimetres"), left, left < _HOLDS
        yield cause("trace.next velocity"), *self._held(self.J, self.later)
        for c, K in wrong_recipes(self.at):
            yield c, *self._held(K, v)
        for c, other in wrong_tables(self.arm, self.at):
            yield c, *self._held(columns(other), v)
        if self._rows == 6:
            linear = self.J[:, :3]
            free = np.einsum("nij,nj->ni", np.linalg.pinv(linear), v)
            yield cause("trace.position only"), *self._moves(free)
            yield cause("trace.transpose"), *self._moves(np.einsum("nji,nj->ni", linear, v))

    def _fails(self, K: Array, linear: Array) -> float:
        got = np.einsum("nij,nj->ni", K, self.rate)
        off = np.hstack([got[:, :3] - linear, got[:, 3:]])[:, : self._rows]
        return float((self._size(off) / self.noise[: self._rows]).max())

    def _size(self, off: Array) -> Array:
        """The root mean square of each column over the windows' averages."""
        mean = off.reshape(-1, self.window, off.shape[1]).mean(axis=1)
        return np.sqrt((mean**2).mean(axis=0))

    def _held(self, K: Array, linear: Array) -> tuple[float, bool]:
        left = self._fails(K, linear)
        return left, left < _HOLDS or left * float(self.noise.max()) < 0.02 * self.speed

    def _moves(self, wanted: Array) -> tuple[float, bool]:
        """How far the joints' rates are from those of another rule."""
        off = self._size(self.rate - wanted)
        left = float((off / self.own).max())
        return left, left < _HOLDS or bool(off.max() < 0.02 * self._size(wanted).max())

    @property
    def _rows(self) -> int:
        return 6 if self.arm.dof >= 6 else 3
