"""The topics of the homework: for each what is drawn, how it is asked, and what is right.

Drawing and asking are apart, and what is drawn are plain numbers: a later NumPy, whose generators
may draw others, asks the same questions of them still.
"""

from collections.abc import Callable, Mapping, Sequence
from contextlib import suppress
from dataclasses import dataclass, replace
from functools import cached_property
from typing import Any, Literal, NamedTuple

import numpy as np
from numpy.typing import NDArray

from course.slips import Slip, made
from helpers import inverse, symbolic
from helpers.arm import Arm, Joint, Row, fixed
from helpers.inputs import ArmError
from helpers.kinematics import forward_kinematics, jacobian, link_frames
from helpers.motion import SingularError, Trace, circle, plain_inverse, trace
from helpers.statics import gravity_torque, static_torque

Array = NDArray[np.float64]
Rng = np.random.Generator
Given = Mapping[str, Any]
Kind = Literal["numbers", "rotation", "table", "jacobian", "column", "torques", "branches", "pose"]

_TRIES = 500
_EULER = 1000  # steps that the sheet asks for, or more
_STEPS = 100  # of the key's own run, which is exact at each of them
_SMALLEST = 0.04  # no question is asked nearer to a singular pose than this singular value
_POSE_DIGITS = 6  # of a target as printed: 1e-6 m moves a joint by 1e-6 / 0.04 rad at most
_FEWEST, _MOST = 3, 4  # decimals that are asked, mm at least: a list of slips is never complete
_BY_EULER = 2, 2  # those that 1000 steps give


@dataclass(frozen=True)
class Part:
    """One line of a key: the name to answer by, what is asked, the right value, and what known
    slips make of it.

    `kind` says how it is judged. `value` is an array, an `Arm` for a table, six formulas for a
    column, or the branches, shape (k, dof), for inverse kinematics. `idle` is what can be written
    without any work: zeros, or what the question itself gives.
    """

    name: str
    what: str
    kind: Kind
    value: Any
    slips: tuple[tuple[str, Array], ...] = ()
    idle: Any = 0.0

    @cached_property
    def digits(self) -> int:
        """The decimals asked: the fewest at which no number is within a unit of the right one and
        of a slip's as well; 0 where as many as may be asked do not tell them apart."""
        fewest, most = _BY_EULER if self.name in ("quarter", "half") else (_FEWEST, _MOST)
        nearest = min((np.abs(wrong - self.value).max() for _, wrong in self.slips), default=np.inf)
        return next((n for n in range(fewest, most + 1) if 2 * 10.0**-n < nearest), 0)

    @property
    def unit(self) -> float:
        """The unit of the last place asked, which is forgiven."""
        return 10.0**-self.digits


def _pose(arm: Arm, rng: Rng) -> list[float]:
    """Joint values to two decimals, well inside their range and away from singular poses."""
    lower, upper = (np.clip(limit, -2.4, 2.4) for limit in arm.limits)
    somewhere = np.linspace(0.3, 0.9, arm.dof)
    rows = 6 if arm.dof >= 6 else 3  # fewer joints hold the tip's place alone
    rank = np.linalg.matrix_rank(jacobian(arm, somewhere)[:rows])  # 2 for an arm that is plane
    for _ in range(_TRIES):
        q = (lower + (upper - lower) * rng.uniform(0.1, 0.9, arm.dof)).round(2) + 0.0
        smallest = np.linalg.svd(jacobian(arm, q)[:rows], compute_uv=False)[rank - 1]
        if smallest > _SMALLEST and q.all():  # the sign of 0 shows nowhere
            return list(q.tolist())
    raise ArmError(f"{arm.name}: no pose away from a singular one was found in {_TRIES} tries")


def _draw_table(arm: Arm, rng: Rng) -> Given | None:
    """An arm of four joints that no other question mentions, since their tables stand on the
    sheet; each of its joints moves the tip or turns it in a way of its own.
    """
    rows = [_drawn_row(rng) for _ in range(4)]
    rows[-1]["alpha"] = "0"
    if [row["kind"] for row in rows].count("prismatic") > 1:
        return None
    along = (rng.integers(-4, 5, len(rows)) * 0.05).round(2).tolist()
    given = {"rows": rows, "along": along}
    J = jacobian(drawn_arm(given), [0.3, 0.5, 0.7, 0.9])
    full_rank = np.linalg.svd(J, compute_uv=False)[-1] > 0.05
    return given if full_rank and all(row["alpha"] != "0" or row["a"] for row in rows) else None


def _drawn_row(rng: Rng) -> dict[str, Any]:
    return {
        "kind": str(rng.choice(["revolute", "revolute", "prismatic"])),
        "a": int(rng.choice([0, 0, 2, 3, 4, 5])) / 10,
        "alpha": str(rng.choice(["0", "pi/2", "-pi/2"])),
        "d": int(rng.choice([0, 0, 1, 2, 3])) / 10,
        "theta": str(rng.choice(["0", "0", "pi/2", "-pi/2"])),
    }


def drawn_arm(given: Given) -> Arm:
    """The arm of a table question, from the rows that were drawn."""
    rows = [
        Row(row["a"], row["alpha"], row["d"], row["theta"], Joint(row["kind"]))
        for row in given["rows"]
    ]
    return Arm("the arm asked", rows)


def _ask_table(arm: Arm, given: Given) -> tuple[str, tuple[Part, ...]]:
    right = drawn_arm(given)
    frames = link_frames(right, np.zeros(right.dof))
    lines = ["| joint | it | a point on its axis (m) | direction |", "|:-:|:--|:--|:--|"]
    for i, (row, shift) in enumerate(zip(right.rows, given["along"], strict=True)):
        verb = {"revolute": "turns", "prismatic": "slides"}[row.joint.kind]
        point, z = frames[i, :3, 3] + shift * frames[i, :3, 2], frames[i, :3, 2]
        lines.append(f"| {i + 1} | {verb} | ${matrix(point)}$ | ${matrix(z)}$ |")
    tip = frames[-1]
    text = (
        "Another arm. Its joint axes at $q = 0$, in the base frame, whose $z$ axis is the"
        " first joint axis:\n\n"
        + "\n".join(lines)
        + f"\n\nThe tip is at $p = {matrix(tip[:3, 3])}$; its frame has the axes"
        f" $x = {matrix(tip[:3, 0])}$ and $z = {matrix(tip[:3, 2])}$. Write a table of this arm"
        " in the standard convention. Every choice of frames that the convention allows is right."
    )
    what = "the table, one row (a, alpha, d, theta) for each joint: m and rad, the joint's"
    what += " variable (q_1, q_2, ...) in theta or d"
    return text, (Part("table", what, "table", right),)


def _ask_pose(arm: Arm, given: Given) -> tuple[str, tuple[Part, ...]]:
    right, q = _results(given, arm, given["q"]), matrix(given["q"])
    text = f"Where is the tip of this arm, and how is it turned, at $q = {q}$?"
    return text, (
        Part("p", "the tip's position (m)", "numbers", right["p"]),
        Part("R", "its rotation, a 3 × 3 matrix", "rotation", right["R"]),
    )


def _draw_jacobian(arm: Arm, rng: Rng) -> Given | None:
    return {
        "q": _pose(arm, rng),
        "q_dot": (rng.uniform(-1, 1, arm.dof).round(1) + 0.0).tolist(),
        **_draw_camera(arm, rng),
    }


def _draw_camera(arm: Arm, rng: Rng) -> dict[str, Any]:
    """A place on a link beyond the first, and a joint before it."""
    link = int(rng.integers(min(2, len(arm.rows)), len(arm.rows) + 1))
    before = sum(row <= link for row in arm.joints)
    place = [int(x) / 100 for x in rng.choice([-1, 1], 2) * rng.integers(3, 20, 2)]
    return {"link": link, "column": int(rng.integers(1, max(before, 1) + 1)), "camera": place}


def camera_arm(arm: Arm, given: Given) -> Arm:
    """The arm up to the camera: at (x, 0, z) in the frame of its link, turned like it."""
    x, z = given["camera"]
    rows = [*arm.rows[: given["link"]], fixed(a=x, d=z)]
    return Arm("the arm up to its camera", rows, arm.values)


def _ask_jacobian(arm: Arm, given: Given) -> tuple[str, tuple[Part, ...]]:
    q, q_dot, column = np.array(given["q"]), np.array(given["q_dot"]), int(given["column"])
    right = _results(given, arm, q)
    seen = camera_arm(arm, given)
    entries = [str(entry) for entry in symbolic.jacobian(seen)[:, column - 1]]
    names = ", ".join(f"`{name}`" for name in seen.variables)
    x, z = given["camera"]
    text = (
        f"At $q = {matrix(q)}$ the joints move at the rates $\\dot q = {matrix(q_dot)}$."
        " How does the tip move?\n\n"
        f"A camera is fixed to link {given['link']}, at ${matrix([x, 0, z])}$ m in that link's"
        f" frame, its axes parallel to the frame's. How does `{seen.variables[column - 1]}` alone"
        f" move it, for any $q$? Write {names}, and the lengths by their names."
    )
    formula = f"column {column} of the camera's Jacobian in symbols, six formulas (v, ω) in base"
    formula += " axes"
    return text, (
        Part("J", "the Jacobian, rows (v, ω) in base axes", "jacobian", right["J"]),
        Part("xi", "the tip's velocity (m/s, rad/s)", "numbers", right["xi"]),
        Part("J_column", formula, "column", entries),
    )


def _draw_circle(arm: Arm, rng: Rng) -> Given | None:
    """A circle that the arm can draw, along which each joint moves: a still one hides its sign."""
    given = {
        "q": _pose(arm, rng),
        "radius": int(rng.integers(5, 11)) / 100,
        "plane": str(rng.choice(["xy", "yz", "zx"])),
        "duration": int(rng.integers(2, 7)) * 5,
    }
    try:
        run = traced(arm, given)
    except (SingularError, ArmError):
        return None
    moved = np.abs(run.q[[_STEPS // 4, _STEPS // 2]] - run.q[0]).max(axis=0).min() > 0.02
    good = run.report.executable and run.report.smallest_singular_value > _SMALLEST
    return given if good and moved else None


def traced(arm: Arm, given: Given) -> Trace:
    """The exact run along the circle that was drawn: its start is the farthest point along the
    plane's first axis.
    """
    first = np.eye(3)["xyz".index(given["plane"][0])]
    centre = forward_kinematics(arm, given["q"])[:3, 3] - given["radius"] * first
    path = circle(centre, given["radius"], given["plane"], given["duration"], _STEPS)
    return trace(arm, given["q"], path, method="exact", rates=plain_inverse(1e-4))


def _ask_circle(arm: Arm, given: Given) -> tuple[str, tuple[Part, ...]]:
    right, (first, second), start = solve(arm, given), given["plane"], np.array(given["q"])
    text = (
        f"The tip starts at $q = {matrix(given['q'])}$ and draws a circle of radius"
        f" {given['radius']:g} m in the {first}{second} plane in {given['duration']:g} s, at even"
        f" speed and held orientation. The start is the circle's farthest point along $+{first}$;"
        f" from there the tip moves towards $+{second}$. Use {_EULER} Euler steps or more, or a"
        " better method."
    )
    joints = "the joints after {} of the time (rad; m where one slides)"
    return text, (
        Part("centre", "the circle's centre (m)", "numbers", right["centre"]),
        Part("quarter", joints.format("a quarter"), "numbers", right["quarter"], idle=start),
        Part("half", joints.format("half"), "numbers", right["half"], idle=start),
    )


def _draw_torque(arm: Arm, rng: Rng) -> Given | None:
    q, force = _pose(arm, rng), np.zeros(3)
    force[rng.integers(3)] = float(rng.choice([-1, 1])) * float(rng.integers(10, 41)) / 2
    return {"q": q, "force": force.tolist()}


def _ask_torque(arm: Arm, given: Given) -> tuple[str, tuple[Part, ...]]:
    q, force, right = matrix(given["q"]), matrix(given["force"]), _results(given, arm, given["q"])
    text = (
        f"At $q = {q}$ the world acts on the tip with the force ${force}$ N (base"
        " axes, no moment). Which torques hold the arm without it, which with it? Take 9.81 m/s²."
        " Masses, and centres of mass, each in the frame of its own link: that of row $i$ for"
        f" link $i$.\n\n{_bodies(arm)}"
    )
    return text, (
        Part("g", "the torques that hold the weight (N m)", "torques", right["g"]),
        Part("tau", "the torques with the force (N m)", "torques", right["tau"]),
    )


def _draw_target(arm: Arm, rng: Rng) -> Given | None:
    q = _pose(arm, rng)
    asked = forward_kinematics(arm, q)[:3, 0 if arm.dof >= 6 else 3 :]
    return {"target": (asked.round(_POSE_DIGITS) + 0.0).tolist(), "one way": q}


def _ask_target(arm: Arm, given: Given) -> tuple[str, tuple[Part, ...]]:
    target, solver = np.array(given["target"]), closed_form(arm)
    asked = "pose $[R\\ p]$" if target.shape[1] == 4 else "position $p$"
    asked += f" $= {matrix(target, _POSE_DIGITS)}$."
    if not solver:
        what = "joint values (rad; m where one slides) that give this"
        way = Part("q", what, "pose", np.array(given["one way"]))
        return f"Find joint values that give the tip the {asked}", (way,)
    text = f"Find every set of joint values within the limits that give the tip the {asked}"
    limits = "; ".join(
        f"${name.replace('q_', 'q_{')}}}$ from {low:g} to {high:g}"
        for name, low, high in zip(arm.variables, *arm.limits, strict=True)
        if np.isfinite([low, high]).all()
    )
    text += f" Limits: {limits}; whole turns count as the same." if limits else ""
    found = solver(arm, pose_of(target))
    what = "the branches, one row of joint values each (rad; m where one slides)"
    return text, (Part("q", what, "branches", found.q[found.within_limits]),)


def pose_of(target: Array) -> Array:
    """A target as printed, 3 × 4, as a rigid motion: the nearest rotation beside its position."""
    if target.shape[1] == 1:
        return target[:, 0]
    U, _, V = np.linalg.svd(target[:, :3])
    T = np.eye(4)
    T[:3] = np.c_[U @ V, target[:, 3]]
    return T


class Topic(NamedTuple):
    """How the numbers of a topic are drawn, None where a draw is of no use, and how an arm and
    they make a question and its key."""

    draw: Callable[[Arm, Rng], Given | None]
    ask: Callable[[Arm, Given], tuple[str, tuple[Part, ...]]]


BY_NAME = {
    "DH table": Topic(_draw_table, _ask_table),
    "forward kinematics": Topic(lambda arm, rng: {"q": _pose(arm, rng)}, _ask_pose),
    "Jacobian": Topic(_draw_jacobian, _ask_jacobian),
    "circle tracing": Topic(_draw_circle, _ask_circle),
    "static torque": Topic(_draw_torque, _ask_torque),
    "inverse kinematics": Topic(_draw_target, _ask_target),
}


def solve(arm: Arm, given: Given) -> dict[str, Array]:
    """The numbers of a question with a pose, by the names of the parts."""
    if "radius" not in given:
        return _results(given, arm, np.array(given["q"]))
    run, first = traced(arm, given), np.eye(3)["xyz".index(given["plane"][0])]
    shares = {"quarter": 1, "half": 2, "three quarters": 3}
    joints = {name: run.q[n * _STEPS // 4] for name, n in shares.items()}
    return {"centre": run.path.positions[0] - given["radius"] * first, **joints}


def question_parts(topic: str, arm: Arm, given: Given) -> tuple[str, tuple[Part, ...]]:
    """A topic's text and key, each part with what the known slips make of it."""
    text, parts = BY_NAME[topic].ask(arm, given)
    slips = made(arm, given, solve) if "q" in given else ()
    return text, tuple(replace(part, slips=_changed(part.name, slips)) for part in parts)


def _changed(name: str, slips: Sequence[Slip]) -> tuple[tuple[str, Array], ...]:
    return tuple((slip.words, slip.answers[name]) for slip in slips if name in slip.answers)


def drawn(topic: str, arm: Arm, rng: Rng) -> Given:
    """What is drawn for a topic, anew until it can be asked and every slip shows."""
    for _ in range(_TRIES):
        given = BY_NAME[topic].draw(arm, rng)
        if given and all(p.digits for p in question_parts(topic, arm, given)[1]):
            return given
    raise ArmError(f"{arm.name}: no {topic} that shows every slip was found in {_TRIES} tries")


def _results(given: Given, arm: Arm, q: Array) -> dict[str, Array]:
    """What follows at once from an arm and q, shape (..., dof), by the names of the parts."""
    T = forward_kinematics(arm, q)
    found = {"p": T[..., :3, 3], "R": T[..., :3, :3]}
    if "q_dot" in given:
        J = jacobian(arm, q)
        found |= {"J": J, "xi": J @ np.array(given["q_dot"])}
    if "force" in given:
        tau = static_torque(arm, q, np.r_[given["force"], 0, 0, 0])
        found |= {"g": gravity_torque(arm, q), "tau": tau}
    return found


def _bodies(arm: Arm) -> str:
    """The links' masses and centres of mass as a Markdown table."""
    lines = ["| link | mass (kg) | $x$ (m) | $y$ (m) | $z$ (m) |", "|:-:|:-:|:-:|:-:|:-:|"]
    for i, body in enumerate(arm.bodies, 1):
        numbers = [repr(arm.number(entry)) for entry in (body.mass, *body.com)]
        lines.append(f"| {i} | {' | '.join(numbers)} |")
    return "\n".join(lines)


def matrix(values: Any, digits: int = 4) -> str:
    """A vector or a matrix in LaTeX, rounded to that many decimals."""
    rows = np.atleast_2d(np.round(np.asarray(values, dtype=float), digits) + 0.0)
    lines = [" & ".join(f"{x:.{digits + 1}g}" for x in row) for row in rows]
    return "\\begin{bmatrix}" + " \\\\ ".join(lines) + "\\end{bmatrix}"


def lacks(topic: str, arm: Arm) -> str:
    if not arm.dof:
        return "a joint that moves"
    if topic == "circle tracing" and arm.dof != 6:
        return "six joints that move"
    return "masses" if topic == "static torque" and not arm.bodies else ""


def closed_form(arm: Arm) -> Callable[..., inverse.Solutions] | None:
    """The closed form that finds every branch of an arm, None where the book has none."""
    probe = forward_kinematics(arm, np.full(arm.dof, 0.4))
    for solver in (inverse.elbow, inverse.ur, inverse.stanford, inverse.spherical_wrist):
        with suppress(ArmError):
            solver(arm, probe[:3, 3] if solver is inverse.elbow else probe)
            return solver
    return None
