"""Which joint or length a student's symbol means: q_1, q1, theta_1, th1, d3 for a slide, c1, s_23,
c_{2-3}, a3, l_pen.
"""

import math
import re
from collections.abc import Iterable, Mapping

import numpy as np

from helpers.arm import Arm
from helpers.inputs import ArmError
from helpers.reading import formula
from helpers.reading.sentences import say

_JOINT = re.compile(r"(q|th|theta|tht|thetha|t|phi|joint|j|x|d|u)(\d{1,2})")
_SHORT = re.compile(r"([cs])((?:[+-]?\d)+)", re.I)


def simple(name: str) -> str:
    """A name in lower case, without underscores, braces, primes and ``(t)``: ``theta_{1}(t)`` and
    ``θ₁`` are ``theta1``.
    """
    return re.sub(r"\(t\)|[_{}'*^\\\s]", "", formula.plain(name)).lower()


def meanings(
    names: Iterable[str], arm: Arm, q: np.ndarray, values: Mapping[str, float] | None = None
) -> tuple[dict[str, float], tuple[str, ...]]:
    """The number that each name stands for at q, and a word on how the joints were numbered.

    Raises ArmError for a name that means nothing, with the names that do.
    """
    names = sorted(set(names))
    known = {simple(k): v for k, v in {**arm.values, **(values or {})}.items()}
    found = {name: known[simple(name)] for name in names if simple(name) in known}
    joints = {name: _indices(name) for name in names if name not in found}
    order, said = _order(sorted({i for used in joints.values() for i in used or ()}), arm)
    for name, used in joints.items():
        at = [order.get(i) for i in used or ()]
        if not at or None in at:
            raise ArmError(say("unknown symbol", arm=arm.name, name=name, known=_known(arm)))
        found[name] = _angle_or_short(simple(name), [float(q[k]) for k in at])
    return found, said


def _indices(name: str) -> list[int] | None:
    bare = simple(name)
    if match := _JOINT.fullmatch(bare):
        return [int(match[2])]
    if match := _SHORT.fullmatch(bare):
        return [int(i) for i in re.findall(r"\d", match[2])]
    return None


def _order(used: list[int], arm: Arm) -> tuple[dict[int, int], tuple[str, ...]]:
    """The position of each joint number: by row, or counted on past what does not move."""
    by_row = {i: k for k, i in enumerate(arm.joints)}
    if set(used) <= set(by_row):
        return by_row, ()
    if set(used) <= set(range(1, arm.dof + 1)):
        return {k + 1: k for k in range(arm.dof)}, (say("taken: counted on", joints=_list(arm)),)
    if set(used) <= set(range(arm.dof)):
        return {k: k for k in range(arm.dof)}, (say("taken: from zero", joints=_list(arm)),)
    return by_row, ()


def _list(arm: Arm) -> str:
    return ", ".join(map(str, arm.joints))


def _angle_or_short(name: str, q: list[float]) -> float:
    match = _SHORT.fullmatch(name)
    if not match:
        return q[0]
    signs = [-1 if s == "-" else 1 for s in re.findall(r"([+-]?)\d", match[2])]
    total = sum(s * x for s, x in zip(signs, q, strict=True))
    return math.cos(total) if name[0] == "c" else math.sin(total)


def _known(arm: Arm) -> str:
    return ", ".join([*arm.variables, *arm.values])
