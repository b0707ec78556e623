"""What the usual mistakes make of an answer: the numbers that a mark is measured against.

Every single slip of a table (`helpers.slips`) and the others that were met in homework: each is
made, and the whole answer computed with it.
"""

from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import suppress
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from helpers import slips
from helpers.arm import Arm, Body
from helpers.inputs import ArmError
from helpers.kinematics import forward_kinematics, link_frames
from helpers.motion import SingularError
from helpers.statics import gravity_torque, static_torque

Array = NDArray[np.float64]
Given = Mapping[str, Any]
Answers = Mapping[str, Array]
Solve = Callable[[Arm, Given], Answers]

_SEEN = 1e-9  # a difference below is rounding
_SHORT = 9.8 / 9.81
_ENTRIES = {"a": "a", "alpha": "α", "d": "d", "theta": "θ"}


class Slip(NamedTuple):
    """A mistake in words, and what it makes of the answers that it changes, by their names."""

    words: str
    answers: Answers


def made(arm: Arm, given: Given, solve: Solve) -> tuple[Slip, ...]:
    """Every slip that changes an answer to a question with a pose; `solve` answers it rightly."""
    right = solve(arm, given)
    found = [*_computed(arm, given, solve), *_others(arm, given, right)]
    seen = (
        Slip(words, {n: x for n, x in answers.items() if np.abs(x - right[n]).max() > _SEEN})
        for words, answers in found
    )
    return tuple(slip for slip in seen if slip.answers)


def _computed(arm: Arm, given: Given, solve: Solve) -> Iterator[Slip]:
    """What comes of another table or other joint values, where that comes to an end."""
    q = np.array(given["q"])
    wrong = [(_named(slip), *slips.apply_slip(arm, q, slip)) for slip in slips.list_slips(arm)]
    degrees = np.where(arm.turning, np.radians(q), q)
    for words, other, there in [*wrong, ("angles taken as degrees", arm, degrees)]:
        with suppress(ArmError, SingularError):
            yield Slip(words, solve(other, {**given, "q": there}))


def _named(slip: slips.TableSlip) -> str:
    if slip.entry == "q":
        return f"joint {slip.row} counted the other way"
    how = "with the other sign" if slip.value else "left out"
    return f"{_ENTRIES[slip.entry]} in row {slip.row} {how}"


def _others(arm: Arm, given: Given, right: Answers) -> Iterator[Slip]:
    q = np.array(given["q"])
    yield Slip("zeros throughout", {name: 0 * x for name, x in right.items()})
    if "p" in right:
        yield Slip("millimetres for metres", {"p": 1000 * right["p"]})
        yield Slip("the transpose, the base seen from the tip", {"R": right["R"].T})
    if "q_dot" in given:
        for words, wrong in _jacobians(arm, q, right["J"]):
            yield Slip(words, {"J": wrong, "xi": wrong @ np.array(given["q_dot"])})
    if "force" in given:
        yield from _torques(arm, q, np.r_[given["force"], 0, 0, 0], right)
    if "radius" in given:
        yield from _circles(given, right)


def _jacobians(arm: Arm, q: Array, J: Array) -> Iterator[tuple[str, Array]]:
    turning, frames = arm.turning, link_frames(arm, q)
    axes = frames[np.array(arm.joints) - 1, :3, 2].T
    R, p = (part for part in np.split(forward_kinematics(arm, q)[:3], [3], axis=1))
    angular, linear = np.r_[-np.ones(3), np.ones(3)][:, None], J[3:]
    yield "linear and angular rows exchanged", np.r_[linear, J[:3]]
    yield "every sign the other way round", -J
    yield "the angular rows with the other sign", -J * angular
    yield "z_0 for every axis in the angular rows", np.r_[J[:3], turning * np.c_[[0.0, 0, 1]]]
    yield (
        "the arm from the base, p_n, for that from the joint, p_n - p_(i-1)",
        np.r_[np.where(turning, np.cross(axes.T, p.T).T, axes), linear],
    )
    yield "in the tip's axes, not the base's", np.r_[R.T @ J[:3], R.T @ linear]


def _torques(arm: Arm, q: Array, wrench: Array, right: Answers) -> Iterator[Slip]:
    g, pushed = right["g"], static_torque(arm, q, wrench)
    push = pushed - g
    at_frames = arm.with_bodies([Body(body.mass, (0, 0, 0)) for body in arm.bodies])
    central = gravity_torque(at_frames, q)
    for link, body in enumerate(arm.bodies, 1):
        less = gravity_torque(arm.with_bodies([*_without(arm.bodies, body)]), q)
        yield Slip(f"link {link} without its mass", {"g": less, "tau": less + push})
    yield Slip("every sign the other way round", {"g": -g, "tau": -pushed})
    yield Slip("9.8 for 9.81 m/s²", {"g": g * _SHORT, "tau": g * _SHORT + push})
    yield Slip("masses at the frames' origins", {"g": central, "tau": central + push})
    yield Slip("the force with the other sign", {"tau": g - push})
    yield Slip("the force left out", {"tau": g})
    yield Slip("the weight left out", {"tau": push})


def _without(bodies: Sequence[Body], left_out: Body) -> Iterator[Body]:
    yield from (Body(0, body.com) if body is left_out else body for body in bodies)


def _circles(given: Given, right: Answers) -> Iterator[Slip]:
    start = 2 * _start(given, right) - right["centre"]
    yield Slip("the centre on the other side of the start", {"centre": start})
    yield Slip("the start taken for the centre", {"centre": _start(given, right)})
    yield Slip("drawn the other way round", {"quarter": right["three quarters"]})
    start_q = np.array(given["q"])
    yield Slip("the joints at the start", {"quarter": start_q, "half": start_q})


def _start(given: Given, right: Answers) -> Array:
    first = np.eye(3)["xyz".index(given["plane"][0])]
    return right["centre"] + given["radius"] * first
