"""Describe an arm to the judge as plain data, with the tables that usual mistakes give."""

import json
import math
from collections.abc import Iterator, Mapping, Sequence
from functools import lru_cache
from typing import Any

from helpers.arm import Arm, Body, Row
from helpers.inputs import require_type
from helpers.variants import LumpedModel, Namesake, find_variants

Data = dict[str, Any]


def arm_data(arm: Arm) -> Data:
    """Return an arm as numbers in SI units; an unknown limit is None."""
    require_type(arm, Arm, "arm")
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
    found |= _variant_data(arm)
    if family := list(_family(arm)):
        found["family"] = family
    return json.loads(json.dumps(found))


def _variant_data(arm: Arm) -> Data:
    """Return the other published numbers of an arm that its messages may name."""
    variants = find_variants(arm)
    data: Data = {}
    if variants.maker_signs:
        data["makerSigns"] = [variants.maker_signs[i - 1] for i in arm.joints]
    if variants.namesakes:
        data["robots"] = list(_namesake_data(arm, variants.namesakes))
    if arm.bodies and variants.published_centres:
        data["paper"] = variants.published_centres
    if arm.bodies and variants.lumped:
        data["lumped"] = _lumped_data(arm, variants.lumped)
    return data


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


def _namesake_data(arm: Arm, namesakes: Sequence[Namesake]) -> Iterator[Data]:
    """Yield the rows with the lengths of each namesake, also without the pen, and its masses."""
    for namesake in namesakes:
        other = arm.with_values(**namesake.lengths)
        data: Data = {"name": namesake.name, "rows": _rows_data(other)}
        if namesake.masses:
            data["masses"] = namesake.masses
        if arm.values.get("l_pen"):
            data["penless"] = _rows_data(other.with_values(l_pen=0))
        yield data


def _lumped_data(arm: Arm, model: LumpedModel) -> Data:
    """Return a report's lumped model: [mass, x, y, z] of each row, and what its message names."""
    bodies = [[_number(arm, entry) for entry in (body.mass, *body.com)] for body in model.bodies]
    return {
        "report": model.report,
        "links": model.links,
        "bodies": bodies,
        "gravity": model.gravity,
    }
