"""Did my joints draw the path? Judged by the tip that they give, not by the picture."""

from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike, NDArray

from helpers.arm import Arm
from helpers.checks.verdict import Verdict
from helpers.inputs import ArmError, floats, must_be, number
from helpers.kinematics import forward_kinematics
from helpers.motion.paths import Path
from helpers.motion.report import Report, run_report

Array = NDArray[np.float64]

TILT = np.radians(1.0)  # a pen that leans more than this no longer counts as held


@dataclass(frozen=True, repr=False)
class TraceReport(Verdict):
    """What `compare_trace` found; `run` holds every measured figure, `notes` what the real arm
    could not do."""

    arm: str
    findings: tuple[str, ...]
    notes: tuple[str, ...] = ()
    run: Report | None = None

    def __str__(self) -> str:
        verdict = "draws the path" if self.agrees else "does not draw the path"
        notes = [f"- Note: {note}" for note in self.notes]
        return "\n".join([f"{self.arm} {verdict}.", *(f"- {f}" for f in self.findings), *notes])


def compare_trace(mine: ArrayLike, arm: Arm, path: Path, tolerance: float = 2e-3) -> TraceReport:
    """Whether your joint vectors, shape (steps + 1, dof), make the tip follow a path, and if not,
    in what way they fail.

    One row for each of the path's times, or for all but the last. `tolerance` is the largest
    distance (m) from where the tip should be; it may lean by 1 degree. Limits of range and speed
    are notes: the homework's own circle breaks them. Raises ArmError where `mine` holds anything
    but finite numbers.
    """
    must_be(arm, Arm, "arm")
    must_be(path, Path, "path")
    number(tolerance, "tolerance", "a length of 0 m or more", least=0)
    q = floats(mine, f"{arm.name}: what you give for your joints", "numbers")
    if not np.isfinite(q).all():
        raise ArmError(f"{arm.name}: your joints hold NaN or infinity; expected finite numbers")
    counts = (len(path.times), len(path.times) - 1)
    if q.ndim != 2 or q.shape[1] != arm.dof or len(q) not in counts:
        return TraceReport(arm.name, (_shape_finding(q, arm, counts),))
    path = Path(path.times[: len(q)], path.position, path.velocity, path.normal)
    if _off(path, forward_kinematics(arm, np.radians(q))[:, :3, 3]).max() <= tolerance:
        return TraceReport(arm.name, ("The joints are in degrees: write radians.",))
    run = _measured(arm, path, q)
    findings = tuple(_findings(arm, path, q, run, tolerance))
    return TraceReport(arm.name, findings, tuple(_notes(run)), run)


def _shape_finding(q: Array, arm: Arm, counts: tuple[int, int]) -> str:
    if q.ndim == 2 and q.shape[0] == arm.dof and q.shape[1] in counts:
        return "It is transposed: one row per step, one column per joint."
    return (
        f"Its shape is {q.shape}; expected ({counts[0]}, {arm.dof}), one row for each of the"
        " path's times."
    )


def _measured(arm: Arm, path: Path, q: Array) -> Report:
    q_dot = np.diff(q, axis=0) / np.diff(path.times)[:, None]
    return run_report(arm, path, q, np.vstack([q_dot, q_dot[-1:]]), forward_kinematics(arm, q))


def _findings(arm: Arm, path: Path, q: Array, run: Report, tolerance: float) -> Iterator[str]:
    if run.position_error > tolerance:
        tip = forward_kinematics(arm, q)[:, :3, 3]
        cause = next(_causes(path, tip, tolerance), None)
        yield cause or _where(path, tip)
    if run.pen_tilt > TILT:
        words = f"The tool leans by up to {np.degrees(run.pen_tilt):.3g} degrees."
        hint = (
            " Its place is right all the same: look at the angular rows of your Jacobian"
            " (z_{i-1}, not z_i)."
        )
        yield words + (hint if run.position_error <= tolerance else "")


def _off(path: Path, points: Array) -> Array:
    """How far each point is from where the path has it."""
    return np.linalg.norm(points - path.positions, axis=1)


def _causes(path: Path, tip: Array, tolerance: float) -> Iterator[str]:
    """What would explain every point, the likelier first."""

    def follows(points: Array) -> bool:
        return bool(_off(path, points).max() <= tolerance)

    if follows(tip[::-1]):
        yield "The path is drawn the other way round: look at the sign of the velocity."
    shift = (tip - path.positions).mean(axis=0)
    if follows(tip - shift):
        yield (
            f"The whole path is displaced by {_vector(shift)} mm: look at the centre, or at"
            " where you start."
        )
    scale, middle = _scale(path, tip)
    about = path.positions.mean(axis=0)
    if follows(about + (tip - middle) / scale):
        yield f"The path is {scale:.4g} times as large as it should be: look at the radius."
    if any(follows(_rolled(tip, k)) for k in range(1, len(tip) - 1)):
        yield "The right path is drawn, but from another point on: look at the phase."


def _scale(path: Path, tip: Array) -> tuple[float, Array]:
    """The size of the drawn path over that of the wanted one, and the middle of the drawn one."""
    middle = tip.mean(axis=0)
    wanted = path.positions - path.positions.mean(axis=0)
    return float(np.linalg.norm(tip - middle) / np.linalg.norm(wanted)), middle


def _rolled(tip: Array, k: int) -> Array:
    """A closed path's points, its last one equal to its first, begun k steps later."""
    once = np.roll(tip[:-1], k, axis=0)
    return np.vstack([once, once[:1]])


def _where(path: Path, tip: Array) -> str:
    error = _off(path, tip)
    k = int(error.argmax())
    start = " already" if error[0] > 0.5 * error[k] else f" {1e3 * error[0]:.3g} mm"
    return (
        f"The tip is up to {1e3 * error[k]:.4g} mm from where it should be, at step {k} of"
        f" {len(error) - 1};"
        f" at the start it is{start} off."
    )


def _vector(metres: Array) -> str:
    return "(" + ", ".join(f"{x:.3g}" for x in np.round(1e3 * metres, 3) + 0.0) + ")"


def _notes(run: Report) -> Iterator[str]:
    for excess, what in ((run.beyond_limits, "range"), (run.beyond_speed, "speed")):
        if excess:
            joints = ", ".join(f"joint {i} by {x:.2g}" for i, x in excess)
            yield (
                f"beyond the real arm's {what}: {joints}"
                f" ({'rad' if what == 'range' else 'rad/s'}; m where a joint slides)."
            )
