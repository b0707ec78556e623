"""Arms as plain data that a browser can read, and back."""

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
    """The arm whose rows a browser sends; raises ArmError where they make no arm."""
    bodies = [Body(*_mass_and_centre(row["body"])) for row in rows if row.get("body")]
    complete = bodies if len(bodies) == len(rows) else []
    return Arm(name, tuple(_row(row) for row in rows), bodies=tuple(complete))


def _mass_and_centre(body: Sequence[float]) -> tuple[float, tuple[float, ...]]:
    return body[0], tuple(body[1:])


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


def branches_data(
    arm: Arm, branches: Solutions | Mapping[str, ArrayLike] | ArrayLike | None
) -> list[Data] | None:
    """Joint vectors of one pose: a closed form's, a mapping from names to them, or an array of
    shape (k, dof)."""
    if branches is None:
        return None
    if isinstance(branches, Solutions):
        branches = _named(branches)
    wanted = "a closed form's answer, a mapping from names to joint vectors, or (k, dof)"
    branches = branches if isinstance(branches, Mapping) else listed(branches, "branches", wanted)
    if isinstance(branches, Mapping):
        return [
            {"label": str(name), "q": _rounded(arm.joint_vector(q))} for name, q in branches.items()
        ]
    return [_branch(arm, branch) for branch in branches]


def _named(found: Solutions) -> dict[str, np.ndarray]:
    if found.q.ndim != 2:
        raise ArmError(
            f"{found.arm.name}: the branches are those of {found.q.shape[:-2]} poses; expected one"
        )
    return {
        name: q
        for name, q, valid in zip(found.branches, found.q, found.valid, strict=True)
        if valid
    }


def _branch(arm: Arm, branch: Any) -> Data:
    data = branch if isinstance(branch, Mapping) else {"q": branch}  # a browser sends mappings
    return {**data, "q": _rounded(arm.joint_vector(data["q"]))}


def _rounded(values: np.ndarray) -> list:
    return (np.round(values, _DIGITS) + 0.0).tolist()
