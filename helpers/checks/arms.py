"""Convert an arm to plain data for the judge, with the tables that usual mistakes give."""

import json
import math
from collections.abc import Iterator, Mapping, Sequence
from functools import lru_cache
from typing import Any

from helpers.arm import Arm, Body, Row
from helpers.checks.variants import LumpedModel, Namesake, find_variants
from helpers.inputs import require_type

Data = dict[str, Any]


def arm_data(arm: Arm) -> Data:
    """Return an arm as numbers in SI units, with None for an unknown limit."""
    require_type(arm, Arm, "arm")
    return {
        "name": arm.name,
        "home": list(arm.home),
        "rows": _list_rows(arm),
    }


def _format_lengths(arm: Arm) -> str:
    """Return the arm's distinct lengths in mm without the pen, to distinguish arms of one name."""
    penless = arm.with_values(l_pen=0) if "l_pen" in arm.values else arm
    lengths = (abs(1000 * penless.number(x)) for row in penless.rows for x in (row.d, row.a))
    return ", ".join(dict.fromkeys(f"{x:g}" for x in lengths if x))


def _list_rows(arm: Arm) -> list[Data]:
    bodies = arm.bodies or (None,) * len(arm.rows)
    return [_describe_row(arm, row, body) for row, body in zip(arm.rows, bodies, strict=True)]


def _describe_row(arm: Arm, row: Row, body: Body | None) -> Data:
    entries = {key: _evaluate_entry(arm, getattr(row, key)) for key in ("a", "alpha", "d", "theta")}
    joint = {
        key: _convert_limit(getattr(row.joint, key))
        for key in ("lower", "upper", "speed", "effort")
    }
    load = {"body": [_evaluate_entry(arm, e) for e in (body.mass, *body.com)]} if body else {}
    return {"kind": row.joint.kind, **entries, **joint, **load}


def _evaluate_entry(arm: Arm, entry: str | float) -> float:
    return arm.number(entry) + 0.0  # turns -0.0 into 0.0


def _convert_limit(value: float) -> float | None:
    return value if math.isfinite(value) else None


@lru_cache(maxsize=64)
def judge_data(arm: Arm) -> Data:
    """Return all data of an arm that the judge needs.

    Callers must not change the result, which is cached.

    These are `arm_data`, the values by name, and the tables of usual mistakes: the arm without its
    pen ("penless"), with similar lengths exchanged ("alike"), other arms of its name ("family"),
    and other published numbers (`find_variants`).
    """
    values = arm.values
    data = {**arm_data(arm), "lengths": _format_lengths(arm), "values": _list_values(arm)}
    if values.get("l_pen"):
        data["penless"] = arm_data(arm.with_values(l_pen=0))
    exchanged = [
        {"name": name, "other": other, "rows": _list_rows(arm.with_values(**{name: values[other]}))}
        for name, other in _find_similar_lengths(values)
    ]
    if exchanged:
        data["alike"] = exchanged
    data |= _describe_variants(arm)
    if family := list(_list_family(arm)):
        data["family"] = family
    return json.loads(json.dumps(data))


def _list_values(arm: Arm) -> list[list]:
    return [[name, float(value)] for name, value in arm.values.items()]


def _describe_variants(arm: Arm) -> Data:
    """Return further published numbers of an arm that messages may name."""
    variants = find_variants(arm)
    data: Data = {}
    if variants.maker_signs:
        data["makerSigns"] = [variants.maker_signs[i - 1] for i in arm.joints]
    if variants.namesakes:
        data["robots"] = list(_list_namesakes(arm, variants.namesakes))
    if arm.bodies and variants.published_centres:
        data["paper"] = variants.published_centres
    if arm.bodies and variants.lumped:
        data["lumped"] = _describe_lumped_model(arm, variants.lumped)
    return data


def _list_family(arm: Arm) -> Iterator[Data]:
    """Yield arms of the catalogue with the same first name, with the same joints locked."""
    from helpers.robots import ARMS

    if arm.values not in [known.values for known in ARMS if known.name == arm.name]:
        return
    for other in ARMS:
        if other.name != arm.name and other.name.split()[0] == arm.name.split()[0]:
            for joint, value in arm.locked.items():
                other = other.lock(joint, value)
            extra = {"lengths": _format_lengths(other), "values": _list_values(other)}
            yield {**arm_data(other), **extra}


def _find_similar_lengths(values: Mapping[str, float]) -> list[tuple[str, str]]:
    """Return pairs of names of lengths a_i that differ by less than 10 %."""
    lengths = [(name, x) for name, x in values.items() if name.startswith("a_")]
    return [
        (m, n)
        for m, x in lengths
        for n, y in lengths
        if m != n and x != y and abs(x - y) < 0.1 * max(abs(x), abs(y))
    ]


def _list_namesakes(arm: Arm, namesakes: Sequence[Namesake]) -> Iterator[Data]:
    """Yield the rows with the lengths of each namesake, also without the pen, and its masses."""
    for namesake in namesakes:
        other = arm.with_values(**namesake.lengths)
        data: Data = {"name": namesake.name, "rows": _list_rows(other)}
        if namesake.masses:
            data["masses"] = namesake.masses
        if arm.values.get("l_pen"):
            data["penless"] = _list_rows(other.with_values(l_pen=0))
        yield data


def _describe_lumped_model(arm: Arm, model: LumpedModel) -> Data:
    """Return a report's lumped model, with [mass, x, y, z] of each row."""
    bodies = [
        [_evaluate_entry(arm, entry) for entry in (body.mass, *body.com)] for body in model.bodies
    ]
    return {
        "report": model.report,
        "links": model.links,
        "bodies": bodies,
        "gravity": model.gravity,
    }
