"""Homework with other numbers: questions and their solution key, both from one seed.

The same seed gives the same sheet on every machine. Lengths change by up to a tenth, poses and
forces are drawn anew, and the key is computed by the functions that the book uses, so it always
fits the question.
"""

from collections.abc import Callable, Mapping
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import ArrayLike, NDArray

from helpers.arm import Arm
from helpers.inputs import ArmError, must_be, one_of, whole
from helpers.kinematics import forward_kinematics, jacobian
from helpers.motion import (
    SingularError,
    Trace,
    UnreachableError,
    circle,
    plain_inverse,
    trace,
)
from helpers.statics import gravity_torque, static_torque

__all__ = [
    "TOPICS",
    "Answer",
    "Variant",
    "sheet",
    "variant",
]

Array = NDArray[np.float64]
Rng = np.random.Generator

_TRIES = 500
_STEPS = 100  # of the key's own run; the student's may be any number
_SMALLEST = 0.04  # no question is asked nearer to a singular pose than this singular value


@dataclass(frozen=True)
class Answer:
    """One line of the key: what is asked, the right value, how far off an answer may be.

    `read` makes the value out of what is handed in, where that is not the value itself.
    """

    what: str
    value: Array
    tolerance: float
    read: Callable[[Array], Array] = lambda given: given

    def accepts(self, given: ArrayLike) -> bool:
        """Whether a student's value counts as right; another shape, or no number, does not."""
        try:
            array = self.read(np.asarray(given, dtype=float))
        except (TypeError, ValueError):
            return False
        same = array.shape == self.value.shape
        return same and bool((np.abs(array - self.value) <= self.tolerance).all())


@dataclass(frozen=True, repr=False)
class Variant:
    """One topic of the homework with numbers of its own: the arm, the question, and the key to
    it."""

    topic: str
    seed: int
    arm: Arm
    question: str
    key: Mapping[str, Answer]

    def marks(self, given: Mapping[str, ArrayLike]) -> dict[str, bool]:
        """Which entries of the key were answered rightly; one that is missing is wrong."""
        must_be(given, Mapping, "given")
        return {name: name in given and a.accepts(given[name]) for name, a in self.key.items()}

    @property
    def question_text(self) -> str:
        """The question as Markdown, with the names of the answers that it asks for and the arm's
        table."""
        asked = [f"- `{name}`: {answer.what}" for name, answer in self.key.items()]
        lines = ["", self.question, "", *asked, "", self.arm._repr_markdown_()]
        return "\n".join([f"**{_title(self.topic)}**", *lines])

    @property
    def key_text(self) -> str:
        """The key as Markdown, one line for each answer."""
        lines = [f"- `{n}`, {a.what}: ${_matrix(a.value)}$" for n, a in self.key.items()]
        return "\n".join([f"**Key to {self.topic}, seed {self.seed}**", "", *lines])

    def __repr__(self) -> str:
        return f"<Variant {self.seed} of {self.topic}: {self.arm.name.rsplit(', ', 1)[0]}>"

    def _repr_markdown_(self) -> str:
        return self.question_text


def variant(topic: str, arm: Arm, seed: int) -> Variant:
    """A topic's question about an arm, with the numbers that belong to `seed`.

    Raises ArmError for an unknown topic, a seed below 0, or an arm that the topic does not suit.
    """
    one_of(topic, "topic", _TOPICS)
    must_be(arm, Arm, "arm")
    seed = whole(seed, "seed")
    if not _suits(topic, arm):
        raise ArmError(f"{arm.name} does not suit {topic}; it has {arm.dof} joints")
    rng = np.random.default_rng([seed, TOPICS.index(topic)])
    other = _with_other_lengths(arm, seed)
    question, key = _TOPICS[topic](other, rng)
    return Variant(topic, seed, other, question, key)


def sheet(arm: Arm, seed: int) -> tuple[Variant, ...]:
    """Every topic that suits the arm, about one and the same arm."""
    must_be(arm, Arm, "arm")
    return tuple(variant(topic, arm, seed) for topic in TOPICS if _suits(topic, arm))


def _suits(topic: str, arm: Arm) -> bool:
    """Torques need masses, and a held orientation needs as many joints as J has rows."""
    return {"static torque": bool(arm.bodies), "circle tracing": arm.dof == 6}.get(topic, True)


def _with_other_lengths(arm: Arm, seed: int) -> Arm:
    """The arm with every value within a tenth of its own, to three decimals; one that is 0
    stays."""
    factors = np.random.default_rng(seed).uniform(0.9, 1.1, len(arm.values))
    new = {
        name: round(v * float(f), 3)
        for (name, v), f in zip(arm.values.items(), factors, strict=True)
    }
    return replace(arm.with_values(**new), name=f"{arm.name}, variant {seed}")


def _pose(arm: Arm, rng: Rng) -> Array:
    """Joint values to two decimals, well inside their range and away from singular poses."""
    lower, upper = (np.clip(limit, -2.4, 2.4) for limit in arm.limits)
    for _ in range(_TRIES):
        q = (lower + (upper - lower) * rng.uniform(0.1, 0.9, arm.dof)).round(2)
        if _smallest(arm, q) > _SMALLEST:
            return q
    raise ArmError(f"{arm.name}: no pose away from a singular one was found in {_TRIES} tries")


def _smallest(arm: Arm, q: Array) -> float:
    """The smallest singular value of what the arm's joints can command, all six rows or the place
    alone."""
    rows = slice(0, 6 if arm.dof >= 6 else 3)
    somewhere = np.random.default_rng(0).uniform(0.3, 0.9, arm.dof)
    rank = np.linalg.matrix_rank(jacobian(arm, somewhere)[rows])  # 2 for an arm that is plane
    return float(np.linalg.svd(jacobian(arm, q)[rows], compute_uv=False)[rank - 1])


def _dh_tables(arm: Arm, rng: Rng) -> tuple[str, dict[str, Answer]]:
    q = _pose(arm, rng)
    T = forward_kinematics(arm, q)
    question = f"Where is the tip of this arm, and how is it turned, at $q = {_matrix(q)}$?"
    return question, {
        "p": Answer("its position (m)", T[:3, 3], 1e-3),
        "R": Answer("its rotation, a 3 × 3 matrix", T[:3, :3], 2e-3),
    }


def _jacobian(arm: Arm, rng: Rng) -> tuple[str, dict[str, Answer]]:
    q, q_dot = _pose(arm, rng), rng.uniform(-1, 1, arm.dof).round(1) + 0.0
    J = jacobian(arm, q)
    question = (
        f"At $q = {_matrix(q)}$ the joints move at the rates $\\dot q = {_matrix(q_dot)}$."
        " How does the tip move?"
    )
    return question, {
        "J": Answer("the Jacobian, rows $(v, \\omega)$ in base axes", J, 2e-3),
        "xi": Answer("the tip's velocity (m/s, rad/s)", J @ q_dot, 5e-3),
    }


def _circle_tracing(arm: Arm, rng: Rng) -> tuple[str, dict[str, Answer]]:
    run, radius, plane = _run(arm, rng)
    first, second = list(plane)
    centre = run.path.positions[0] - radius * np.eye(3)["xyz".index(first)]
    question = (
        f"The tip starts at $q_0 = {_matrix(run.q[0])}$ and draws a circle of radius {radius:g} m"
        " in the"
        f" {first}{second} plane in {run.t[-1]:g} s, at even speed and held orientation. The start"
        " is the circle's"
        f" farthest point along $+{first}$; from there the tip moves towards $+{second}$."
    )
    joints = "the joints after {} of the time (rad; m where one slides)"
    return question, {
        "centre": Answer("the circle's centre (m)", centre, 1e-3),
        "quarter": Answer(joints.format("a quarter"), run.q[_STEPS // 4], 1e-2),
        "half": Answer(joints.format("half"), run.q[_STEPS // 2], 1e-2),
    }


def _run(arm: Arm, rng: Rng) -> tuple[Trace, float, str]:
    """A circle that the arm can draw from a pose of its own: within its range and far from singular
    poses."""
    for _ in range(_TRIES):
        q = _pose(arm, rng)
        radius, plane = float(rng.integers(5, 11)) / 100, str(rng.choice(["xy", "yz", "zx"]))
        start = forward_kinematics(arm, q)[:3, 3]
        centre = start - radius * np.eye(3)["xyz".index(plane[0])]
        path = circle(centre, radius, plane, float(rng.integers(2, 7)) * 5, _STEPS)
        try:
            run = trace(arm, q, path, method="exact", rates=plain_inverse(1e-4))
        except (SingularError, UnreachableError):
            continue
        report = run.report
        if report.executable and report.smallest_singular_value > _SMALLEST:
            return run, radius, plane
    raise ArmError(f"{arm.name}: no circle that it can draw was found in {_TRIES} tries")


def _static_torque(arm: Arm, rng: Rng) -> tuple[str, dict[str, Answer]]:
    q, force = _pose(arm, rng), np.zeros(3)
    force[rng.integers(3)] = float(rng.choice([-1, 1])) * float(rng.integers(4, 21)) / 2
    question = (
        f"At $q = {_matrix(q)}$ the world acts on the tip with the force ${_matrix(force)}$ N"
        " (base axes)."
        " Which torques hold the arm without it, which with it? Take 9.81 m/s². Masses, and"
        " centres of mass in the"
        f" frames of the table:\n\n{_bodies(arm)}"
    )
    tau = static_torque(arm, q, np.r_[force, 0, 0, 0])
    return question, {
        "g": Answer("the torques that hold the weight (N m)", gravity_torque(arm, q), 0.02),
        "tau": Answer("the torques with the force (N m)", tau, 0.02),
    }


def _inverse_kinematics(arm: Arm, rng: Rng) -> tuple[str, dict[str, Answer]]:
    q = _pose(arm, rng)
    wanted = forward_kinematics(arm, q)[:3] if arm.dof >= 6 else forward_kinematics(arm, q)[:3, 3:]
    columns = wanted.shape[1]
    what = "the pose $[R\\ p]$" if columns == 4 else "the position $p$"
    question = f"Find joint values that give the tip {what} $= {_matrix(wanted.round(4) + 0.0)}$."

    def pose(given: Array) -> Array:
        return forward_kinematics(arm, given)[:3, -columns:]

    return question, {"q": Answer("joint values (rad; m) that give this", wanted, 1e-2, pose)}


_TOPICS: Mapping[str, Callable[[Arm, Rng], tuple[str, dict[str, Answer]]]] = {
    "DH tables": _dh_tables,
    "Jacobian": _jacobian,
    "circle tracing": _circle_tracing,
    "static torque": _static_torque,
    "inverse kinematics": _inverse_kinematics,
}
TOPICS = tuple(_TOPICS)


def _title(topic: str) -> str:
    return topic[0].upper() + topic[1:]


def _bodies(arm: Arm) -> str:
    """The links' masses and centres of mass as a Markdown table."""
    lines = ["| link | mass (kg) | $x$ (m) | $y$ (m) | $z$ (m) |", "|:-:|:-:|:-:|:-:|:-:|"]
    for i, body in enumerate(arm.bodies, 1):
        numbers = [f"{arm.number(entry):.10g}" for entry in (body.mass, *body.com)]
        lines.append(f"| {i} | {' | '.join(numbers)} |")
    return "\n".join(lines)


def _matrix(values: Array) -> str:
    """A vector or a matrix in LaTeX, to four decimals."""
    rows = np.atleast_2d(np.round(values, 4) + 0.0)
    lines = [" & ".join(f"{x:.4g}" for x in row) for row in rows]
    return "\\begin{bmatrix}" + " \\\\ ".join(lines) + "\\end{bmatrix}"
