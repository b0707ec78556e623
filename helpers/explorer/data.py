"""Convert arms to plain data for the browser, and back."""

import math
from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from helpers.arm import Arm, Body, Joint, Row
from helpers.checks.arms import Data
from helpers.inputs import ArmError, listed
from helpers.inverse import Solutions

_POINTS = 181  # of a path that is played back: one for each two degrees of a circle
_DIGITS = 5  # of its joint values, so that the last digit of a machine's arithmetic does not show


def arm_from(name: str, rows: Sequence[Mapping[str, Any]]) -> Arm:
    """Return the arm of the rows that a browser sends; raise ArmError for invalid rows."""
    bodies = [Body(row["body"][0], tuple(row["body"][1:])) for row in rows if row.get("body")]
    complete = bodies if len(bodies) == len(rows) else []
    return Arm(name, tuple(_row(row) for row in rows), bodies=tuple(complete))


def _row(row: Mapping[str, Any]) -> Row:
    unknown = {"lower": -math.inf, "upper": math.inf, "speed": math.inf, "effort": math.inf}
    limits = {key: unknown[key] if row.get(key) is None else row[key] for key in unknown}
    return Row(row["a"], row["alpha"], row["d"], row["theta"], Joint(row["kind"], **limits))


def path_data(arm: Arm, trace: ArrayLike | None) -> list[list[float]] | None:
    """The joint vectors of a path, shape (N, dof) or an object with such a `q`, thinned to 181 of
    them."""
    if trace is None:
        return None
    path = arm.joint_vector(getattr(trace, "q", trace))
    if path.ndim != 2 or len(path) < 2:
        raise ArmError(
            f"{arm.name}: the trace has shape {path.shape}; expected (N, {arm.dof}), N ≥ 2"
        )
    kept = np.linspace(0, len(path) - 1, min(_POINTS, len(path))).round().astype(int)
    return _rounded(path[kept])


def branches_data(arm: Arm, branches: Solutions | Sequence[Any] | None) -> list[Data] | None:
    """The joint vectors of one pose: what a closed form gives, or vectors, shape (k, dof); a
    browser sends mappings."""
    if branches is None:
        return None
    if isinstance(branches, Solutions):
        if branches.q.ndim != 2:
            raise ArmError(
                f"{branches.arm.name}: the branches are those of {branches.q.shape[:-2]} poses;"
                " expected one"
            )
        rows = zip(branches.branches, branches.q, branches.valid, strict=True)
        branches = [{"label": name, "q": q} for name, q, valid in rows if valid]
    items = listed(branches, "branches", "a closed form's answer, or joint vectors (k, dof)")
    found = [item if isinstance(item, Mapping) else {"q": item} for item in items]
    return [{**item, "q": _rounded(arm.joint_vector(item["q"]))} for item in found]


def _rounded(values: np.ndarray) -> list:
    return (np.round(values, _DIGITS) + 0.0).tolist()
