"""Convert between the joint angles of a student's table and those of the reference."""

import math
from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

from helpers.arm import Arm, Body, Joint, Row


@dataclass(frozen=True)
class JointMap:
    """Map the joint values of a right table to joint values of the reference.

    Joint k of the reference is ``signs[k]`` times the student's joint plus ``offsets[k]``.

    Attributes:
        signs: 1, or -1 where the student's axis points the other way.
        offsets: in rad or m.
        start: the student's joint values where the homework starts (rad or m).
        arm: the reference with the student's rows and joint values.
        message: the joints that count otherwise, in one sentence.
        headers, rows: the map as a table of texts, a row for each joint.
    """

    signs: tuple[int, ...]
    offsets: tuple[float, ...]
    start: tuple[float, ...]
    arm: Arm
    message: str
    headers: tuple[str, ...]
    rows: tuple[tuple[str, ...], ...]

    def format_markdown(self) -> str:
        """Return the table in Markdown."""
        lines = [self.headers, ["---"] * len(self.headers), *self.rows]
        return "\n".join(f"| {' | '.join(line)} |" for line in lines)


def make_joint_map(answer: Mapping[str, Any], reference: Arm) -> JointMap:
    """Return the judge's map from the student's joints to those of `reference`."""
    return JointMap(
        tuple(answer["signs"]),
        tuple(answer["offsets"]),
        tuple(answer["start"]),
        _make_arm(answer["arm"], reference.source),
        answer["message"],
        tuple(answer["table"]["headers"]),
        tuple(map(tuple, answer["table"]["rows"])),
    )


def _make_arm(data: Mapping[str, Any], source: str) -> Arm:
    rows = [_make_row(row) for row in data["rows"]]
    bodies = [Body(row["body"][0], tuple(row["body"][1:])) for row in data["rows"] if "body" in row]
    return Arm(data["name"], rows, home=tuple(data["home"]), source=source, bodies=tuple(bodies))


def _make_row(row: Mapping[str, Any]) -> Row:
    limits = [row[name] for name in ("lower", "upper", "speed", "effort")]
    unknown = (-math.inf, math.inf, math.inf, math.inf)
    known = [x if x is not None else no_limit for x, no_limit in zip(limits, unknown, strict=True)]
    return Row(row["a"], row["alpha"], row["d"], row["theta"], Joint(row["kind"], *known))
