"""The rows of a derived table in words, as one would tell them at the board."""

import math
from collections.abc import Sequence
from dataclasses import replace

from helpers.derive.values import Axis, Step

NEARLY = 1e-3  # axes whose angle's sine is below this are called nearly parallel


def told(steps: Sequence[Step], axes: Sequence[Axis]) -> list[Step]:
    """The steps with their words."""
    told, count = [], 0
    for step in steps:
        moves = step.joint.kind != "fixed"
        count += moves
        here = axes[count - 1] if moves else None
        there = axes[count] if count < len(axes) else None
        words = [_what_moves(step, count, here), _where_next(step, count, there), _how(step, there)]
        told.append(replace(step, words=" ".join([*words, _numbers_of(step)])))
    return told


def _what_moves(step: Step, joint: int, axis: Axis | None) -> str:
    z = f"z_{step.number - 1}"
    if axis is not None:
        way = "turns about" if axis.joint.kind == "revolute" else "slides along"
        return f"Joint {joint} {way} {z}."
    start = "the base frame to the first axis" if not joint else "the last common normal to the tip"
    return f"Nothing moves in this row: it leads from {start}."


def _where_next(step: Step, joint: int, axis: Axis | None) -> str:
    z = f"z_{step.number}"
    if axis is None:
        return f"{z} is the tip's own."
    if axis.joint.kind == "revolute":
        return f"{z} is laid on the axis of joint {joint + 1}."
    laid = "as it is drawn" if axis.point is not None else "through what comes after it"
    return (
        f"{z} points the way joint {joint + 1} slides; a slide has no place of its own, and"
        f" this one is laid {laid}."
    )


def _how(step: Step, axis: Axis | None) -> str:
    i, before = step.number, step.number - 1
    at_rest = f"d_{i} = 0" if step.joint.kind != "prismatic" else f"d_{i} = 0 at q_{i} = 0"
    level = f"o_{before}, which makes {at_rest}" if axis is not None else "the tip"
    over = f" z_{i} points against z_{before}." if step.opposite else ""
    if step.case == "parallel":
        return (
            f"It is parallel to z_{before}, {abs(step.a):g} m away, so every common normal will"
            f" do: x_{i} runs along the"
            f" one that is level with {level}{_against(step)}.{over}"
        )
    if step.case == "coincident":
        kept = (
            f"x_{i} keeps the direction of x_{before}" if not step.theta else f"x_{i} is the tip's"
        )
        return (
            f"It is the same line as z_{before}: there is no common normal, {kept}, and o_{i}"
            f" lies in {level}.{over}"
        )
    nearly = nearly_parallel(step)
    nearly = f" The two {nearly}." if nearly else ""
    if step.case == "skew":
        return (
            f"It passes z_{before} at a distance: x_{i} runs along the common normal,"
            f" {abs(step.a):g} m long, from"
            f" z_{before} to z_{i}{_against(step)}, and o_{i} lies where the normal meets"
            f" z_{i}.{nearly}"
        )
    return (
        f"It meets z_{before} in o_{i}, so a_{i} = 0; x_{i} is perpendicular to both, the way that"
        f" turns less from x_{before} (z_{before} x z_{i} where both turn as much).{nearly}"
    )


def _against(step: Step) -> str:
    if step.a > 0:
        return ""
    return (
        f" but the other way round, since that turns less from x_{step.number - 1}:"
        f" a_{step.number} is negative"
    )


def nearly_parallel(step: Step) -> str:
    """What is wrong with two axes that are parallel but for rounding; nothing of others."""
    tilt = abs(math.sin(step.alpha))
    if tilt > NEARLY or step.case in ("parallel", "coincident"):
        return ""
    return (
        f"are within {math.degrees(tilt):.2g}° of parallel, so the last digits of that"
        f" angle say where their common normal is (d_{step.number} = {step.d:.6g} m); a tolerance"
        f" above {tilt:.1g} takes them for parallel"
    )


def _numbers_of(step: Step) -> str:
    i, q = step.number, f"q_{step.number}"
    theta = f"{math.degrees(step.theta):g}°"
    d = f"{step.d:g} m" if step.d else "0"
    if step.joint.kind == "revolute":
        theta = f"{q} + {theta}".replace("+ -", "- ") if step.theta else q
    if step.joint.kind == "prismatic":
        d = f"{q} + {d}".replace("+ -", "- ") if step.d else q
    a = f"{step.a:g} m" if step.a else "0"
    return (
        f"So a_{i} = {a}, alpha_{i} = {math.degrees(step.alpha):g}°, d_{i} = {d}, theta_{i} ="
        f" {theta}."
    )
