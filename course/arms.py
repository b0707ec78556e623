"""Write an arm as JSON or as Python, with its symbols, and read it from JSON."""

import math
from collections.abc import Mapping
from typing import Any

from helpers.arm import Arm, Body, Joint, Row
from helpers.inputs import ArmError, require_type


def to_json(arm: Arm) -> dict[str, Any]:
    """Convert an arm to plain data; entries stay as written, unknown limits are left out."""
    require_type(arm, Arm, "arm")
    return {
        "name": arm.name,
        "rows": [_row_to_json(row) for row in arm.rows],
        "values": dict(arm.values),
        "bodies": [{"mass": body.mass, "com": list(body.com)} for body in arm.bodies],
        "home": list(arm.home),
        "source": arm.source,
    }


def _row_to_json(row: Row) -> dict[str, Any]:
    unknown = (None, math.inf, -math.inf)
    return {
        "entries": dict(zip(("a", "alpha", "d", "theta"), row.entries, strict=True)),
        "joint": {name: x for name, x in vars(row.joint).items() if x not in unknown},
    }


def from_json(data: Mapping[str, Any]) -> Arm:
    """Make the arm that `to_json` converted.

    Raises ArmError if the data make no arm.
    """
    try:
        rows = [Row(**row["entries"], joint=Joint(**row["joint"])) for row in data["rows"]]
        return Arm(**{**data, "rows": rows, "bodies": [Body(**body) for body in data["bodies"]]})
    except (KeyError, TypeError) as error:
        raise ArmError(
            f"the stored arm lacks or mistypes {error}; expected what to_json makes"
        ) from None


def to_python(arm: Arm) -> str:
    """Write a Python expression that makes the arm from `Arm`, `Body`, `Joint` and `Row`."""
    data = to_json(arm)
    rows = [
        f"Row({', '.join(map(repr, row['entries'].values()))},"
        f" Joint({_format_arguments(row['joint'])})),"
        for row in data.pop("rows")
    ]
    bodies = [f"Body({_format_arguments(body)})," for body in data.pop("bodies")]
    lines = [
        line
        for name, items in {"rows": rows, "bodies": bodies}.items()
        for line in (f"{name}=[", *(f"    {item}" for item in items), "],")
    ]
    lines += [f"{name}={value!r}," for name, value in data.items()]
    return "\n    ".join(["Arm(", *lines]) + "\n)"


def _format_arguments(arguments: Mapping[str, Any]) -> str:
    return ", ".join(f"{name}={value!r}" for name, value in arguments.items())
