"""An arm as JSON, symbols and all, and an arm from the words of a command line."""

import math
from collections.abc import Mapping
from dataclasses import replace
from typing import Any

from helpers.arm import Arm, Body, Joint, Row
from helpers.command_line import read_arm
from helpers.inputs import ArmError, must_be

_LIMITS = {"lower": -math.inf, "upper": math.inf, "speed": math.inf, "effort": math.inf}


def to_json(arm: Arm) -> dict[str, Any]:
    """An arm as plain data: entries as they are written, no entry for a limit that is not known."""
    must_be(arm, Arm, "arm")
    return {
        "name": arm.name,
        "rows": [_row_data(row) for row in arm.rows],
        "values": dict(arm.values),
        "bodies": [{"mass": body.mass, "com": list(body.com)} for body in arm.bodies],
        "home": list(arm.home),
        "source": arm.source,
    }


def from_json(data: Mapping[str, Any]) -> Arm:
    """The arm that `to_json` made the data of; raises ArmError where they make none."""
    try:
        rows = tuple(_row(row) for row in data["rows"])
        bodies = tuple(Body(body["mass"], tuple(body["com"])) for body in data["bodies"])
        name, values, home = data["name"], data["values"], tuple(data["home"])
        return Arm(name, rows, values, bodies=bodies, home=home, source=data["source"])
    except (KeyError, TypeError) as error:
        raise ArmError(
            f"the stored arm lacks or mistypes {error}; expected what to_json makes"
        ) from None


def _row_data(row: Row) -> dict[str, Any]:
    known = {k: getattr(row.joint, k) for k in _LIMITS if math.isfinite(getattr(row.joint, k))}
    if row.joint.at is not None:
        known["at"] = row.joint.at
    entries = {key: getattr(row, key) for key in ("a", "alpha", "d", "theta")}
    return {"kind": row.joint.kind, **entries, **known}


def _row(data: Mapping[str, Any]) -> Row:
    limits = {key: data.get(key, unknown) for key, unknown in _LIMITS.items()}
    joint = Joint(data["kind"], **limits, at=data.get("at"))
    return Row(data["a"], data["alpha"], data["d"], data["theta"], joint)


def find_arm(words: str, lock: tuple[int, ...] = ()) -> Arm:
    """An arm by what `command_line.read_arm` takes; `lock` holds joints at zero."""
    arm = read_arm(words)
    for joint in sorted(lock, reverse=True):
        arm = arm.lock(joint)
    if lock:
        held = " and ".join(map(str, lock))
        arm = replace(arm, name=f"{arm.name}, joint {held} locked")
    return arm
