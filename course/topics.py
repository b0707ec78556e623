"""Draw the numbers of each topic of the homework, write its questions and compute their key.

Drawn numbers are plain data. A later NumPy may draw other numbers from the same seed, and still
asks the same questions about stored ones.
"""

from collections.abc import Callable, Mapping
from contextlib import suppress
from dataclasses import dataclass, replace
from functools import cached_property, lru_cache
from typing import Any, Literal, NamedTuple

import numpy as np
from numpy.typing import NDArray

from course.mistakes import (
    BACKWARDS,
    OTHER_SIDE,
    Mistake,
    list_mistakes,
    list_other_units,
    select_visible,
)
from helpers import inverse, symbolic
from helpers.arm import Arm, Joint, Row, fixed
from helpers.inputs import ArmError
from helpers.kinematics import forward_kinematics, jacobian, link_frames
from helpers.motion import SingularError, Trace, circle, plain_inverse, trace
from helpers.statics import gravity_torque, static_torque

Array = NDArray[np.float64]
Rng = np.random.Generator
Numbers = Mapping[str, Any]  # the drawn numbers of a topic
Kind = Literal["numbers", "rotation", "table", "jacobian", "column", "torques", "branches", "pose"]

_MAX_TRIES = 500
_EULER_STEPS = 1000  # fewest steps that the sheet asks for
_KEY_STEPS = 100  # enough for the answer key, whose trace is exact at each step
_SMALLEST_SINGULAR_VALUE = 0.04  # questions with a smaller one are drawn again
_TARGET_DIGITS = 6  # decimals of a target: 1e-6 m change a joint by at most 1e-6 / 0.04 rad
_FEWEST_DIGITS, _MOST_DIGITS = 3, 4  # decimals that are asked
_EULER_DIGITS = 2  # decimals that 1000 Euler steps give
_SECRET_CONFIGURATION_COUNT = 4  # configurations at which a formula is evaluated
# Tolerance relative to the largest number, since typed constants may have four digits.
_FORMULA_SHARE = 1e-4
_LENGTH_RATIO = 1.25  # a drawn column's formula may be longer or shorter than usual by this factor


@dataclass(frozen=True)
class Part:
    """An answer that a question asks for.

    Attributes:
        name: Name to answer by.
        description: The quantity that is asked, with its unit.
        kind: The kind of answer, which determines how it is judged.
        value: Right answer: an array; an `Arm` for a table; for a column its values at the secret
            configurations, shape (k, 6); the branches, shape (k, dof), for inverse kinematics.
        mistakes: Usual mistakes with their answers.
        baseline: Values that need no work and earn nothing, such as zeros or values of the
            question.
        formulas: Six formulas of a column.
    """

    name: str
    description: str
    kind: Kind
    value: Any
    mistakes: tuple[Mistake, ...] = ()
    baseline: Any = 0.0
    formulas: tuple[str, ...] = ()

    @cached_property
    def digits(self) -> int:
        """Fewest decimals that distinguish every mistake from the right answer, or 0 if none do.

        A mistake shows if some number differs by more than two units, so that no answer is within
        a unit of both.
        """
        if self.name.startswith(("quarter", "half")):
            digits = range(_EULER_DIGITS, _EULER_DIGITS + 1)
        else:
            digits = range(_FEWEST_DIGITS, _MOST_DIGITS + 1)
        differences = [np.abs(m.values - self.value).max() for m in self.mistakes]
        nearest = min(differences, default=np.inf)
        return next((n for n in digits if 2 * 10.0**-n < nearest), 0)

    @property
    def unit(self) -> float:
        """Largest accepted error, a unit of the last decimal."""
        if self.kind == "column":
            return _FORMULA_SHARE * max(1.0, float(np.abs(self.value).max()))
        return 10.0**-self.digits


def _draw_configuration(arm: Arm, rng: Rng) -> list[float]:
    """Draw joint values of two decimals, within limits and away from singular configurations."""
    lower, upper = (np.clip(limit, -2.4, 2.4) for limit in arm.limits)
    somewhere = np.linspace(0.3, 0.9, arm.dof)
    rows = 6 if arm.dof >= 6 else 3  # fewer joints control only the position
    rank = np.linalg.matrix_rank(jacobian(arm, somewhere)[:rows])  # 2 for a planar arm
    for _ in range(_MAX_TRIES):
        q = (lower + (upper - lower) * rng.uniform(0.1, 0.9, arm.dof)).round(2) + 0.0
        smallest = np.linalg.svd(jacobian(arm, q)[:rows], compute_uv=False)[rank - 1]
        if smallest > _SMALLEST_SINGULAR_VALUE and q.all():  # a joint at 0 would hide a wrong sign
            return list(q.tolist())
    raise ArmError(
        f"{arm.name}: no configuration away from a singular one was found in {_MAX_TRIES} tries"
    )


def _draw_table(arm: Arm, rng: Rng) -> Numbers | None:
    """Draw an arm of four joints whose Jacobian has rank 4.

    The sheet shows the table of the arm of all further questions, so this arm differs from it.
    """
    rows = [_draw_row(rng) for _ in range(4)]
    rows[-1]["alpha"] = "0"
    if [row["kind"] for row in rows].count("prismatic") > 1:
        return None
    along = (rng.integers(-4, 5, len(rows)) * 0.05).round(2).tolist()
    numbers = {"rows": rows, "along": along}
    J = jacobian(make_drawn_arm(numbers), [0.3, 0.5, 0.7, 0.9])
    full_rank = np.linalg.svd(J, compute_uv=False)[-1] > 0.05
    return numbers if full_rank and all(row["alpha"] != "0" or row["a"] for row in rows) else None


def _draw_row(rng: Rng) -> dict[str, Any]:
    return {
        "kind": str(rng.choice(["revolute", "revolute", "prismatic"])),
        "a": int(rng.choice([0, 0, 2, 3, 4, 5])) / 10,
        "alpha": str(rng.choice(["0", "pi/2", "-pi/2"])),
        "d": int(rng.choice([0, 0, 1, 2, 3])) / 10,
        "theta": str(rng.choice(["0", "0", "pi/2", "-pi/2"])),
    }


def make_drawn_arm(numbers: Numbers) -> Arm:
    """Return the arm of a table question from its drawn rows."""
    rows = [
        Row(row["a"], row["alpha"], row["d"], row["theta"], Joint(row["kind"]))
        for row in numbers["rows"]
    ]
    return Arm("the arm asked", rows)


def _write_table_question(arm: Arm, numbers: Numbers) -> tuple[str, tuple[Part, ...]]:
    right = make_drawn_arm(numbers)
    frames = link_frames(right, np.zeros(right.dof))
    lines = ["| joint | it | a point on its axis (m) | direction |", "|:-:|:--|:--|:--|"]
    for i, (row, shift) in enumerate(zip(right.rows, numbers["along"], strict=True)):
        verb = {"revolute": "turns", "prismatic": "slides"}[row.joint.kind]
        point, z = frames[i, :3, 3] + shift * frames[i, :3, 2], frames[i, :3, 2]
        lines.append(f"| {i + 1} | {verb} | ${format_matrix(point)}$ | ${format_matrix(z)}$ |")
    tip = frames[-1]
    text = (
        "Another arm. Its joint axes at $q = 0$, in the base frame, whose $z$ axis is the"
        " first joint axis:\n\n"
        + "\n".join(lines)
        + f"\n\nThe tip is at $p = {format_matrix(tip[:3, 3])}$; its frame has the axes"
        f" $x = {format_matrix(tip[:3, 0])}$ and $z = {format_matrix(tip[:3, 2])}$. Write a table"
        " of this arm in the standard convention. Every choice of frames that the convention allows"
        " is right."
    )
    description = "the table, one row (a, alpha, d, theta) for each joint: m and rad, the joint's"
    description += " variable (q_1, q_2, ...) in theta or d"
    return text, (Part("table", description, "table", right),)


def _write_pose_question(arm: Arm, numbers: Numbers) -> tuple[str, tuple[Part, ...]]:
    right, q = _compute_at_configuration(numbers, arm, numbers["q"]), format_matrix(numbers["q"])
    text = f"Where is the tip of this arm, and how is it turned, at $q = {q}$?"
    mistakes = list_mistakes("tip", arm, q=numbers["q"])
    positions = [m._replace(values=m.values[:3]) for m in mistakes]
    rotations = [m._replace(values=m.values[3:]) for m in mistakes]
    return text, (
        _make_part("p", "the tip's position (m)", "numbers", right["p"], positions),
        _make_part("R", "its rotation, a 3 × 3 matrix", "rotation", right["R"], rotations),
    )


def _draw_jacobian(arm: Arm, rng: Rng) -> Numbers | None:
    return {
        "q": _draw_configuration(arm, rng),
        "q_dot": (rng.uniform(-1, 1, arm.dof).round(1) + 0.0).tolist(),
        **_draw_camera(arm, rng),
        "configurations": [
            _draw_configuration(arm, rng) for _ in range(_SECRET_CONFIGURATION_COUNT)
        ],
    }


def _draw_camera(arm: Arm, rng: Rng) -> dict[str, Any]:
    """Draw a link, a joint before it and a point, so that all students' formulas are similar."""
    choices = _list_usual_columns(arm.rows, tuple(arm.values))
    link, column = choices[rng.integers(len(choices))]
    position = [int(x) / 100 for x in rng.choice([-1, 1], 2) * rng.integers(3, 20, 2)]
    return {"link": link, "column": column, "camera": position}


@lru_cache(maxsize=64)
def _list_usual_columns(rows: tuple[Row, ...], names: tuple[str, ...]) -> list[tuple[int, int]]:
    """List the links and joints whose column has formulas of about the usual length."""
    arm = Arm("measured", rows, dict.fromkeys(names, 0.5))
    lengths = dict[tuple[int, int], int]()
    for link in range(min(2, len(rows)), len(rows) + 1):
        camera = make_camera_arm(arm, {"link": link, "camera": [0.11, 0.13]})
        J: Any = symbolic.jacobian(camera) if camera.dof else None
        for column in range(camera.dof):
            lengths[link, column + 1] = len("".join(map(str, J[:, column])))
    usual = float(np.median([*lengths.values()]))
    columns = [x for x, n in lengths.items() if usual / _LENGTH_RATIO <= n <= usual * _LENGTH_RATIO]
    return columns or [*lengths]


def make_camera_arm(arm: Arm, numbers: Numbers) -> Arm:
    """Return the arm up to the camera, at (x, 0, z) in the frame of its link."""
    x, z = numbers["camera"]
    rows = [*arm.rows[: numbers["link"]], fixed(a=x, d=z)]
    return Arm("the arm up to its camera", rows, arm.values)


def _write_jacobian_question(arm: Arm, numbers: Numbers) -> tuple[str, tuple[Part, ...]]:
    q, q_dot, column = np.array(numbers["q"]), np.array(numbers["q_dot"]), int(numbers["column"])
    right, camera = _compute_at_configuration(numbers, arm, q), make_camera_arm(arm, numbers)
    names, moving = ", ".join(f"`{x}`" for x in camera.variables), camera.variables[column - 1]
    x, z = numbers["camera"]
    text = (
        f"At $q = {format_matrix(q)}$ the joints move at the rates $\\dot q ="
        f" {format_matrix(q_dot)}$. How does the tip move?\n\n"
        f"A camera is fixed to link {numbers['link']}, at ${format_matrix([x, 0, z])}$ m in that"
        f" link's frame, its axes parallel to the frame's. How does `{moving}` alone move it,"
        f" for any $q$? Write {names}, and the lengths by their names."
    )
    mistakes = list_mistakes("jacobian", arm, q=q)
    velocities = [m._replace(values=m.values.reshape(6, -1) @ q_dot) for m in mistakes]
    return text, (
        _make_part("J", "the Jacobian, rows (v, ω) in base axes", "jacobian", right["J"], mistakes),
        _make_part("xi", "the tip's velocity (m/s, rad/s)", "numbers", right["xi"], velocities),
        _make_column_part(camera, numbers, column),
    )


def _make_column_part(camera: Arm, numbers: Numbers, column: int) -> Part:
    """Return the part that asks for a column in symbols, judged at the secret configurations."""
    description = (
        f"column {column} of the camera's Jacobian in symbols, six formulas (v, ω) in base axes"
    )
    configurations = np.array(numbers["configurations"])[:, : camera.dof]
    values = jacobian(camera, configurations)[:, :, column - 1]
    mistakes = [
        m._replace(values=m.values.reshape(len(configurations), 6, camera.dof)[:, :, column - 1])
        for m in list_mistakes("jacobian", camera, configurations=configurations)
    ]
    entries = symbolic.jacobian(camera)[:, column - 1]
    part = _make_part("J_column", description, "column", values, mistakes)
    return replace(part, formulas=tuple(str(entry) for entry in entries))


def _make_part(
    name: str, description: str, kind: Kind, value: Array, mistakes: list[Mistake]
) -> Part:
    return Part(name, description, kind, value, select_visible(mistakes, value))


def _draw_circle(arm: Arm, rng: Rng) -> Numbers | None:
    """Draw a circle that the arm can follow and along which each joint moves.

    A joint that stands still hides the sign of its variable.
    """
    numbers = {
        "q": _draw_configuration(arm, rng),
        "radius": int(rng.integers(5, 11)) / 100,
        "plane": str(rng.choice(["xy", "yz", "zx"])),
        "duration": int(rng.integers(2, 7)) * 5,
    }
    try:
        trajectory = trace_circle(arm, numbers)
    except (SingularError, ArmError):
        return None
    q, report = trajectory.q, trajectory.report
    moved = np.abs(q[[_KEY_STEPS // 4, _KEY_STEPS // 2]] - q[0]).max(axis=0).min() > 0.02
    is_safe = report.executable and report.smallest_singular_value > _SMALLEST_SINGULAR_VALUE
    return numbers if is_safe and moved else None


def trace_circle(arm: Arm, numbers: Numbers) -> Trace:
    """Trace the drawn circle exactly, from its farthest point along the plane's first axis."""
    first = np.eye(3)["xyz".index(numbers["plane"][0])]
    centre = forward_kinematics(arm, numbers["q"])[:3, 3] - numbers["radius"] * first
    path = circle(centre, numbers["radius"], numbers["plane"], numbers["duration"], _KEY_STEPS)
    return trace(arm, numbers["q"], path, method="exact", rates=plain_inverse(1e-4))


def _write_circle_question(arm: Arm, numbers: Numbers) -> tuple[str, tuple[Part, ...]]:
    right, (first, second) = _compute_circle(arm, numbers), numbers["plane"]
    start = np.array(numbers["q"])
    text = (
        f"The tip starts at $q = {format_matrix(numbers['q'])}$ and draws a circle of radius"
        f" {numbers['radius']:g} m in the {first}{second} plane in {numbers['duration']:g} s,"
        f" at even speed and held orientation. The start is the circle's farthest point along"
        f" $+{first}$; from there the tip moves towards $+{second}$. Use {_EULER_STEPS} Euler"
        " steps or more, or a better method."
    )
    joints = "the joints after {} of the time (rad; m where one slides)"
    other_side = 2 * forward_kinematics(arm, start)[:3, 3] - right["centre"]
    centres = [Mistake("trace.other side", OTHER_SIDE, other_side)]
    centres += list_other_units(right["centre"], lengths=True)
    half, quarter = (list_other_units(right[x], ~arm.turning) for x in ("half", "quarter"))
    quarter.append(Mistake("trace.backwards", BACKWARDS, right["three quarters"]))
    return text, (
        Part("centre", "the circle's centre (m)", "numbers", right["centre"], tuple(centres)),
        Part("quarter", joints.format("a quarter"), "numbers", right["quarter"], tuple(quarter),
             start),
        Part("half", joints.format("half"), "numbers", right["half"], tuple(half), start),
    )  # fmt: skip


def _draw_torque(arm: Arm, rng: Rng) -> Numbers | None:
    q, force = _draw_configuration(arm, rng), np.zeros(3)
    force[rng.integers(3)] = float(rng.choice([-1, 1])) * float(rng.integers(10, 41)) / 2
    return {"q": q, "force": force.tolist()}


def _write_torque_question(arm: Arm, numbers: Numbers) -> tuple[str, tuple[Part, ...]]:
    q, force = format_matrix(numbers["q"]), format_matrix(numbers["force"])
    right = _compute_at_configuration(numbers, arm, numbers["q"])
    text = (
        f"At $q = {q}$ the world acts on the tip with the force ${force}$ N (base"
        " axes, no moment). Which torques hold the arm without it, which with it? Take 9.81 m/s²."
        " Masses, and centres of mass, each in the frame of its own link: that of row $i$ for"
        f" link $i$.\n\n{_format_bodies(arm)}"
    )
    wrench = [*numbers["force"], 0, 0, 0]
    g_mistakes = list_mistakes("torques", arm, q=numbers["q"], wrench=np.zeros(6))
    tau_mistakes = list_mistakes("torques", arm, q=numbers["q"], wrench=wrench)
    for mistakes, value in ((g_mistakes, right["g"]), (tau_mistakes, right["tau"])):
        mistakes += list_other_units(value, lengths=True)
    g = _make_part("g", "the torques that hold the weight (N m)", "torques", right["g"], g_mistakes)
    description = "the torques with the force (N m)"
    tau = _make_part("tau", description, "torques", right["tau"], tau_mistakes)
    return text, (g, replace(tau, baseline=right["g"]))


def _draw_target(arm: Arm, rng: Rng) -> Numbers | None:
    """Draw a target with the usual number of branches, which is the same for every student."""
    usual = _count_usual_branches(arm) if find_closed_form_solver(arm) else 0
    q = _draw_configuration(arm, rng)
    numbers = _make_target(arm, q)
    return numbers if not usual or len(_find_branches(arm, numbers)) == usual else None


def _make_target(arm: Arm, q: list[float]) -> dict[str, Any]:
    rounded = forward_kinematics(arm, q)[:3, 0 if arm.dof >= 6 else 3 :].round(_TARGET_DIGITS)
    return {"target": (rounded.reshape(3, -1) + 0.0).tolist(), "solution": q}


def _find_branches(arm: Arm, numbers: Numbers) -> Array:
    """Return the branches within the limits, shape (k, dof)."""
    find_all = find_closed_form_solver(arm)
    assert find_all
    solutions = find_all(arm, make_target_pose(np.array(numbers["target"])))
    return np.asarray(solutions.q[solutions.within_limits])


def _count_usual_branches(arm: Arm) -> int:
    """Return the most common number of branches of an arm whose lengths change by up to a tenth."""
    lengths = tuple(sorted((name, round(x, 1)) for name, x in arm.values.items()))
    return _count_branches_of(replace(arm, name=""), lengths)


@lru_cache(maxsize=16)
def _count_branches_of(arm: Arm, _lengths: tuple[tuple[str, float], ...]) -> int:
    rng = np.random.default_rng(0)
    counts = [
        len(_find_branches(arm, _make_target(arm, _draw_configuration(arm, rng))))
        for _ in range(40)
    ]
    return int(np.bincount(counts).argmax())


def _write_target_question(arm: Arm, numbers: Numbers) -> tuple[str, tuple[Part, ...]]:
    target = np.array(numbers["target"])
    quantity = "pose $[R\\ p]$" if target.shape[1] == 4 else "position $p$"
    quantity += f" $= {format_matrix(target, _TARGET_DIGITS)}$."
    if not find_closed_form_solver(arm):
        description = "joint values (rad; m where one slides) that give this"
        part = Part("q", description, "pose", np.array(numbers["solution"]))
        return f"Find joint values that give the tip the {quantity}", (part,)
    branches = _find_branches(arm, numbers)
    text = (
        f"Find every set of joint values within the limits that give the tip the {quantity} There"
        f" are {len(branches)}; of more rows the first {len(branches)} count."
    )
    limits = "; ".join(
        f"${name.replace('q_', 'q_{')}}}$ from {low:g} to {high:g}"
        for name, low, high in zip(arm.variables, *arm.limits, strict=True)
        if np.isfinite([low, high]).all()
    )
    text += f" Limits: {limits}; whole turns count as the same." if limits else ""
    description = "the branches, one row of joint values each (rad; m where one slides)"
    return text, (Part("q", description, "branches", branches),)


def make_target_pose(target: Array) -> Array:
    """Return a printed target as a point, shape (3,), or as a rigid motion, shape (4, 4).

    The rotation is the rotation nearest to the rounded entries.
    """
    if target.shape[1] == 1:
        return target[:, 0]
    U, _, V = np.linalg.svd(target[:, :3])
    T = np.eye(4)
    T[:3] = np.c_[U @ V, target[:, 3]]
    return T


class Topic(NamedTuple):
    """Functions that draw the numbers of a topic and write its question.

    `draw` returns None for useless numbers.
    """

    draw: Callable[[Arm, Rng], Numbers | None]
    write: Callable[[Arm, Numbers], tuple[str, tuple[Part, ...]]]
    parts: tuple[str, ...]


TOPIC_BY_NAME = {
    "DH table": Topic(_draw_table, _write_table_question, ("table",)),
    "forward kinematics": Topic(
        lambda arm, rng: {"q": _draw_configuration(arm, rng)}, _write_pose_question, ("p", "R")
    ),
    "Jacobian": Topic(_draw_jacobian, _write_jacobian_question, ("J", "xi", "J_column")),
    "circle tracing": Topic(_draw_circle, _write_circle_question, ("centre", "quarter", "half")),
    "static torque": Topic(_draw_torque, _write_torque_question, ("g", "tau")),
    "inverse kinematics": Topic(_draw_target, _write_target_question, ("q",)),
}


def _compute_circle(arm: Arm, numbers: Numbers) -> dict[str, Array]:
    """Compute the right numbers of a circle, by the names of the parts."""
    trajectory, first = trace_circle(arm, numbers), np.eye(3)["xyz".index(numbers["plane"][0])]
    shares = {"quarter": 1, "half": 2, "three quarters": 3}
    joints = {name: trajectory.q[n * _KEY_STEPS // 4] for name, n in shares.items()}
    return {"centre": trajectory.path.positions[0] - numbers["radius"] * first, **joints}


def write_question(topic: str, arm: Arm, numbers: Numbers) -> tuple[str, tuple[Part, ...]]:
    """Write a topic's text and the parts of its key."""
    return TOPIC_BY_NAME[topic].write(arm, numbers)


def draw_numbers(topic: str, arm: Arm, rng: Rng) -> Numbers:
    """Draw numbers for a topic until it has an answer that every mistake changes."""
    for _ in range(_MAX_TRIES):
        numbers = TOPIC_BY_NAME[topic].draw(arm, rng)
        if numbers and all(part.digits for part in write_question(topic, arm, numbers)[1]):
            return numbers
    raise ArmError(
        f"{arm.name}: no {topic} that shows every mistake was found in {_MAX_TRIES} tries"
    )


def _compute_at_configuration(numbers: Numbers, arm: Arm, q: Array) -> dict[str, Array]:
    """Compute the right numbers at a configuration, by the names of the parts."""
    T = forward_kinematics(arm, q)
    values = {"p": T[..., :3, 3], "R": T[..., :3, :3]}
    if "q_dot" in numbers:
        J = jacobian(arm, q)
        values |= {"J": J, "xi": J @ np.array(numbers["q_dot"])}
    if "force" in numbers:
        tau = static_torque(arm, q, np.r_[numbers["force"], 0, 0, 0])
        values |= {"g": gravity_torque(arm, q), "tau": tau}
    return values


def _format_bodies(arm: Arm) -> str:
    """Format the links' masses and centres of mass as a Markdown table."""
    lines = ["| link | mass (kg) | $x$ (m) | $y$ (m) | $z$ (m) |", "|:-:|:-:|:-:|:-:|:-:|"]
    for i, body in enumerate(arm.bodies, 1):
        numbers = [repr(arm.number(entry)) for entry in (body.mass, *body.com)]
        lines.append(f"| {i} | {' | '.join(numbers)} |")
    return "\n".join(lines)


def format_matrix(values: Any, digits: int = 4) -> str:
    """Format a vector or a matrix in LaTeX, rounded to some decimals."""
    rows = np.atleast_2d(np.round(np.asarray(values, dtype=float), digits) + 0.0)
    lines = [" & ".join(f"{x:.{digits + 1}g}" for x in row) for row in rows]
    return "\\begin{bmatrix}" + " \\\\ ".join(lines) + "\\end{bmatrix}"


def find_missing_property(topic: str, arm: Arm) -> str:
    """Return the name of the property that a topic needs and an arm lacks, or ""."""
    if not arm.dof:
        return "a joint that moves"
    if topic == "circle tracing" and arm.dof != 6:
        return "six joints that move"
    return "masses" if topic == "static torque" and not arm.bodies else ""


def find_closed_form_solver(arm: Arm) -> Callable[..., inverse.Solutions] | None:
    """Return the solver that finds every branch of an arm in closed form, or None."""
    probe = forward_kinematics(arm, np.full(arm.dof, 0.4))
    for solver in (inverse.elbow, inverse.ur, inverse.stanford, inverse.spherical_wrist):
        with suppress(ArmError):
            solver(arm, probe[:3, 3] if solver is inverse.elbow else probe)
            return solver
    return None
