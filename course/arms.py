"""An arm as JSON and as Python, symbols and all."""

import math
from collections.abc import Mapping
from typing import Any

from helpers.arm import Arm, Body, Joint, Row
from helpers.inputs import ArmError, require_type


def to_json(arm: Arm) -> dict[str, Any]:
    """An arm as plain data: entries as they are written, no entry for a limit that is not known."""
    require_type(arm, Arm, "arm")
    bodies = [{"mass": body.mass, "com": list(body.com)} for body in arm.bodies]
    kept = {"values": dict(arm.values), "bodies": bodies, "home": list(arm.home)}
    return {"name": arm.name, "rows": [*map(_plain, arm.rows)], **kept, "source": arm.source}


def _plain(row: Row) -> dict[str, Any]:
    unknown = (None, math.inf, -math.inf)
    known = {name: value for name, value in vars(row.joint).items() if value not in unknown}
    return {
        "entries": dict(zip(("a", "alpha", "d", "theta"), row.entries, strict=True)),
        "joint": known,
    }


def from_json(data: Mapping[str, Any]) -> Arm:
    """The arm that `to_json` made the data of; raises ArmError where they make none."""
    try:
        rows = [Row(**row["entries"], joint=Joint(**row["joint"])) for row in data["rows"]]
        return Arm(**{**data, "rows": rows, "bodies": [Body(**body) for body in data["bodies"]]})
    except (KeyError, TypeError) as error:
        raise ArmError(
            f"the stored arm lacks or mistypes {error}; expected what to_json makes"
        ) from None


def to_python(arm: Arm) -> str:
    """An expression of Python that makes the arm, with `Arm`, `Body`, `Joint`, `Row` at hand."""
    data = to_json(arm)
    rows = [
        f"Row({', '.join(map(repr, row['entries'].values()))}, Joint({_named(row['joint'])})),"
        for row in data.pop("rows")
    ]
    bodies = [f"Body({_named(body)})," for body in data.pop("bodies")]
    lists = {"rows": rows, "bodies": bodies}
    fields = [
        line
        for name, lines in lists.items()
        for line in (f"{name}=[", *(f"    {line}" for line in lines), "],")
    ]
    fields += [f"{name}={value!r}," for name, value in data.items()]
    return "\n    ".join(["Arm(", *fields]) + "\n)"


def _named(fields: Mapping[str, Any]) -> str:
    return ", ".join(f"{name}={value!r}" for name, value in fields.items())
