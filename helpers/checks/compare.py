"""The comparisons: what a student holds becomes a question to the judge, its answer a report."""

from collections.abc import Callable, Mapping
from dataclasses import dataclass, replace
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from helpers.arm import Arm
from helpers.checks.arms import judged_data
from helpers.checks.engine import asked, say
from helpers.checks.functions import value_at
from helpers.checks.held import array_data
from helpers.checks.own_joints import in_own_joints
from helpers.checks.report import Report, report_of
from helpers.checks.tables import reading_options, table_text
from helpers.inputs import ArmError, must_be, named, number, one_of, shown, whole
from helpers.inverse.solutions import Solutions
from helpers.kinematics import forward_kinematics
from helpers.motion.paths import Path
from helpers.motion.report import report_trace
from helpers.statics import GRAVITY, check_wrench, static_torque

Array = NDArray[Any]

_NO_WRENCH = (0.0,) * 6


# What all share


def _settings(
    angles: str = "rad",
    tolerance: float | None = None,
    values: Mapping | None = None,
    which: int | None = None,
) -> dict[str, Any]:
    """The options that all comparisons have; raises ArmError for one that is none."""
    one_of(angles, "angles", ("rad", "deg"))
    found: dict[str, Any] = {"angles": angles}
    if values is not None:
        found["values"] = [list(pair) for pair in named(values, "values").items()]
    if tolerance is not None:
        found["tolerance"] = number(tolerance, "tolerance", "a number of 0 or more", least=0)
    if which is not None:
        found["which"] = whole(which, "which", least=1)
    return found


@dataclass(frozen=True)
class Typed:
    """Numbers as they were handed in, with the unit of each one's last place; 0 where exact."""

    values: Array
    units: Array


def numbers(mine: Any, what: str, wanted: str = "numbers") -> Typed:
    """Numbers of any shape, held or typed; raises ArmError, which calls them `what`, for others."""
    return _typed(asked("numbers", mine=array_data(mine), what=what, wanted=wanted))


def _typed(found: Mapping[str, Any]) -> Typed:
    values, units = (np.array(found[key], float) for key in ("values", "units"))
    return Typed(values.reshape(found["shape"]), units.reshape(found["shape"]))


# Tables


def compare_tables(
    mine: Any,
    reference: Arm,
    *,
    columns: str | None = None,
    lengths: str | None = None,
    angles: str | None = None,
    convention: str | None = None,
    values: Mapping[str, float] | None = None,
    tolerance: float | None = None,
) -> Report:
    """Whether two DH tables describe the same arm, and if not, where they differ and why.

    Compared is what no choice of frames can change: the kind of each joint, distance and twist
    between neighbouring axes, the offset along each axis (along parallel axes only the sum), and
    where the tip is on the last link. Free are the directions of the axes, the places of common
    normals between parallel axes, the zeros of the joints, the place of a sliding axis and
    the number of fixed rows. Where the joints of a right table count otherwise, the report prints
    the map and holds the arm in your joints, ``report.figures["arm"]``.

    Args:
        mine: an `Arm`, or rows in a list, text, `Link(...)` lines or 4 x 4 matrices, as
            ``Arm.from_table`` takes them.
        reference: the arm it should describe.
        columns, lengths, angles, convention, values: how to read `mine`; guessed, and said, unless
            given.
        tolerance: the largest deviation of a length (m); inferred from the digits typed unless
            given.

    Raises ArmError where an arm has no joint or `mine` is no table. Source: Siciliano et al.,
    Robotics, section 2.8.2, on the free choices.
    """
    must_be(reference, Arm, "the reference")
    options = _settings("rad", tolerance, values)
    del options["angles"]  # those of a table may be guessed
    if not reference.dof or (isinstance(mine, Arm) and not mine.dof):
        raise ArmError(
            f"cannot compare {shown(mine)} with {reference!r}; expected arms with one joint or more"
        )
    said = reading_options(columns, lengths, angles, convention)
    if isinstance(mine, Arm) and said:
        raise ArmError(say("arm is read", given=", ".join(map(shown, said.values()))))
    held = _arm_table(mine) if isinstance(mine, Arm) else table_text(mine)
    found = asked("table", mine=held, arm=judged_data(reference), options=options | said)
    if "map" not in found:
        return report_of(found)
    both = found["map"]["signs"], found["map"]["offsets"]
    own = in_own_joints(reference, found["map"], say("own joints", arm=reference.name))
    return report_of(found, joint_map=tuple(zip(*both, strict=True)), arm=own)


def _arm_table(arm: Arm) -> dict[str, Any]:
    entries = ("a", "alpha", "d", "theta")
    rows = [
        {"kind": row.joint.kind, **{name: arm.number(getattr(row, name)) for name in entries}}
        for row in arm.rows
    ]
    texts = [{name: str(getattr(row, name)) for name in entries} for row in arm.rows]
    return {"name": arm.name, "rows": rows, "texts": texts}


# Jacobians


def compare_jacobian(
    mine: object,
    arm: Arm,
    q: ArrayLike | str | None = None,
    *,
    angular_first: bool = False,
    frame: int = 0,
    angles: str = "rad",
    values: Mapping[str, float] | None = None,
    tolerance: float | None = None,
    which: int | None = None,
) -> Report:
    """Compare your Jacobian of an arm's tip with the right one, and name the mistake.

    Args:
        mine: a function of q, or of q_1, q_2, ... one by one; a SymPy matrix or a text in q_1,
            theta1, c_1, s_23, ... and the arm's symbols; or numbers at `q`: an array, lists, or
            pasted from NumPy, MATLAB, LaTeX, a spreadsheet.
        arm: whose Jacobian it should be; a locked joint as ``arm.lock(3)``.
        q: where to compare, shape (dof,); a pose without symmetry unless given. Numbers need it.
        angular_first: whether your rows are (omega, v) rather than (v, omega).
        frame: the link frame in whose axes your rows are, 0 for the base.
        angles: "deg" where `q` is in degrees.
        values: numbers for symbols of yours that the arm does not have.
        tolerance: the largest deviation of an entry; inferred from the digits typed unless given.
        which: of several answers that differ in a text, the number of the one that is meant.

    Raises ArmError where `mine` gives no matrix of numbers, or holds numbers and q is missing.
    """
    must_be(arm, Arm, "arm")
    options = _settings(angles, tolerance, values, which)
    if not isinstance(angular_first, int | np.bool_):
        raise ArmError(f"angular_first is {shown(angular_first)}; expected True or False")
    options |= {"angularFirst": bool(angular_first), "frame": _checked_frame(frame, arm)}
    at = array_data(_generic_pose(arm) if q is None else q)
    given = dict(arm=judged_data(arm), q=at)
    if not callable(mine) or hasattr(mine, "free_symbols"):
        options["generic"] = q is None
        return report_of(asked("jacobian", mine=array_data(mine), options=options, **given))
    joints = np.array(asked("joints", **given, angles=angles)["values"])
    found = value_at(mine, joints, f"{arm.name}: your Jacobian")
    options["computed"] = True
    return report_of(asked("jacobian", mine=array_data(found), options=options, **given))


def _checked_frame(frame: int, arm: Arm) -> int:
    number = whole(frame, f"{arm.name}: frame")
    if number > len(arm.rows):
        raise ArmError(
            f"{arm.name}: frame is {number}; expected a whole number from 0 to {len(arm.rows)}"
        )
    return number


def _generic_pose(arm: Arm) -> Array:
    lower, upper = arm.limits
    lower, upper = np.maximum(lower, -1.5), np.minimum(upper, 1.5)
    return lower + (upper - lower) * np.random.default_rng(19).uniform(0.55, 0.95, arm.dof)


# Torques


def compare_torques(
    mine: object,
    arm: Arm,
    q: ArrayLike | str,
    wrench: ArrayLike = _NO_WRENCH,
    gravity: ArrayLike = GRAVITY,
    *,
    angles: str = "rad",
    tolerance: float | None = None,
    which: int | None = None,
) -> Report:
    """Compare your torques at q, shape (..., dof), with g(q) - J^T F, and name the mistake.

    Args:
        mine: torques (..., dof) as an array, lists, SymPy columns or text; one list per joint and
            column vectors are turned round. A function of q is called at each pose.
        arm: with masses.
        q: joints of shape (..., dof), or text.
        wrench: on the tool, by the world, shape (6,), or (..., 6) with one for each pose.
        gravity: the vector of its acceleration in base axes (m/s^2).
        angles: "deg" where `q` is in degrees.
        tolerance: the largest deviation (N m); inferred from the digits typed unless given.
        which: of several answers that differ in a text, the number of the one that is meant.

    One pose can hide a mistake that a whole path shows. Raises ArmError where `mine` is not numbers
    or the arm has no masses.
    """
    must_be(arm, Arm, "arm")
    options = _settings(angles, tolerance, which=which)
    at, data = array_data(q), judged_data(arm)
    F = check_wrench(wrench)
    F = F.reshape(-1, 6) if F.ndim > 2 else F
    poses = np.array(asked("poses", q=at, arm=data, angles=angles)["values"]).reshape(-1, arm.dof)
    static_torque(arm, poses, F, gravity)  # says what is wrong with the load
    options |= {"wrench": F.tolist(), "gravity": np.asarray(gravity, float).tolist()}
    given = dict(arm=data, q=at)
    if callable(mine):
        q = poses if len(poses) > 1 or F.ndim == 1 else np.tile(poses, (len(F), 1))
        mine = _torques_along(mine, q, f"{arm.name}: your torques")
    return report_of(asked("torques", mine=array_data(mine), options=options, **given))


def _torques_along(function: Callable, poses: Array, what: str) -> Any:
    rows = [numbers(value_at(function, q, what), what).values.ravel() for q in poses]
    return rows if len(rows) > 1 else rows[0]


# Joint angles


def compare_branches(
    mine: object,
    found: Solutions,
    *,
    angles: str = "rad",
    tolerance: float | None = None,
    which: int | None = None,
) -> Report:
    """Judge your joint vectors, shape (answers, dof), for one target against all of its branches.

    Whole turns do not matter, nor does the order. A wrong answer is told how far off the tip is
    and, where one slip or two explain it, which; what is missing is named. Where a joint is free
    any one value of it stands for the branch.

    Args:
        mine: an array, lists, text, or pairs such as ('theta1', 0.3).
        found: what a closed form gives for the target.
        angles: "deg" where yours are in degrees.
        tolerance: the largest deviation of a joint (rad or m); inferred from the digits typed
            unless given.
        which: of several answers that differ in a text, the number of the one that is meant.

    Raises ArmError for another shape, or where `found` holds many targets.
    """
    must_be(found, Solutions, "found")
    options = _settings(angles, tolerance, which=which)
    if found.valid.ndim != 1:
        raise ArmError(say("one target", arm=found.arm.name, count=found.distance.size))
    branches = [
        {"name": str(name), "q": q.tolist(), "free": free.tolist(), "times": int(times)}
        for name, q, free, times in zip(
            found.branches, found.q, found.free, found.times, strict=True
        )
        if times
    ]
    tip = forward_kinematics(found.arm, branches[0]["q"]).tolist() if branches else None
    options["found"] = {"arm": found.arm.name, "branches": branches, "target": tip}
    given = dict(arm=judged_data(found.arm), mine=array_data(mine))
    return report_of(asked("branches", options=options, **given))


def compare_pose(
    q: object,
    arm: Arm,
    T: ArrayLike | str,
    *,
    angles: str = "rad",
    tolerance: float | None = None,
    which: int | None = None,
) -> Report:
    """Whether joint values take an arm's tip to a pose T, shape (4, 4), or to a point (3,), and if
    not, what slip would.

    Args:
        q: one joint vector, as an array, list, text or pairs such as ('theta1', 0.3).
        arm: any arm.
        T: where the tip should be, in base axes (m); numbers or formulas of the joints.
        angles: "deg" where q is in degrees.
        tolerance: the largest miss (m and rad); inferred from the digits of q and T unless given.
        which: of several answers that differ in a text, the number of the one that is meant.

    Raises ArmError for another shape.
    """
    must_be(arm, Arm, "arm")
    options = _settings(angles, tolerance, which=which)
    given = dict(arm=judged_data(arm), mine=array_data(q), target=array_data(T))
    return report_of(asked("pose", options=options, **given))


# Runs


def compare_trace(
    mine: object,
    arm: Arm,
    path: Path,
    tolerance: float | None = None,
    *,
    angles: str = "rad",
    which: int | None = None,
) -> Report:
    """Whether your joint vectors, shape (steps + 1, dof), make the tip follow a path, and if not,
    in what way they fail.

    Args:
        mine: one row for each of the path's times, or for all but the last; an array, lists, text
            such as CSV.
        arm: whose joints they are.
        path: what the tip should draw, at held orientation.
        tolerance: the largest distance (m) from where the tip should be; 2 mm, and what the digits
            of the joints leave open, unless given. The tool may lean or spin by 1 degree, or as it
            likes where fewer than six joints hold it. Unless a tolerance is given, a run so near
            that shows a slip (other lengths, the velocity of the next step) is wrong all the same.
        angles: "deg" where yours are in degrees.
        which: of several answers that differ in a text, the number of the one that is meant.

    Limits of range and speed are notes: the homework's own circle breaks them. Where joints jump by
    whole turns they are counted on, which is a note too. Raises ArmError where `mine` holds
    anything but finite numbers.
    """
    must_be(arm, Arm, "arm")
    must_be(path, Path, "path")
    options = _settings(angles, tolerance, which=which)
    given = dict(mine=array_data(mine), arm=judged_data(arm), options=options)
    held = {"times": path.times.tolist(), "normal": path.normal.tolist(), "at": []}
    wanted = _likely(path.times)
    while len(wanted):
        held["at"] += _sampled(path, np.asarray(wanted))
        found = asked("trace", path=held, **given)
        wanted = found.get("wanted", ())
    joints = found.get("figures", {}).pop("q", None)
    return report_of(found, **({} if joints is None else {"run": _run(arm, path, joints)}))


def _likely(times: Array) -> Array:
    """The times at which most verdicts need a path: those of its steps, and the middles."""
    step = np.diff(times)
    middles = times[:-1] + 0.5 * step
    return np.unique(np.concatenate([times, times[:-1] + step, middles, middles + step]))


def _sampled(path: Path, times: Array) -> list:
    """Where, and how fast, at each time."""
    both = path.position(times.copy()), path.velocity(times.copy())
    return [list(x) for x in zip(times.tolist(), *(x.tolist() for x in both), strict=True)]


def _run(arm: Arm, path: Path, joints: list) -> Any:
    """The report of `helpers.motion` on the joints as they were judged."""
    q = np.array(joints)
    path = replace(path, times=path.times[: len(q)])
    q_dot = np.diff(q, axis=0) / np.diff(path.times)[:, None]
    rates = np.vstack([q_dot, q_dot[-1:]])
    return report_trace(arm, path, q, rates, forward_kinematics(arm, q))
