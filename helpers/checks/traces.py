"""Did my joints draw the path? Judged by the tip that they give, and by how they move, not by the
picture.
"""

from collections.abc import Iterator
from dataclasses import replace
from typing import Any

import numpy as np
from numpy.typing import NDArray

from helpers.arm import Arm
from helpers.checks import door
from helpers.checks.digits import RIGHT, WRONG, Typed
from helpers.checks.ranking import Cause, cause, lower
from helpers.checks.traces_causes import holds, loop_cause, near, offs, path_cause, table_cause
from helpers.checks.verdict import Finding, Report
from helpers.inputs import must_be
from helpers.kinematics import forward_kinematics, jacobian
from helpers.motion.paths import Path
from helpers.motion.report import run_report
from helpers.reading.sentences import listed, millimetres, say, size

Array = NDArray[Any]

TILT = np.radians(1.0)  # a tool that leans or spins more than this no longer counts as held
_USUAL = 2e-3  # m: Euler's method on the homework's circle stays well below
_BESIDES = ("trace.one more", "trace.jump")  # mistakes of their own, whatever else is wrong
_LOOP_FIRST = ("trace.coarse", "trace.millimetres", "J.millimetres")  # whatever shape it gives
_JUMP = 0.3  # rad or m in one step, and ten times the usual one: another branch
_NO_INVERSE = 1e-9  # of the largest singular value: a smaller one is a zero
_ALIKE = 1e-9  # m: errors nearer to each other than this are the same


def compare_trace(
    mine: object, arm: Arm, path: Path, tolerance: float | None = None, *, angles: str = "rad"
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

    Limits of range and speed are notes: the homework's own circle breaks them. Where joints jump by
    whole turns they are counted on, which is a note too. Raises ArmError where `mine` holds
    anything but finite numbers.
    """
    must_be(arm, Arm, "arm")
    must_be(path, Path, "path")
    tolerance = door.settings(angles, tolerance)
    typed = door.numbers(mine, f"{arm.name}: your joints")
    upright = _upright(typed, arm, path)
    if not upright:
        return _misshapen(typed.values, arm, path)
    typed, taken, extra = upright
    if angles == "deg":
        typed = door.in_radians(typed, arm)
    q = typed.values
    path = replace(path, times=path.times[: len(q)])
    blur = _blur(typed, arm)
    allowed = _USUAL + blur if tolerance is None else tolerance
    if angles == "rad" and _only_as_degrees(typed, arm, path, allowed):
        return _degrees(arm, taken)
    return _judged(typed, arm, path, allowed, blur, tolerance is not None, taken, extra)


def _upright(typed: Typed, arm: Arm, path: Path) -> tuple[Typed, tuple[str, ...], bool] | None:
    """A row per step: columns turned round, a leading column of times or zeros dropped, one step
    too many cut, and said; None for another shape.
    """
    M, steps = np.squeeze(typed.values), np.squeeze(typed.units)
    if M.ndim != 2:
        return None
    said: tuple[str, ...] = ()
    rows = (len(path.times) - 1, len(path.times), len(path.times) + 1)
    if M.shape[1] != arm.dof and M.shape[0] in (arm.dof, arm.dof + 1) and M.shape[1] in rows:
        M, steps, said = M.T, steps.T, (say("taken: list per joint"),)
    if M.shape[1] == arm.dof + 1 and (not M[:, 0].any() or (np.diff(M[:, 0]) > 0).all()):
        M, steps, said = M[:, 1:], steps[:, 1:], (*said, say("taken: times"))
    if M.shape[1] != arm.dof or len(M) not in rows or len(M) < 2:
        return None
    extra = len(M) == len(path.times) + 1
    return Typed(M[: len(path.times)], steps[: len(path.times)]), said, extra


def _only_as_degrees(typed: Typed, arm: Arm, path: Path, allowed: float) -> bool:
    """Whether joints follow the path in degrees, as nearly as Euler's method does, and not in
    radians.
    """
    turned = door.in_radians(typed, arm)
    as_typed, in_degrees = (
        offs(path, forward_kinematics(arm, q)[:, :3, 3]) for q in (typed.values, turned.values)
    )
    most, left = float(as_typed.max()), float(in_degrees.max())
    if most <= allowed or left >= most:
        return False
    return left <= near(path, most, allowed) or (_begun(in_degrees) and holds(turned, arm, path))


def _begun(off: Array) -> bool:
    """Whether a run so far off its path begins on it: its other points are four times as far."""
    return bool(off[0] <= off.max() / 4)


def _misshapen(M: Array, arm: Arm, path: Path) -> Report:
    shape = "x".join(map(str, M.shape)) or "1"
    words = say("trace.shape", shape=shape, rows=len(path.times), dof=arm.dof)
    return _report(
        arm,
        WRONG,
        lower(words),
        (Finding("shape", "", M.shape, None, words),),
        ("trace.shape",),
        (),
    )


def _degrees(arm: Arm, taken: tuple[str, ...]) -> Report:
    words = say("trace.degrees")
    return _report(
        arm,
        WRONG,
        lower(words),
        (Finding("cause", "", None, None, words),),
        ("trace.degrees",),
        taken,
    )


def _report(arm: Arm, grade: str, words: str, findings, causes, taken, *rest) -> Report:
    key = "trace right" if grade == RIGHT else "trace wrong"
    headline = say(key, arm=arm.name, cause=words)
    return Report("trace", arm.name, grade, headline, tuple(findings), tuple(causes), taken, *rest)


# The verdict


def _judged(
    typed: Typed,
    arm: Arm,
    path: Path,
    allowed: float,
    blur: float,
    given: bool,
    taken,
    extra: bool,
) -> Report:
    typed, turned = _unwound(typed, arm)
    q = typed.values
    poses = forward_kinematics(arm, q)
    q_dot = np.diff(q, axis=0) / np.diff(path.times)[:, None]
    run = run_report(arm, path, q, np.vstack([q_dot, q_dot[-1:]]), poses)
    turn = _turns(poses) if arm.dof >= 6 else np.zeros(len(q))
    jumps = _jumps(q)
    stuck = _no_inverse(q, arm, jumps)
    off = offs(path, poses[:, :3, 3])
    jump = [] if stuck or not jumps.size else [_jump(q, arm, jumps, bool((off <= allowed).all()))]
    symptoms = list(_symptoms(arm, path, run, poses, turn, allowed, jump))
    if extra:
        symptoms.append(Finding("trace.one more", "", None, None, say("trace.one more")))
    reeled = bool(turn.max() > TILT)
    named = stuck
    if symptoms and not stuck:
        named = _named(typed, arm, path, poses[:, :3, 3], reeled, bool(jump), allowed, blur)
    elif not given and not stuck:
        named = loop_cause(typed, arm, path, False)
    figures = {"run": run, "position_error": run.position_error, "tool_turn": float(turn.max())}
    notes = (*turned, *(() if stuck else _notes(run)))
    if named is None and not symptoms:
        return _report(arm, RIGHT, "", (), (), taken, notes, figures)
    if named is None:
        words = lower(symptoms[0].words)
        causes = [f.what for f in symptoms if "." in f.what]
        first, *rest = symptoms
        findings = [Finding("cause", first.where, None, None, first.words), *rest]
        return _report(arm, WRONG, words, findings, causes, taken, notes, figures)
    if named.name == "trace.millimetres":
        symptoms = [
            f for f in symptoms if f not in jump
        ]  # steps as long as these jump of themselves
    findings = [Finding("cause", "", None, None, f"{named.words}."), *symptoms]
    causes = [named.name, *(f.what for f in symptoms if f.what in _BESIDES)]
    return _report(arm, WRONG, f"{lower(named.words)}.", findings, causes, taken, notes, figures)


def _named(
    typed: Typed,
    arm: Arm,
    path: Path,
    tip: Array,
    reeled: bool,
    jumped: bool,
    allowed: float,
    blur: float,
) -> Cause | None:
    """What explains a run that fails; of one that jumps, never that each of its steps is right."""
    off = offs(path, tip)
    away = bool(off.max() > allowed)
    strays = (away and _begun(off)) or reeled
    loop = loop_cause(typed, arm, path, strays and not jumped)
    if not away or (loop and loop.name in _LOOP_FIRST):
        return loop
    shape = path_cause(path, tip, allowed, blur)
    if shape and shape.name != "trace.displaced":
        return shape
    return table_cause(typed.values, arm, path, allowed) or shape or loop


def _blur(typed: Typed, arm: Arm) -> float:
    """What the digits of the joints leave of the tip's place (m)."""
    J = jacobian(arm, typed.values[:: max(1, len(typed.values) // 20)])[:, :3]
    return float(np.linalg.norm(np.abs(J) @ (0.51 * typed.units.max(axis=0)), axis=1).max())


def _turns(poses: Array) -> Array:
    """How far (rad) each pose is turned from the first."""
    R = np.einsum("ji,njk->nik", poses[0, :3, :3], poses[:, :3, :3])
    off = np.stack([R[:, 2, 1] - R[:, 1, 2], R[:, 0, 2] - R[:, 2, 0], R[:, 1, 0] - R[:, 0, 1]])
    return np.arctan2(np.linalg.norm(off, axis=0), np.trace(R, axis1=1, axis2=2) - 1)


def _symptoms(
    arm: Arm, path: Path, run, poses: Array, turn: Array, allowed: float, jump: list[Finding]
) -> Iterator[Finding]:
    if run.position_error > allowed:
        yield Finding("step", "", None, None, _where(path, poses[:, :3, 3]))
    yield from jump
    if arm.dof >= 6 and run.pen_tilt > TILT:
        words = say("trace leans", degrees=size(float(np.degrees(run.pen_tilt))))
        yield Finding("trace.leans", "", None, None, words)
    elif turn.max() > TILT:
        words = say("trace spins", degrees=size(float(np.degrees(turn.max()))))
        yield Finding("trace.spins", "", None, None, words)


def _jumps(q: Array) -> Array:
    """The steps that change a joint by far more than usual, or all large ones where many do."""
    change = np.abs(np.diff(q, axis=0)).max(axis=1)
    far = np.flatnonzero((change > _JUMP) & (change > 10 * np.median(change)))
    if not far.size and np.median(change) > _JUMP:
        far = np.flatnonzero(change > _JUMP)
    return far


def _unwound(typed: Typed, arm: Arm) -> tuple[Typed, tuple[str, ...]]:
    """Joints that turn counted on where they jump by whole turns, as angles of atan2 do, and said;
    untouched where other jumps are left.
    """
    q = typed.values
    turns = np.where(arm.turning, np.round(np.diff(q, axis=0) / (2 * np.pi)), 0.0)
    counted = q - 2 * np.pi * np.vstack([np.zeros(q.shape[1]), np.cumsum(turns, axis=0)])
    steps = np.flatnonzero(turns.any(axis=1))
    if not steps.size or _jumps(counted).size:
        return typed, ()
    k = int(steps[0])
    joint = arm.joints[int(turns[k].nonzero()[0][0])]
    words = say("trace whole turn", step=k, to=k + 1, joint=joint, count=steps.size)
    return replace(typed, values=counted), (words,)


def _jump(q: Array, arm: Arm, jumps: Array, on: bool) -> Finding:
    """The first jump; to another branch only where the tip stays `on` its path."""
    fields = _jumping(q, arm, int(jumps[0]))
    key = "trace.jump" if on else "trace jump off"
    words = say(key, to=fields["step"] + 1, count=jumps.size, **fields)
    return Finding("trace.jump", f"step {fields['step']}", None, None, words)


def _jumping(q: Array, arm: Arm, k: int) -> dict[str, Any]:
    change = np.abs(q[k + 1] - q[k])
    return dict(step=k, joint=arm.joints[int(change.argmax())], by=size(float(change.max())))


def _no_inverse(q: Array, arm: Arm, jumps: Array) -> Cause | None:
    """The first jump, where it begins at a pose whose Jacobian has no inverse."""
    if not jumps.size:
        return None
    k = int(jumps[0])
    J = jacobian(arm, q[k])[: 6 if arm.dof >= 6 else 3]
    sizes = np.linalg.svd(J, compute_uv=False)
    rank = int((sizes > _NO_INVERSE * sizes[0]).sum())
    if rank == len(J) or arm.dof < len(J):
        return None
    fields = _jumping(q, arm, k)
    step, words = fields.pop("step"), {f"_{n}": x for n, x in fields.items()}
    return cause("trace.no inverse", step=step, _rank=rank, _rows=len(J), **words)


def _where(path: Path, tip: Array) -> str:
    """The farthest point, the first of those that are equally far."""
    error = offs(path, tip)
    k = int((error >= error.max() - _ALIKE).argmax())
    start = say("already") if error[0] > 0.5 * error[k] else f"{millimetres(error[0])} mm"
    return say(
        "trace where",
        error=millimetres(error[k], 4),
        step=k,
        steps=len(error) - 1,
        start=start,
    )


def _notes(run) -> Iterator[str]:
    for excess, what, per in ((run.beyond_limits, "range", ""), (run.beyond_speed, "speed", "/s")):
        if excess:
            fields = [dict(joint=i, by=size(x, 2), unit=run.unit(i) + per) for i, x in excess]
            yield say(f"trace beyond {what}", joints=listed([say("joint by", **x) for x in fields]))
