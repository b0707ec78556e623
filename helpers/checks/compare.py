"""Compare a student's answers with the right answers.

Each comparison turns the answer into plain data, asks the judge and returns its `Verdict`.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping
from dataclasses import dataclass, replace
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from helpers.arm import Arm, Body, require_joints
from helpers.checks.arms import judge_data
from helpers.checks.engine import ask_judge
from helpers.checks.functions import call_student_function
from helpers.checks.plain_data import to_plain_data
from helpers.checks.student_arm import make_joint_map
from helpers.checks.tables import check_reading_options, format_table
from helpers.checks.verdict import Verdict, make_verdict
from helpers.inputs import (
    ArmError,
    finite_number,
    numbers_by_name,
    require_choice,
    require_type,
    shorten,
    whole_number,
)
from helpers.inverse.solutions import Solutions
from helpers.kinematics import forward_kinematics
from helpers.motion.paths import Path
from helpers.motion.report import report_trace
from helpers.statics import GRAVITY, check_wrench, static_torque

Array = NDArray[Any]

_NO_WRENCH = (0.0,) * 6
_FEWEST_SAMPLES = 400  # of a path: cubics between them are within 1e-9 of a circle's radius


# Options of all comparisons


def _check_options(
    angles: str = "rad",
    tolerance: float | None = None,
    values: Mapping | None = None,
    answer_number: int | None = None,
) -> dict[str, Any]:
    """Check the options that all comparisons share, and return those for the judge."""
    require_choice(angles, "angles", ("rad", "deg"))
    options: dict[str, Any] = {"angles": angles}
    if values is not None:
        options["values"] = [list(pair) for pair in numbers_by_name(values, "values").items()]
    if tolerance is not None:
        options["tolerance"] = finite_number(
            tolerance, "tolerance", "a number of 0 or more", least=0
        )
    if answer_number is not None:
        options["which"] = whole_number(answer_number, "answer_number", least=1)
    return options


@dataclass(frozen=True)
class TypedNumbers:
    """Numbers as the student typed them.

    Attributes:
        values: the numbers, of any shape.
        units: unit of the last decimal typed, of the same shape; 0 for an exact number.
    """

    values: Array
    units: Array


def read_numbers(answer: Any, name: str, expected: str = "numbers") -> TypedNumbers:
    """Read numbers of any shape from text, lists or arrays.

    Raises ArmError, which calls them `name`, for anything else.
    """
    return _make_typed_numbers(
        ask_judge("numbers", mine=to_plain_data(answer), what=name, wanted=expected)
    )


def _make_typed_numbers(answer: Mapping[str, Any]) -> TypedNumbers:
    values, units = (np.array(answer[key], float) for key in ("values", "units"))
    return TypedNumbers(values.reshape(answer["shape"]), units.reshape(answer["shape"]))


# Tables


def compare_tables(
    answer: Any,
    reference: Arm,
    *,
    columns: str | None = None,
    lengths: str | None = None,
    angles: str | None = None,
    convention: str | None = None,
    values: Mapping[str, float] | None = None,
    tolerance: float | None = None,
    start_configuration: ArrayLike | None = None,
) -> Verdict:
    """Judge whether two DH tables describe the same arm.

    The verdict says where they differ and why.

    The comparison uses what no choice of frames can change: the kind of each joint, distance and
    twist between neighbouring axes, the offset along each axis (along parallel axes only the sum),
    and where the tip is on the last link. The student may choose the directions of the axes, the
    positions of common normals between parallel axes, the zeros of the joints, the position of a
    sliding axis and the number of fixed rows. The base frame, the tip and the direction of the last
    axis are the reference's. The grade of a right table whose joints count otherwise is "right by
    map": the verdict shows the map, and ``verdict.joint_map.arm`` is the arm in your joints.

    Args:
        answer: an `Arm`, a text, `Link(...)` lines, or rows, parallel lists, a data frame or 4 x 4
            matrices, which are read as a text.
        reference: the arm it should describe.
        columns, lengths, angles, convention, values: how to read `answer`; guessed unless given,
            and the verdict says what was guessed.
        tolerance: the largest deviation of a length (m); inferred from the digits typed unless
            given.
        start_configuration: joint values (rad or m) at which the question says where the tool is. A
            table that takes it elsewhere is wrong, though another choice of zeros would explain it.

    Raises ArmError where an arm has no joint or `answer` is no table. Source: Siciliano et al.,
    Robotics, section 2.8.2, on the free choices.
    """
    require_type(reference, Arm, "the reference")
    options = _check_options("rad", tolerance, values)
    del options["angles"]  # in a table, the judge guesses the unit of angles
    if not reference.dof or (isinstance(answer, Arm) and not answer.dof):
        raise ArmError(
            f"cannot compare {shorten(answer)} with {reference!r};"
            " expected arms with one joint or more"
        )
    reading_options = check_reading_options(columns, lengths, angles, convention)
    if isinstance(answer, Arm) and reading_options:
        settings = ", ".join(map(shorten, reading_options.values()))
        raise ArmError(
            "your table is an Arm, whose units are metres and radians, so"
            f" {settings} would change nothing; leave it out"
        )
    if start_configuration is not None:
        options["startConfiguration"] = reference.joint_vector(
            start_configuration, "start_configuration", many=False
        ).tolist()
    table = _arm_table(answer) if isinstance(answer, Arm) else format_table(answer)
    reply = ask_judge(
        "table", mine=table, arm=judge_data(reference), options=options | reading_options
    )
    joint_map = make_joint_map(reply["map"], reference) if "map" in reply else None
    verdict = make_verdict(reply, joint_map)
    return verdict if isinstance(answer, str) else replace(verdict, marked_text=None)


def _arm_table(arm: Arm) -> dict[str, Any]:
    """Return the rows of an arm as numbers and as text."""
    entries = ("a", "alpha", "d", "theta")
    rows = [
        {"kind": row.joint.kind, **{name: arm.number(getattr(row, name)) for name in entries}}
        for row in arm.rows
    ]
    texts = [{name: str(getattr(row, name)) for name in entries} for row in arm.rows]
    return {"name": arm.name, "rows": rows, "texts": texts}


# Jacobians


def compare_jacobian(
    answer: object,
    arm: Arm,
    q: ArrayLike | str | None = None,
    *,
    angular_first: bool = False,
    frame: int = 0,
    angles: str = "rad",
    lengths: str = "m",
    values: Mapping[str, float] | None = None,
    tolerance: float | None = None,
    answer_number: int | None = None,
) -> Verdict:
    """Compare your Jacobian of an arm's tip with the right Jacobian, and name the mistake.

    Args:
        answer: a function of q, or of q_1, q_2, ... one by one; a SymPy matrix or a text in q_1,
            theta1, c_1, s_23, ... and the arm's symbols; or numbers at `q`: an array, lists, or
            pasted from NumPy, MATLAB, LaTeX, a spreadsheet.
        arm: whose Jacobian it should be; a locked joint as ``arm.lock(3)``.
        q: where to compare numbers, shape (dof,). Formulas in the joints are compared at five
            general configurations, a function without q at one.
        angular_first: whether your rows are (omega, v) rather than (v, omega).
        frame: the link frame in whose axes your rows are, 0 for the base.
        angles: "deg" where `q` is in degrees.
        lengths: "cm" or "mm" where your linear rows are, unless the text itself says so.
        values: numbers for symbols of yours that the arm does not have.
        tolerance: the largest deviation of an entry; inferred from the digits typed unless given.
        answer_number: where a text holds several answers that differ, the number of the one to
            judge, from 1.

    Raises ArmError where `answer` gives no matrix of numbers, or holds numbers and q is missing.
    """
    require_type(arm, Arm, "arm")
    options = _check_options(angles, tolerance, values, answer_number)
    if not isinstance(angular_first, int | np.bool_):
        raise ArmError(f"angular_first is {shorten(angular_first)}; expected True or False")
    options |= {"angularFirst": bool(angular_first), "frame": _check_frame(frame, arm)}
    options["lengths"] = require_choice(lengths, "lengths", ("m", "cm", "mm"))
    options["generic"] = q is None
    at = to_plain_data(_generic_configuration(arm) if q is None else q)
    given = dict(arm=judge_data(arm), q=at)
    if not callable(answer) or hasattr(answer, "free_symbols"):
        return make_verdict(
            ask_judge("jacobian", mine=to_plain_data(answer), options=options, **given)
        )
    joints = np.array(ask_judge("joints", **given, angles=angles)["values"])
    computed = call_student_function(answer, joints, f"{arm.name}: your Jacobian")
    options["computed"] = True
    return make_verdict(
        ask_judge("jacobian", mine=to_plain_data(computed), options=options, **given)
    )


def _check_frame(frame: int, arm: Arm) -> int:
    number = whole_number(frame, f"{arm.name}: frame")
    if number > len(arm.rows):
        raise ArmError(
            f"{arm.name}: frame is {number}; expected a whole number from 0 to {len(arm.rows)}"
        )
    return number


def _generic_configuration(arm: Arm) -> Array:
    """Return joint values (dof,) within 1.5 rad or m of 0, away from limits and special angles."""
    lower, upper = arm.limits
    lower, upper = np.maximum(lower, -1.5), np.minimum(upper, 1.5)
    return lower + (upper - lower) * np.random.default_rng(19).uniform(0.55, 0.95, arm.dof)


# Torques


def compare_torques(
    answer: object,
    arm: Arm,
    q: ArrayLike | str,
    wrench: ArrayLike = _NO_WRENCH,
    gravity: ArrayLike = GRAVITY,
    *,
    angles: str = "rad",
    tolerance: float | None = None,
    answer_number: int | None = None,
) -> Verdict:
    """Compare your torques at q, shape (..., dof), with g(q) - J^T F, and name the mistake.

    An arm without masses has g = 0: the wrench alone loads its joints.

    Args:
        answer: torques (..., dof) as an array, lists, SymPy columns or text; one list per joint and
            column vectors are transposed. A function of q is called at each configuration.
        arm: with or without masses.
        q: joints of shape (..., dof), or text.
        wrench: on the tool, by the world, shape (6,), or (..., 6) with one for each
            configuration.
        gravity: the vector of its acceleration in base axes (m/s^2).
        angles: "deg" where `q` is in degrees.
        tolerance: the largest deviation (N m); inferred from the digits typed unless given.
        answer_number: where a text holds several answers that differ, the number of the one to
            judge, from 1.

    One configuration can hide a mistake that a whole path shows. Raises ArmError where `answer` is
    not numbers, or the arm has neither masses nor a wrench.
    """
    require_joints(arm)
    options = _check_options(angles, tolerance, answer_number=answer_number)
    at, data = to_plain_data(q), judge_data(arm)
    F = check_wrench(wrench)
    F = F.reshape(-1, 6) if F.ndim > 2 else F
    configurations = np.array(
        ask_judge("configurations", q=at, arm=data, angles=angles)["values"]
    ).reshape(-1, arm.dof)
    loaded = arm if arm.bodies else arm.with_bodies([Body(0.0, (0.0, 0.0, 0.0))] * len(arm.rows))
    static_torque(loaded, configurations, F, gravity)  # raises ArmError for an invalid load
    options |= {"wrench": F.tolist(), "gravity": np.asarray(gravity, float).tolist()}
    given = dict(arm=data, q=at)
    if callable(answer):
        q = (
            configurations
            if len(configurations) > 1 or F.ndim == 1
            else np.tile(configurations, (len(F), 1))
        )
        answer = _call_at_configurations(answer, q, f"{arm.name}: your torques")
    return make_verdict(ask_judge("torques", mine=to_plain_data(answer), options=options, **given))


def _call_at_configurations(function: Callable, configurations: Array, name: str) -> Any:
    """Return the torques that a student's function gives at each configuration."""
    rows = [
        read_numbers(call_student_function(function, q, name), name).values.ravel()
        for q in configurations
    ]
    return rows if len(rows) > 1 else rows[0]


# Joint angles


def compare_branches(
    answer: object,
    solutions: Solutions,
    *,
    angles: str = "rad",
    tolerance: float | None = None,
    answer_number: int | None = None,
) -> Verdict:
    """Judge your joint vectors, shape (answers, dof), against all branches of their target.

    Order and whole turns do not matter. For a wrong answer the verdict gives the distance of the
    tip from its target and the one or two mistakes that explain it; it names missing branches. Any
    value of a free joint counts as the branch.

    Args:
        answer: an array, lists, text, or pairs such as ('theta1', 0.3).
        solutions: the solutions of a closed form for the target.
        angles: "deg" where yours are in degrees.
        tolerance: the largest deviation of a joint (rad or m); inferred from the digits typed
            unless given.
        answer_number: where a text holds several answers that differ, the number of the one to
            judge, from 1.

    Raises ArmError for another shape, or where `solutions` holds many targets.
    """
    require_type(solutions, Solutions, "solutions")
    options = _check_options(angles, tolerance, answer_number=answer_number)
    if solutions.valid.ndim != 1:
        raise ArmError(
            f"{solutions.arm.name}: solutions hold {solutions.distance.size} targets;"
            " expected the branches of one target"
        )
    branches = [
        {"name": str(name), "q": q.tolist(), "free": free.tolist(), "times": int(times)}
        for name, q, free, times in zip(
            solutions.branches, solutions.q, solutions.free, solutions.times, strict=True
        )
        if times
    ]
    tip = forward_kinematics(solutions.arm, branches[0]["q"]).tolist() if branches else None
    options["found"] = {"arm": solutions.arm.name, "branches": branches, "target": tip}
    given = dict(arm=judge_data(solutions.arm), mine=to_plain_data(answer))
    return make_verdict(ask_judge("branches", options=options, **given))


def compare_pose(
    q: object,
    arm: Arm,
    T: ArrayLike | str,
    *,
    angles: str = "rad",
    tolerance: float | None = None,
    answer_number: int | None = None,
) -> Verdict:
    """Judge whether joint values take an arm's tip to its target.

    For a wrong answer the verdict names the mistake that would give it.

    Args:
        q: one joint vector, as an array, list, text or pairs such as ('theta1', 0.3).
        arm: any arm.
        T: target pose, shape (4, 4), or point, shape (3,), in base axes (m); numbers or formulas
            in the joints.
        angles: "deg" where q is in degrees.
        tolerance: the largest miss (m and rad); inferred from the digits of q and T unless given.
        answer_number: where a text holds several answers that differ, the number of the one to
            judge, from 1.

    Raises ArmError for another shape.
    """
    require_type(arm, Arm, "arm")
    options = _check_options(angles, tolerance, answer_number=answer_number)
    given = dict(arm=judge_data(arm), mine=to_plain_data(q), target=to_plain_data(T))
    return make_verdict(ask_judge("pose", options=options, **given))


# Traces


def compare_trace(
    answer: object,
    arm: Arm,
    path: Path,
    tolerance: float | None = None,
    *,
    angles: str = "rad",
    answer_number: int | None = None,
) -> Verdict:
    """Judge whether joint vectors, shape (steps + 1, dof), make the tip follow a path.

    Args:
        answer: one row for each of the path's times, or for all but the last; an array, lists, text
            such as CSV.
        arm: whose joints they are.
        path: the path of the tip, which keeps its orientation.
        tolerance: the largest distance (m) from where the tip should be; 2 mm, and what the digits
            of the joints leave open, unless given. The tool may tilt or spin by 1 degree,
            or by any angle if the arm has fewer than six joints. Unless a tolerance is given, a
            trace within these bounds that shows a mistake (other lengths, the velocity of the next
            step) is still wrong.
        angles: "deg" where yours are in degrees.
        answer_number: where a text holds several answers that differ, the number of the one to
            judge, from 1.

    Exceeded limits of range and speed become notes, since the homework's own circle exceeds them.
    Jumps of joints by whole turns are removed, also with a note. Raises ArmError where `answer`
    holds anything but finite numbers.
    """
    require_type(arm, Arm, "arm")
    require_type(path, Path, "path")
    options = _check_options(angles, tolerance, answer_number=answer_number)
    reply = ask_judge(
        "trace",
        mine=to_plain_data(answer),
        arm=judge_data(arm),
        path=_sample_path(path),
        options=options,
    )
    joints = reply.get("figures", {}).pop("q", None)
    figures = {} if joints is None else {"run": _report_read_joints(arm, path, joints)}
    return make_verdict(reply, **figures)


def _sample_path(path: Path) -> dict[str, list]:
    """Return the path as samples of time, position (m) and velocity (m/s).

    Each step is divided into an even number of parts, so that its middle is among the samples.
    """
    starts, durations = path.times[:-1, None], np.diff(path.times)[:, None]
    parts = 2 * math.ceil(_FEWEST_SAMPLES / (2 * max(1, len(starts))))
    times = np.append(starts + durations * (np.arange(parts) / parts), path.times[-1])
    columns = times, path.position(times.copy()), path.velocity(times.copy())
    samples = [list(row) for row in zip(*(c.tolist() for c in columns), strict=True)]
    return {"times": path.times.tolist(), "normal": path.normal.tolist(), "samples": samples}


def _report_read_joints(arm: Arm, path: Path, joints: list) -> Any:
    """Return the report of `helpers.motion` on the joints as the judge read them."""
    q = np.array(joints)
    path = replace(path, times=path.times[: len(q)])
    q_dot = np.diff(q, axis=0) / np.diff(path.times)[:, None]
    rates = np.vstack([q_dot, q_dot[-1:]])
    return report_trace(arm, path, q, rates, forward_kinematics(arm, q))
