"""Convert arms to plain data for the browser, and back."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from helpers.arm import Arm, Body, Joint, Row
from helpers.checks.arms import Data, arm_data
from helpers.inputs import ArmError, tuple_of_items
from helpers.inverse import Solutions

_PATH_POINTS = 181  # most points sent of a path: one for every 2 degrees of a circle
_DECIMALS = 5  # of joint values, so that stored data do not depend on the processor's round-off


def circle_arm_data(arm: Arm) -> Data:
    """Return the data of an arm, with the homework's circle if the homework has one for it."""
    if arm.circle is None:
        return arm_data(arm)
    task = arm.circle
    circle = {"normal": task.normal, "seconds": task.seconds, "rates": task.rates}
    if task.locked_joint is not None:
        circle["locked"] = task.locked_joint - 1
    return {**arm_data(arm), "circle": circle}


def arm_from(name: str, rows: Sequence[Mapping[str, Any]]) -> Arm:
    """Return the arm given by the rows that a browser sends.

    Raises ArmError for invalid rows.
    """
    bodies = [Body(row["body"][0], tuple(row["body"][1:])) for row in rows if row.get("body")]
    complete = bodies if len(bodies) == len(rows) else []
    return Arm(name, tuple(_read_row(row) for row in rows), bodies=tuple(complete))


def _read_row(row: Mapping[str, Any]) -> Row:
    no_limits = {"lower": -math.inf, "upper": math.inf, "speed": math.inf, "effort": math.inf}
    limits = {
        key: no_limit if row.get(key) is None else row[key] for key, no_limit in no_limits.items()
    }
    return Row(row["a"], row["alpha"], row["d"], row["theta"], Joint(row["kind"], **limits))


def path_data(arm: Arm, trace: ArrayLike | None) -> list[list[float]] | None:
    """Return at most 181 joint vectors of a path for the page.

    Args:
        arm: The arm.
        trace: Joint vectors, shape (N, dof), or an object with such a `q`; None gives None.

    Raises:
        ArmError: The shape differs.
    """
    if trace is None:
        return None
    path = arm.joint_vector(getattr(trace, "q", trace))
    if path.ndim != 2 or len(path) < 2:
        raise ArmError(
            f"{arm.name}: the trace has shape {path.shape}; expected (N, {arm.dof}), N ≥ 2"
        )
    indices = np.linspace(0, len(path) - 1, min(_PATH_POINTS, len(path))).round().astype(int)
    return _rounded_list(path[indices])


def branches_data(arm: Arm, branches: Solutions | Sequence[Any] | None) -> list[Data] | None:
    """Return the solution branches of one pose for the page, each with a label if it has one.

    Args:
        arm: The arm.
        branches: A closed form's solutions of one pose, joint vectors of shape (k, dof), or the
            mappings with `q` that a browser sends; None gives None.

    Raises:
        ArmError: The solutions are of several poses, or a shape differs.
    """
    if branches is None:
        return None
    if isinstance(branches, Solutions):
        if branches.q.ndim != 2:
            raise ArmError(
                f"{branches.arm.name}: the branches are those of {branches.q.shape[:-2]} poses;"
                " expected one"
            )
        solutions = zip(branches.branches, branches.q, branches.valid, strict=True)
        branches = [{"label": name, "q": q} for name, q, valid in solutions if valid]
    items = tuple_of_items(
        branches, "branches", "a closed form's answer, or joint vectors (k, dof)"
    )
    mappings = [item if isinstance(item, Mapping) else {"q": item} for item in items]
    return [{**item, "q": _rounded_list(arm.joint_vector(item["q"]))} for item in mappings]


def _rounded_list(values: np.ndarray) -> list:
    return (np.round(values, _DECIMALS) + 0.0).tolist()
