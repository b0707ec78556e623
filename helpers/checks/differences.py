"""What differs between two tables in one gap, in words."""

import math
from collections.abc import Iterator
from dataclasses import dataclass
from itertools import pairwise, product

from helpers.arm import Arm
from helpers.checks.axes import NORMAL, Gap

# By position of the joint: -1 where the reference's axis is to point the other way.
Signs = dict[int, int]

WITHIN_LENGTH = 1e-6  # m
WITHIN_ANGLE = 1e-4  # rad: angles are often written with four decimals


@dataclass(frozen=True)
class Finding:
    """One thing that is wrong: the row and quantity it shows in, and what it is in both tables (m
    or rad)."""

    row: int
    quantity: str
    mine: float | str
    reference: float | str
    text: str

    def __str__(self) -> str:
        return f"Row {self.row}, {self.quantity}: {self.text}"


def by_signs(arm: Arm, mine: Gap, reference: Gap) -> dict[tuple[int, ...], tuple[Finding, ...]]:
    """What differs in a gap, for each choice of the directions that its axes have in the
    reference."""
    return {
        signs: tuple(_differences(arm, mine, reference, dict(zip(mine.joints, signs, strict=True))))
        for signs in product((1, -1), repeat=len(mine.joints))
    }


def _differences(arm: Arm, mine: Gap, reference: Gap, signs: Signs) -> Iterator[Finding]:
    yield from _distance(arm, mine, reference)
    yield from list(_twists(arm, mine, reference, signs)) or _slide(arm, mine, reference, signs)
    yield from _offset(arm, mine, reference, signs)


def _distance(arm: Arm, mine: Gap, reference: Gap) -> Iterator[Finding]:
    if abs(mine.length - reference.length) > WITHIN_LENGTH:
        start = arm.joints[mine.joints[0]]
        end = "the tip" if mine.to_tip else f"axis {arm.joints[mine.joints[-1]]}"
        what = f"the distance from axis {start} to {end}"
        yield _length(start, "a", what, mine.length, reference.length)


def _twists(arm: Arm, mine: Gap, reference: Gap, signs: Signs) -> Iterator[Finding]:
    for pair in pairwise(mine.joints):
        sided = len(mine.joints) == 2 and (*pair, NORMAL) in mine.shape.keys() & reference.shape
        m, r = _twist(mine, pair, sided, {}), _twist(reference, pair, sided, signs)
        if angle_between(m, r) > WITHIN_ANGLE:
            i, j = (arm.joints[k] for k in pair)
            yield _angle(i, "alpha", f"the twist from axis {i} to axis {j}", m, r)


def _twist(gap: Gap, pair: tuple[int, ...], sided: bool, signs: Signs) -> float:
    """The angle between two axes: about their common normal if `sided`, else between 0 and pi."""
    cosine = _product(gap, pair, signs)
    if sided:
        return math.atan2(_product(gap, (*pair, NORMAL), signs), cosine)
    return arc(cosine)


def _product(gap: Gap, which: tuple[int, ...], signs: Signs) -> float:
    """One of the gap's products, each joint's direction turned by its sign."""
    return gap.shape[which] * math.prod(signs.get(k, 1) for k in which)


def arc(cosine: float) -> float:
    """The angle (rad) with this cosine, rounding past 1 forgiven."""
    return math.acos(max(-1.0, min(1.0, cosine)))


def angle_between(left: float, right: float) -> float:
    """How far two angles (rad) are apart, whole turns aside."""
    return abs((left - right + math.pi) % (2 * math.pi) - math.pi)


def _slide(arm: Arm, mine: Gap, reference: Gap, signs: Signs) -> Iterator[Finding]:
    """A slide does not turn: what lies before and after it is held at an angle about it."""
    rows = [arm.joints[k] for k in mine.joints]
    slides = [i for i in rows if arm.rows[i - 1].joint.kind == "prismatic"]
    both = sorted(mine.shape.keys() & reference.shape.keys()) if slides else []
    products = [(mine.shape[which], _product(reference, which, signs)) for which in both]
    m, r = max(products, key=lambda pair: abs(pair[0] - pair[1]), default=(0.0, 0.0))
    if abs(m - r) > WITHIN_ANGLE:
        what = "the angle at which the slide holds the axes before and after it"
        yield _angle(slides[0], "theta", what, arc(m), arc(r))


def _offset(arm: Arm, mine: Gap, reference: Gap, signs: Signs) -> Iterator[Finding]:
    if mine.from_base or None in (mine.offset, reference.offset) or mine.bunch != reference.bunch:
        return
    m, r = mine.offset, signs[mine.joints[0]] * reference.offset
    if abs(m - r) > WITHIN_LENGTH:
        first, last = arm.joints[mine.bunch[0]], arm.joints[mine.bunch[-1]]
        along = (
            f"axis {last}" if first == last else f"the parallel axes {first} to {last}, added up,"
        )
        yield _length(last, "d", f"the offset along {along}", m, r)


def _length(row: int, quantity: str, what: str, mine: float, reference: float) -> Finding:
    if mine * reference < 0:
        error = "it goes the other way, so a sign is wrong here or in a row beside it"
    else:
        size = 1000 * abs(mine - reference)
        error = f"{size:.4g} mm too {'long' if abs(mine) > abs(reference) else 'short'}"
        mine, reference = abs(mine), abs(reference)
    text = f"{what} is {mine:.6g} m in yours and {reference:.6g} m in the reference: {error}."
    return Finding(row, quantity, mine, reference, text)


def _angle(row: int, quantity: str, what: str, mine: float, reference: float) -> Finding:
    if mine < 0:
        mine, reference = -mine, -reference
    mine_in, reference_in, off = (
        f"{math.degrees(x) + 0.0:.6g}°" for x in (mine, reference, angle_between(mine, reference))
    )
    text = f"{what} is {mine_in} in yours and {reference_in} in the reference: {off} off."
    return Finding(row, quantity, mine, reference, text)
