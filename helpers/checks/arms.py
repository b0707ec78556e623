"""Describe an arm to the judge as plain data, with the tables that usual mistakes give."""

import json
import math
from collections.abc import Iterator, Mapping
from functools import lru_cache
from typing import Any

from helpers.arm import Arm, Body, Row
from helpers.inputs import must_be

Data = dict[str, Any]


def arm_data(arm: Arm) -> Data:
    """Return an arm as numbers in SI units; an unknown limit is None."""
    must_be(arm, Arm, "arm")
    return {
        "name": arm.name,
        "home": list(arm.home),
        "rows": _rows_data(arm),
    }


def _lengths(arm: Arm) -> str:
    """An arm's lengths (mm) but the pen's, each once and as its rows have them, to tell it from
    others of its name.
    """
    bare = arm.with_values(l_pen=0) if "l_pen" in arm.values else arm
    each = (abs(1000 * bare.number(x)) for row in bare.rows for x in (row.d, row.a))
    return ", ".join(dict.fromkeys(f"{x:g}" for x in each if x))


def _rows_data(arm: Arm) -> list[Data]:
    bodies = arm.bodies or (None,) * len(arm.rows)
    return [_row_data(arm, row, body) for row, body in zip(arm.rows, bodies, strict=True)]


def _row_data(arm: Arm, row: Row, body: Body | None) -> Data:
    entries = {key: _number(arm, getattr(row, key)) for key in ("a", "alpha", "d", "theta")}
    joint = {key: _finite(getattr(row.joint, key)) for key in ("lower", "upper", "speed", "effort")}
    load = {"body": [_number(arm, e) for e in (body.mass, *body.com)]} if body else {}
    return {"kind": row.joint.kind, **entries, **joint, **load}


def _number(arm: Arm, entry: str | float) -> float:
    return arm.number(entry) + 0.0  # no minus before a zero


def _finite(value: float) -> float | None:
    return value if math.isfinite(value) else None


@lru_cache(maxsize=64)
def judge_data(arm: Arm) -> Data:
    """`arm_data`, the arm's values by name, the arm without its pen, for lengths that are near each
    other the arm with one taken for the other, the arm with the lengths of robots of nearly its
    name, and the centres of mass as a paper has them. Not to be changed.
    """
    values = arm.values
    named = {"lengths": _lengths(arm)}
    found = {**arm_data(arm), **named, "values": [[name, float(x)] for name, x in values.items()]}
    if values.get("l_pen"):
        found["penless"] = arm_data(arm.with_values(l_pen=0))
    others = [
        {"name": m, "other": n, "rows": _rows_data(arm.with_values(**{m: values[n]}))}
        for m, n in _alike(values)
    ]
    if others:
        found["alike"] = others
    if robots := list(_robots(arm)):
        found["robots"] = robots
    if tuple(body.mass for body in arm.bodies or ()) == _GAZ_MASSES:
        found["paper"] = _GAZ_CENTRES
    if family := list(_family(arm)):
        found["family"] = family
    return json.loads(json.dumps(found))


def _family(arm: Arm) -> Iterator[Data]:
    """The catalogue's other arms of the name, with the joints locked that `arm` has locked."""
    from helpers.robots import ARMS

    if arm.values not in [one.values for one in ARMS if one.name == arm.name]:
        return
    for other in ARMS:
        if other.name != arm.name and other.name.split()[0] == arm.name.split()[0]:
            for joint, at in arm.locked.items():
                other = other.lock(joint, at)
            values = [[name, float(x)] for name, x in other.values.items()]
            yield {**arm_data(other), "lengths": _lengths(other), "values": values}


def _alike(values: Mapping[str, float]) -> list[tuple[str, str]]:
    """Names of lengths a_i that may be taken for one another: near, and not the same."""
    a = [(name, x) for name, x in values.items() if name.startswith("a_")]
    return [
        (m, n)
        for m, x in a
        for n, y in a
        if m != n and x != y and abs(x - y) < 0.1 * max(abs(x), abs(y))
    ]


# The Panda's links as Gaz et al. (2019) give them, in the Craig frames of its maker.
_GAZ_MASSES = (4.970684, 0.646926, 3.228604, 3.587895, 1.225946, 1.666555, 0.735522)
_GAZ_CENTRES = (
    (0.003875, 0.002081, -0.04762),
    (-0.003141, -0.02872, 0.003495),
    (0.027518, 0.039252, -0.066502),
    (-0.05317, 0.104419, 0.027454),
    (-0.011953, 0.041065, -0.038437),
    (0.060149, -0.014117, -0.010517),
    (0.010517, -0.004252, 0.061597),
)


# The UR10 as its maker's table of Denavit-Hartenberg parameters has it: lengths (m), masses (kg).
_UR10 = dict(d_1=0.1273, a_2=0.612, a_3=0.5723, d_4=0.163941, d_5=0.1157, d_6=0.0922)
_UR10_MASSES = (7.1, 12.7, 4.27, 2.0, 2.0, 0.365)


def _namesakes() -> tuple[tuple[str, dict[str, float]], ...]:
    """Robots of nearly one name: the UR10 as its manual's drawing has it and by its maker's table,
    and the UR10e.
    """
    from helpers.robots import UR10E, UR10E_HOMEWORK  # the checkers themselves need no catalogue

    drawn, new = ({n: arm.values[n] for n in _UR10} for arm in (UR10E_HOMEWORK, UR10E))
    return ("UR10", drawn), ("UR10", _UR10), ("UR10e", new)


def _robots(arm: Arm) -> Iterator[Data]:
    """The rows with the lengths of robots of nearly the arm's name, and without the pen; beside the
    UR10e the masses of the UR10 as well.
    """
    own = next(
        (name for name, lengths in _namesakes() if lengths.items() <= arm.values.items()), None
    )
    for name, lengths in _namesakes():
        if own and name != own:
            other = arm.with_values(**lengths)
            masses = {"masses": _UR10_MASSES} if name == "UR10" else {}
            found = {"name": name, "rows": _rows_data(other), **masses}
            if arm.values.get("l_pen"):
                found["penless"] = _rows_data(other.with_values(l_pen=0))
            yield found
