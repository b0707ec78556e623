"""Define the arms of the homework, with the source of each number.

The homework's arms carry a 0.1 m pen; ``arm.with_values(l_pen=0)`` takes it off. `PANDA` and
`UR10E` have the makers' lengths, `PANDA_HOMEWORK` and `UR10E_HOMEWORK` those of the assignment.
"""

import warnings
from collections.abc import Iterable
from dataclasses import replace
from math import pi
from typing import Any

from helpers.arm import Arm, ArmError, Body, CircleTask, prismatic, revolute
from helpers.inputs import require_choice, require_type, tuple_of_items

__all__ = [
    "ARMS",
    "ELBOW",
    "PANDA",
    "PANDA_HOMEWORK",
    "PLANAR_ARMS",
    "STANFORD",
    "THREE_LINK",
    "TWO_LINK",
    "UR10E",
    "UR10E_HOMEWORK",
    "find_arm",
    "restore_lengths",
]

#: The Panda with the maker's lengths, limits and the masses of Gaz et al., and the homework's pen.
PANDA = Arm(
    name="Panda",
    # The maker's limits, with the signs of this table: q_maker = (q1, -q2, q3, -q4, q5, q6, -q7).
    rows=(
        revolute(alpha="pi/2", d="d_1", limits=(-2.8973, 2.8973), speed=2.175, effort=87),
        revolute(alpha="-pi/2", limits=(-1.7628, 1.7628), speed=2.175, effort=87),
        revolute(a="a_3", alpha="-pi/2", d="d_3", limits=(-2.8973, 2.8973), speed=2.175, effort=87),
        revolute(a="-a_3", alpha="pi/2", limits=(0.0698, 3.0718), speed=2.175, effort=87),
        revolute(alpha="pi/2", d="d_5", limits=(-2.8973, 2.8973), speed=2.61, effort=12),
        revolute(a="a_6", alpha="-pi/2", limits=(-0.0175, 3.7525), speed=2.61, effort=12),
        revolute(d="-(d_7 + l_pen)", limits=(-2.8973, 2.8973), speed=2.61, effort=12),
    ),
    values=dict(d_1=0.333, d_3=0.316, a_3=0.0825, d_5=0.384, a_6=0.088, d_7=0.107, l_pen=0.1),
    # From Gaz et al. (2019), with centres of mass converted to the frames of this table.
    bodies=(
        Body(4.970684, (0.003875, -0.04762, -0.002081)),
        Body(0.646926, (-0.003141, 0.003495, 0.02872)),
        Body(3.228604, ("0.027518 - a_3", 0.066502, 0.039252)),
        Body(3.587895, ("a_3 - 0.05317", -0.027454, 0.104419)),
        Body(1.225946, (-0.011953, -0.038437, -0.041065)),
        Body(1.666555, ("0.060149 - a_6", 0.010517, -0.014117)),
        Body(0.735522, (0.010517, 0.004252, "d_7 + l_pen - 0.061597")),
    ),
    home=(0, 0, 0, pi / 2, 0, pi, 0),
    source="Franka Emika, Robot and interface specifications; masses: Gaz et al. (2019),"
    " hal-02265293, supplementary material hal-02265294; joints 2, 4 and 7 count against the"
    " maker's, the tip is that of a 0.1 m pen, and the bodies have no inertia tensors",
    circle=CircleTask(normal="x", seconds=5, locked_joint=3),
)

#: The Panda of the homework's table, in which a_3 is 88 mm too.
PANDA_HOMEWORK = replace(
    PANDA.with_values(a_3=0.088),
    name="Panda (homework)",
    source="The homework's table, which uses 88 mm for both a_3 and a_6; the rest as PANDA",
)

# The UR10e's home is singular, so the plain inverse of J fails there.
_UR_CIRCLE = CircleTask(normal="y", seconds=20, rates="pseudo")

# The maker's ranges, speeds and torques of the UR10e, for both tables.
_UR_RANGE = (-2 * pi, 2 * pi)
_UR_BIG: dict[str, Any] = dict(limits=_UR_RANGE, speed=2 * pi / 3, effort=330)
_UR_ELBOW: dict[str, Any] = dict(limits=_UR_RANGE, speed=pi, effort=150)
_UR_WRIST: dict[str, Any] = dict(limits=_UR_RANGE, speed=pi, effort=56)

#: The UR10e with the maker's lengths, limits and masses, and the homework's pen.
UR10E = Arm(
    name="UR10e",
    rows=(
        revolute(alpha="pi/2", d="d_1", **_UR_BIG),
        revolute(a="-a_2", **_UR_BIG),
        revolute(a="-a_3", **_UR_ELBOW),
        revolute(alpha="pi/2", d="d_4", **_UR_WRIST),
        revolute(alpha="-pi/2", d="d_5", **_UR_WRIST),
        revolute(d="d_6 + l_pen", **_UR_WRIST),
    ),
    values=dict(
        d_1=0.1807, a_2=0.6127, a_3=0.57155, d_4=0.17415, d_5=0.11985, d_6=0.11655, l_pen=0.1
    ),
    bodies=(
        Body(7.369, (0.021, 0, 0.027)),
        Body(13.051, (0.38, 0, 0.158)),
        Body(3.989, (0.24, 0, 0.068)),
        Body(2.1, (0, 0.007, 0.018)),
        Body(1.98, (0, 0.007, 0.018)),
        Body(0.615, (0, 0, "-0.026 - l_pen")),
    ),
    home=(0, -pi / 2, 0, -pi / 2, 0, 0),
    source="Universal Robots, DH parameters for calculations of kinematics and dynamics (table,"
    " masses);"
    " UR10e user manual (ranges, speeds); Max. joint torques (torques)",
    circle=_UR_CIRCLE,
)

#: The UR10e with the lengths of the homework.
UR10E_HOMEWORK = Arm(
    name="UR10e (homework)",
    rows=(
        revolute(alpha="-pi/2", d="d_1", **_UR_BIG),
        revolute(a="a_2", alpha="pi", theta="-pi/2", **_UR_BIG),
        revolute(a="a_3", alpha="pi", **_UR_ELBOW),
        revolute(alpha="pi/2", d="d_4", theta="pi/2", **_UR_WRIST),
        revolute(alpha="-pi/2", d="d_5", **_UR_WRIST),
        revolute(d="d_6 + l_pen", **_UR_WRIST),
    ),
    values=dict(d_1=0.128, a_2=0.6127, a_3=0.5716, d_4=0.1639, d_5=0.1157, d_6=0.0922, l_pen=0.1),
    source="The homework's table: the UR10's lengths as its CB3 manual prints them, but for d_1"
    " (0.118 there)",
    circle=_UR_CIRCLE,
)

#: The Stanford arm with a shoulder of two joints, a sliding rod and a spherical wrist.
STANFORD = Arm(
    name="Stanford arm",
    rows=(
        revolute(alpha="-pi/2"),
        revolute(alpha="pi/2", d="d_2"),
        prismatic(limits=(0.1, 1.0)),
        revolute(alpha="-pi/2"),
        revolute(alpha="pi/2"),
        revolute(d="d_6"),
    ),
    values=dict(d_2=0.154, d_6=0.263),
    home=(0, 0, 0.5, 0, 0, 0),
    source="Spong, Hutchinson and Vidyasagar, Robot Modeling and Control, example 3.5; lengths:"
    " Scheinman's arm",
)

#: An elbow arm of three joints, as textbooks draw it.
ELBOW = Arm(
    name="Elbow arm",
    rows=(
        revolute(alpha="pi/2", d="d_1"),
        revolute(a="a_2", d="-d"),
        revolute(a="a_3"),
    ),
    values=dict(d_1=0.5, a_2=0.4, a_3=0.3, d=0.0),
    home=(0, pi / 4, -pi / 2),
    source="Spong, Hutchinson and Vidyasagar, Robot Modeling and Control, section 5.3; the lengths"
    " are ours",
)

#: A planar arm of two links, the first example of most textbooks.
TWO_LINK = Arm(
    name="Two links",
    rows=(revolute(a="a_1"), revolute(a="a_2")),
    values=dict(a_1=0.5, a_2=0.4),
    home=(pi / 6, pi / 4),
    source="Spong, Hutchinson and Vidyasagar, Robot Modeling and Control, example 3.1; the"
    " lengths are ours",
)

#: A planar arm of three links, which reaches a point of its plane at any angle phi.
THREE_LINK = Arm(
    name="Three links",
    rows=(revolute(a="a_1"), revolute(a="a_2"), revolute(a="a_3")),
    values=dict(a_1=0.5, a_2=0.4, a_3=0.2),
    home=(pi / 6, pi / 4, -pi / 3),
    source="Siciliano et al., Robotics: Modelling, Planning and Control, section 2.9.1; the lengths"
    " are ours",
)

#: Arms that move in one plane.
PLANAR_ARMS = (TWO_LINK, THREE_LINK)

#: All arms of the catalogue, which have an answer sheet each.
ARMS = (PANDA, PANDA_HOMEWORK, UR10E, UR10E_HOMEWORK, STANFORD, ELBOW)


def find_arm(name: str) -> Arm:
    """Find an arm of the catalogue by its name, in small or capital letters.

    Raises:
        ArmError: No arm has this name; the message lists all names.

    Example:
        >>> find_arm("stanford arm")
        <Arm Stanford arm: 6 rows, RRPRRR>
    """
    arms = (*ARMS, *PLANAR_ARMS)
    for arm in arms:
        if arm.name.casefold() == str(name).casefold():
            return arm
    raise ArmError(f"no arm is called {name!r}; expected one of {', '.join(a.name for a in arms)}")


def restore_lengths(arm: Arm, names: Iterable[str]) -> Arm:
    """Replace lengths of 0 by those of the catalogue, with a warning.

    Chapters call it where their argument needs a length, so that they go on with a changed arm.

    Args:
        arm: An arm of the catalogue, with any values.
        names: The lengths that must not be 0.

    Raises:
        ArmError: The arm is none of the catalogue, or has no such length.

    Example:
        >>> restore_lengths(ELBOW, ["a_2"]) == ELBOW
        True
    """
    require_type(arm, Arm, "arm")
    names = tuple_of_items(names, "names", "symbols of the arm, such as a_2")
    book_values = find_arm(arm.name).values
    for name in names:
        require_choice(name, "names", book_values)
    missing = {name: book_values[name] for name in names if not arm.values[name]}
    if missing:
        lengths = ", ".join(f"{name} = {value:g}" for name, value in missing.items())
        warnings.warn(
            f"{arm.name}: what follows needs {' and '.join(missing)} other than 0; it goes on with"
            f" {lengths} m",
            stacklevel=2,
        )
    return arm.with_values(**missing)
