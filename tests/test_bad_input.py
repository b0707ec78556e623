"""Every public function with every kind of bad input: an ArmError that says what was given and what was expected.

The functions are found by introspection, so a new one without a row in the table fails here, and so does a new argument.
Each row is a call that works; each of its arguments has a kind, and each kind the ways in which people get it wrong.
"""

import importlib
import inspect
import pkgutil
import re
from functools import partial

import matplotlib as mpl
import numpy as np
import pytest
import sympy as sp
from matplotlib.figure import Figure

import helpers
from helpers import (
    arm,
    checks,
    conventions,
    derive,
    ellipsoids,
    explorer,
    expressions,
    inverse,
    kinematics,
    motion,
    plotting,
    robots,
    statics,
    symbolic,
    urdf,
    variants,
)
from helpers.arm import Arm, ArmError, Body, Row, revolute
from helpers.robots import ELBOW, PANDA, PANDA_HOMEWORK, STANFORD, UR10E

NAN, INFINITY = float("nan"), float("inf")
SIX = PANDA_HOMEWORK.lock(3)
BEND = [0.3, 0.4, -0.9]
REACH = kinematics.forward_kinematics(UR10E, [0.4, -1.2, 1.3, -1.2, -1.2, 0.3])
ROD_POSE = kinematics.forward_kinematics(STANFORD, [0.4, 0.7, 0.5, 0.3, 0.6, 0.2])
WRISTED = Arm(
    "elbow with a wrist",
    [
        revolute(alpha="pi/2", d=0.5),
        revolute(a=0.4),
        revolute(alpha="pi/2"),
        revolute(alpha="-pi/2", d=0.3),
        revolute(alpha="pi/2"),
        revolute(d=0.1),
    ],
)
ROD = Arm("rod", STANFORD.rows[:3], dict(d_2=0.154))
HEAVY = PANDA.lock(3).lock(5).lock(6)
WRISTED_POSE = kinematics.forward_kinematics(WRISTED, [0.1, 0.2, 0.3, 0.4, 0.5, 0.6])
PATH = motion.circle([0.5, 0, 0.6], 0.05, "yz", 5.0, 4)
RUN = motion.trace(
    SIX, [0.1, 0.2, 1.4, 0.3, 1.6, 0.2], PATH, method="exact", rates=motion.damped(0.1)
)
FOUND = inverse.ur(UR10E, REACH)
POINT = kinematics.forward_kinematics(ELBOW, BEND)[:3, 3]
FRAMES = kinematics.link_frames(PANDA, PANDA.home)
PLANES = {
    "one letter": "x",
    "a letter twice": "yy",
    "another letter": "xw",
    "a number": 3,
    "None": None,
}


# Kinds of argument, each with the ways to get it wrong


def no(kind):
    """What stands where an object of some kind should."""
    others = {"None": None, "a name": "Panda", "a number": 6, "a list": [[0, 0, 0, 0]]}
    return {f"no {kind}: {what}": value for what, value in others.items()}


def array(*shape, batch=False):
    """What stands where an array of finite numbers should; with `batch`, leading axes are fine."""
    right = np.full(shape, 0.1)
    bad = {
        "None": None,
        "words": "start",
        "digits as text": np.full(shape, "1"),
        "complex numbers": right + 1j,
        "formulas": np.full(shape, sp.Symbol("x")),
        "NaN": _with(right, NAN),
        "infinity": _with(right, -INFINITY),
        "a dictionary": {"q": 1},
        "ragged": [[0.1, 0.1], [0.1]],
        "one too many": np.full((*shape[:-1], shape[-1] + 1), 0.1),
        "one too few": np.full((*shape[:-1], shape[-1] - 1), 0.1),
        "one number": 0.1,
    }
    return bad if batch else {**bad, "an axis too many": np.full((2, *shape), 0.1)}


def _with(values, bad):
    values = values.copy()
    values.flat[0] = bad
    return values


def any_numbers():
    """Where any shape may come, and a wrong one is a finding, not an error."""
    return {k: v for k, v in array(2).items() if not re.match("one|an axis", k)}


def scalar(*more):
    """What stands where one finite number should, `more` being numbers out of range."""
    bad = {
        "None": None,
        "words": "long",
        "NaN": NAN,
        "infinity": INFINITY,
        "a list": [1.0, 2.0],
        "complex": 1j,
    }
    return {**bad, **{f"the number {value}": value for value in more}}


def count(*more):
    """What stands where a whole number should."""
    bad = {"None": None, "words": "two", "a fraction": 1.5, "NaN": NAN, "True": True, "a list": [1]}
    return {**bad, **{f"the number {value}": value for value in (-1, *more)}}


NAMES = {
    "an unknown name": "dance",
    "None": None,
    "a number": 3,
    "a list": ["all"],
    "an array": np.zeros(2),
}
FUNCTIONS = {"None": None, "words": "inverse", "a number": 3}
ENTRIES = {
    "None": None, "True": True, "NaN": NAN, "infinity": INFINITY, "a call": "sin(1)", "half a formula": "a_3 +", "a list": [1],
    "complex": 1j, "a power": "2 ** 3", "nothing": "", "too long": "1 + " * 100 + "1",
}  # fmt: skip
LIMITS = {
    "one": (0,),
    "three": (0, 1, 2),
    "None": None,
    "a number": 3,
    "upside down": (1, -1),
    "words": ("a", "b"),
    "NaN": (NAN, 1),
}
POSITIVE = {
    "None": None,
    "words": "fast",
    "NaN": NAN,
    "zero": 0,
    "negative": -1.0,
    "a list": [1, 2],
}
ARMS = no("Arm")
FREE = {}  # left to Matplotlib or to Python, or any value will do


def any_length(*shape):
    """An array whose last size is free."""
    return {k: v for k, v in array(*shape).items() if k not in ("one too many", "one too few")}


def joints(n):
    return array(n, batch=True)


def optional(kind):
    """The same where None is the default."""
    return {k: v for k, v in kind.items() if v is not None}


# The table: a call that works, and what each argument may be instead


class Call:
    """A call by its arguments' names: each name with the right value and its kind."""

    def __init__(self, function, **arguments):
        self.function = function
        self.right = {name: value for name, (value, _) in arguments.items()}
        self.kinds = {name: kind for name, (_, kind) in arguments.items()}

    def __call__(self, **changed):
        return self.function(**{**self.right, **changed})


def axes(**kind):
    return Figure().add_subplot(**kind)


AX, AX_3D = (axes(), FREE), (axes(projection="3d"), FREE)
GRID_AXES = (Figure().subplots(2, 4), FREE)
_panda, _q = (PANDA, ARMS), (PANDA.home, joints(7))
_pose = (PANDA.home, array(7))
_rows = (
    [Row(a=0.1), Row()],
    {"None": None, "a number": 3, "no rows": [], "lists": [[0, 0, 0, 0]], "words": "rows"},
)
_targets = (REACH[None], any_numbers() | {"one number": 0.1, "a row": [0.1, 0.1]})
_text = ("anything", FREE)
_step3, _step2 = ([0, 0, 1], array(3)), ([0, 1], array(2))
_line = ([0.0, 1.0, 2.0], any_length(3))
_matrix = any_length(3, 2)
_symbolic = {"None": None, "a number": 3.5, "words": "q_1", "an array": np.zeros(2)}

AXES = [derive.Axis((0, 0, 0), (0, 0, 1)), derive.Axis((1, 0, 0), (0, 1, 0))]
ROBOT = """<robot name="one"><link name="a"/><link name="b"/><joint name="j" type="continuous"><parent link="a"/>
<child link="b"/></joint></robot>"""
LINKS = {"an unknown name": "hand", "a number": 3, "a list": ["a"]}
URDF = dict(
    source=(ROBOT, {"None": None, "a number": 3, "no file": "mine.urdf", "another document": "<sdf/>", "cut off": ROBOT[:-9]}),
    base=("a", LINKS), tip=("b", LINKS), hold=({}, {"a number": 3, "an unknown joint": {"k": 0}, "words": {"j": "bent"}, "NaN": {"j": NAN}}),
    name=("mine", {"a number": 3}),
)  # fmt: skip
ROW_CALL = dict(a=(0.1, ENTRIES), alpha=("pi/2", ENTRIES), d=(0, ENTRIES), theta=(0, ENTRIES))
MOVING = dict(limits=((-1, 1), LIMITS), speed=(1, POSITIVE), effort=(1, POSITIVE))

CALLS = {
    "arm.Arm": Call(
        arm.Arm, name=("mine", {"None": None, "a number": 3}), rows=([revolute(a="l")], {**no("Row"), "none": []}),
        values=({"l": 1.0}, {"None": None, "a number": 3, "words": "l", "no number": {"l": "one"}, "NaN": {"l": NAN}, "another name": {"m": 1.0}, "no name": {3: 1.0, "l": 1.0}}),
        bodies=([Body(1, (0, 0, 0))], {**no("Body"), "two": [Body(1, (0, 0, 0))] * 2}),
        home=((0.1,), {"None": None, "a number": 3, "two": (0, 0), "NaN": (NAN,), "words": ("a",)}), source=_text,
    ),
    "arm.Arm.with_values": Call(PANDA.with_values, a_3=(0.1, POSITIVE | {"infinity": INFINITY, "zero": "0 m", "negative": "-1 m"})),
    "arm.Arm.lock": Call(PANDA.lock, joint=(3, count(0, 8)), at=(0.1, ENTRIES | {"beyond its limits": 9, "a division by zero": "1/0", "a name": "b"})),
    "arm.Arm.with_rows": Call(PANDA.with_rows, rows=(PANDA.rows[:2], {**no("Row"), "none": []}), name=(None, {"a number": 3})),
    "arm.Arm.with_row": Call(PANDA.with_row, number=(3, count(0, 8)), a=(0.1, ENTRIES)),
    "arm.Arm.with_bodies": Call(PANDA.with_bodies, bodies=(PANDA.bodies, {**no("Body"), "two": PANDA.bodies[:2]}), name=(None, {"a number": 3})),
    "arm.Arm.to_free": Call(PANDA.lock(3).to_free, q=(PANDA.home[:6], joints(6))),
    "arm.Arm.from_free": Call(PANDA.lock(3).from_free, q=(PANDA.home, joints(7))),
    "arm.Arm.joint_vector": Call(PANDA.joint_vector, q=_q, what=_text, many=(True, FREE)),
    "arm.Arm.number": Call(PANDA.number, value=("a_3", ENTRIES | {"an unknown name": "b", "a division by zero": "1/0"})),
    "arm.Joint": Call(arm.Joint, kind=("revolute", NAMES), lower=(-1, {"None": None, "NaN": NAN, "words": "low"}), upper=(1, {"None": None, "NaN": NAN, "below the lower": -2}), speed=(1, POSITIVE), effort=(1, POSITIVE), at=(None, {"a moving joint": 0})),
    "arm.Row": Call(arm.Row, **ROW_CALL, joint=(arm.Joint(), no("Joint"))),
    "arm.Body": Call(arm.Body, mass=(1, ENTRIES), com=((0, 0, 0), {"None": None, "a number": 1, "two": (0, 0), "words": "xyz", "NaN": (0, 0, NAN)})),
    "arm.revolute": Call(arm.revolute, **ROW_CALL, **MOVING),
    "arm.prismatic": Call(arm.prismatic, **ROW_CALL, **MOVING),
    "arm.fixed": Call(arm.fixed, **ROW_CALL),
    "expressions.entry": Call(expressions.entry, value=(1, ENTRIES), what=_text),
    "expressions.names": Call(expressions.names, text=("a + b", ENTRIES), what=_text),
    "expressions.evaluate": Call(expressions.evaluate, text=("a", ENTRIES | {"an unknown name": "b", "a division by zero": "1/0"}), values=({"a": 1.0}, {"None": None, "a number": 3, "words": "a"})),
    "expressions.latex": Call(expressions.latex, text=("a", ENTRIES)),
    "robots.named": Call(robots.named, name=("panda", {"an unknown name": "Puma", "None": None, "a number": 3})),
    "conventions.standard_from_modified": Call(conventions.standard_from_modified, rows=_rows),
    "conventions.modified_from_standard": Call(conventions.modified_from_standard, rows=_rows),
    "conventions.modified_frames": Call(conventions.modified_frames, arm=_panda, q=_q),
    "derive.Axis": Call(derive.Axis, point=((0, 0, 0), {**array(3), "None": None}), direction=((0, 0, 1), {**array(3), "all 0": (0, 0, 0)}), joint=("revolute", {**NAMES, "one that does not move": "fixed"})),
    "derive.derive": Call(
        derive.derive, axes=(AXES, {**no("Axis"), "none": []}), tip=(np.eye(4), {**array(4, 4), "tripled": 3 * np.eye(4)}), base=(np.eye(4), optional(array(4, 4) | {"tripled": 3 * np.eye(4)})),
        name=("mine", {"None": None, "a number": 3}), negative=(False, FREE), tolerance=(1e-9, scalar(0, -1)),
    ),
    "derive.Derivation.with_bodies": Call(derive.derive(AXES, np.eye(4)).with_bodies, masses=([1.0, 2.0], {**array(2), "a negative one": [1.0, -1.0]}), centres=(np.zeros((2, 3)), array(2, 3))),
    "urdf.read_chain": Call(urdf.read_chain, **URDF),
    "urdf.from_urdf": Call(urdf.from_urdf, **URDF, negative=(False, FREE), tolerance=(1e-9, scalar(0, -1))),
    "urdf.Chain.derive": Call(urdf.read_chain(ROBOT).derive, negative=(False, FREE), tolerance=(1e-9, scalar(0, -1))),
    "kinematics.link_frames": Call(kinematics.link_frames, arm=_panda, q=_q),
    "kinematics.forward_kinematics": Call(kinematics.forward_kinematics, arm=_panda, q=_q),
    "kinematics.tip": Call(kinematics.tip, arm=_panda, q=_q),
    "kinematics.jacobian": Call(kinematics.jacobian, arm=_panda, q=_q),
    "kinematics.jacobian_in_frame": Call(kinematics.jacobian_in_frame, arm=_panda, q=_q, frame=(7, count(8))),
    "kinematics.analytic_jacobian": Call(kinematics.analytic_jacobian, arm=_panda, q=([0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7], joints(7) | {"singular angles": np.zeros(7)})),
    "kinematics.manipulability": Call(kinematics.manipulability, arm=_panda, q=_q, part=("linear", NAMES)),
    "ellipsoids.velocity_ellipsoid": Call(ellipsoids.velocity_ellipsoid, J=(np.ones((3, 2)), _matrix | {"six rows": np.ones((6, 2))})),
    "ellipsoids.force_ellipsoid": Call(ellipsoids.force_ellipsoid, J=(np.ones((3, 2)), _matrix | {"six rows": np.ones((6, 2))})),
    "ellipsoids.lost_directions": Call(ellipsoids.lost_directions, J=(np.ones((3, 2)), _matrix), cutoff=(1e-9, scalar(-1))),
    "statics.potential_energy": Call(statics.potential_energy, arm=_panda, q=_q, gravity=((0, 0, -9.81), array(3))),
    "statics.gravity_torque": Call(statics.gravity_torque, arm=_panda, q=_q, gravity=((0, 0, -9.81), array(3))),
    "statics.static_torque": Call(statics.static_torque, arm=_panda, q=([PANDA.home] * 2, joints(7)), wrench=([0.0] * 6, joints(6) | {"three for two poses": np.zeros((3, 6))}), gravity=((0, 0, -9.81), array(3))),
    "statics.with_payload": Call(statics.with_payload, arm=(PANDA, ARMS | {"an arm without masses": ELBOW}), mass=(1.0, scalar(-1)), com=((0, 0, 0.1), array(3))),
    "statics.centres_in": Call(statics.centres_in, frames_to=(FRAMES, array(8, 4, 4)), frames_from=(FRAMES, array(8, 4, 4)), centres=(np.zeros((8, 3)), array(8, 3))),
    **{f"symbolic.{f.__name__}": Call(f, arm=(ELBOW, ARMS)) for f in (symbolic.joint_symbols, symbolic.link_transforms, symbolic.link_frames, symbolic.forward_kinematics, symbolic.jacobian, symbolic.jacobian_by_differentiation)},
    "symbolic.determinant": Call(symbolic.determinant, arm=(ELBOW, ARMS | {"an arm of seven joints": PANDA})),
    "symbolic.potential_energy": Call(symbolic.potential_energy, arm=(HEAVY, ARMS | {"an arm without masses": ELBOW})),
    "symbolic.gravity_torque": Call(symbolic.gravity_torque, arm=(HEAVY, ARMS | {"an arm without masses": ELBOW})),
    "symbolic.body_numbers": Call(symbolic.body_numbers, arm=_panda, gravity=(9.81, scalar())),
    "symbolic.short": Call(symbolic.short, expression=(sp.cos(sp.Symbol("q_1")), _symbolic)),
    "symbolic.with_numbers": Call(symbolic.with_numbers, arm=_panda, expression=(sp.Symbol("a_3"), _symbolic)),
    "motion.Path": Call(motion.Path, times=([0.0, 1.0], any_length(2) | {"none": [], "backwards": [1.0, 0.0]}), position=(PATH.position, FUNCTIONS), velocity=(PATH.velocity, FUNCTIONS), normal=([1, 0, 0], array(3))),
    "motion.circle": Call(motion.circle, centre=([0, 0, 0], array(3)), radius=(0.1, scalar(0, -1)), plane=("yz", PLANES | {"three letters": "xyz"}), period=(5, scalar(0, -1)), steps=(10, count(0)), phase=(0.0, scalar())),
    "motion.circle_below": Call(motion.circle_below, arm=(SIX, ARMS), start=([0.1, 0.2, 1.4, 0.3, 1.6, 0.2], array(6)), radius=(0.1, scalar(0, -1)), plane=("zy", PLANES | {"no z": "xy"}), period=(5.0, scalar(0, -1)), steps=(4, count(0))),
    "motion.trace": Call(motion.trace, arm=(SIX, ARMS), start=([0.1, 0.2, 1.4, 0.3, 1.6, 0.2], array(6)), path=(PATH, no("Path")), method=("euler", NAMES), rates=(motion.damped(0.1), optional(FUNCTIONS)), gain=(0.0, scalar(-1)), jacobian=(kinematics.jacobian, FUNCTIONS)),
    "motion.plain_inverse": Call(motion.plain_inverse, cutoff=(1e-9, scalar(-1))),
    "motion.pseudo_inverse": Call(motion.pseudo_inverse, cutoff=(1e-9, scalar(-1))),
    "motion.damped": Call(motion.damped, damping=(0.1, scalar(-1))),
    "motion.adaptive": Call(motion.adaptive, damping=(0.1, scalar(-1)), below=(0.1, scalar(0, -1))),
    "motion.levenberg": Call(motion.levenberg, scale=(0.1, scalar(-1))),
    "motion.with_null_space": Call(motion.with_null_space, rates=(motion.plain_inverse(), FUNCTIONS), wish=(motion.towards([0] * 7, 1), FUNCTIONS)),
    "motion.self_motion": Call(motion.self_motion, arm=(PANDA, ARMS), start=(PANDA.home, joints(7)), direction=([1, 0, -1, 0, 0, 0, 0], joints(7)), length=(0.1, scalar(0, -1)), step=(0.05, scalar(0, -1)), speed=(0.5, scalar(0, -1))),
    "motion.self_motion_directions": Call(motion.self_motion_directions, arm=(PANDA, ARMS), q=(PANDA.home, joints(7))),
    "motion.towards": Call(motion.towards, goal=([0.0] * 7, any_length(7)), gain=(1.0, scalar(-1))),
    "motion.away_from_limits": Call(motion.away_from_limits, arm=(PANDA, ARMS | {"an arm without limits": STANFORD}), gain=(1.0, scalar(-1))),
    "inverse.solve": Call(
        inverse.solve, arm=(UR10E, ARMS), targets=(REACH, {k: v for k, v in array(4, 4, batch=True).items() if k != "one too few"} | {"no pose": np.diag([2.0, 1, 1, 1])}), start=([0.1] * 6, optional(joints(6))), limits=(True, FREE),
        tolerance=(1e-10, scalar(0, -1)), iterations=(3, count()), restarts=(0, count()), seed=(0, count()),
    ),
    "inverse.elbow": Call(inverse.elbow, arm=(ELBOW, ARMS | {"another arm": UR10E}), targets=(POINT, array(3, batch=True)), start=([0.1] * 3, optional(joints(3)))),
    "inverse.rod": Call(inverse.rod, arm=(ROD, ARMS | {"another arm": UR10E}), targets=([0.3, 0.3, 0.4], array(3, batch=True)), start=([0.1] * 3, optional(joints(3)))),
    "inverse.spherical_wrist": Call(inverse.spherical_wrist, arm=(WRISTED, ARMS | {"another arm": UR10E}), targets=(WRISTED_POSE, array(4, 4, batch=True)), start=([0.1] * 6, optional(joints(6)))),
    "inverse.stanford": Call(inverse.stanford, arm=(STANFORD, ARMS | {"another arm": UR10E}), targets=(ROD_POSE, array(4, 4, batch=True)), start=([0.1] * 6, optional(joints(6)))),
    "inverse.ur": Call(inverse.ur, arm=(UR10E, ARMS | {"another arm": PANDA}), targets=([REACH] * 2, array(4, 4, batch=True) | {"no pose": np.diag([2.0, 1, 1, 1])}), start=([0.1] * 6, optional(joints(6)) | {"three for two poses": np.zeros((3, 6))})),
    "inverse.follow": Call(inverse.follow, solver=(partial(inverse.ur, UR10E), FUNCTIONS), targets=_targets, start=([0.4, -1.2, 1.3, -1.2, -1.2, 0.3], joints(6))),
    "inverse.Solutions.nearest": Call(FOUND.nearest, q=([0.4] * 6, joints(6)), limits=(True, FREE)),
    "checks.check": Call(checks.check, label=("one is one", {"None": None, "a number": 3}), actual=(1, FREE), expected=(1, FREE), tolerance=(0.1, scalar(-1))),
    "checks.compare_tables": Call(checks.compare_tables, mine=_panda, reference=_panda),
    "checks.compare_jacobian": Call(
        checks.compare_jacobian, mine=(kinematics.jacobian(SIX, [0.1] * 6), any_numbers() | {"one number": 0.1, "an axis too many": np.zeros((2, 6, 6)), "a formula": sp.Symbol("t")}), arm=(SIX, ARMS),
        q=([0.1] * 6, optional(array(6))), angular_first=(False, FREE), frame=(0, count(8)),
    ),
    "checks.compare_torques": Call(checks.compare_torques, mine=([0.0] * 7, any_numbers()), arm=(PANDA, ARMS | {"an arm without masses": ELBOW}), q=_q, wrench=([0.0] * 6, joints(6)), gravity=((0, 0, -9.81), array(3)), tolerance=(1e-3, scalar(-1))),
    "checks.compare_trace": Call(checks.compare_trace, mine=(RUN.q, any_numbers()), arm=(SIX, ARMS), path=(PATH, no("Path")), tolerance=(2e-3, scalar(-1))),
    "checks.compare_branches": Call(checks.compare_branches, mine=(FOUND.q[0], array(6, batch=True) | {"an axis too many": np.zeros((2, 2, 6))}), found=(FOUND, no("Solutions") | {"many targets": inverse.ur(UR10E, [REACH] * 2)})),
    "variants.variant": Call(variants.variant, topic=("Jacobian", NAMES), arm=_panda, seed=(1, count())),
    "variants.sheet": Call(variants.sheet, arm=(ELBOW, ARMS), seed=(1, count())),
    "variants.Variant.marks": Call(variants.variant("Jacobian", PANDA, 1).marks, given=({}, {"None": None, "a list": [1, 2], "words": "J"})),
    "plotting.arm_2d": Call(plotting.arm_2d, ax=AX, arm=_panda, q=_pose, plane=("xz", PLANES), colour=("k", FREE), alpha=(1, FREE)),
    "plotting.arm_3d": Call(plotting.arm_3d, ax=AX_3D, arm=_panda, q=_pose, frames=(True, FREE), colour=("k", FREE), alpha=(1, FREE), label=_text),
    "plotting.arrow_2d": Call(plotting.arrow_2d, ax=AX, start=_step2, step=_step2, colour=("k", FREE), text=_text, dashed=(True, FREE)),
    "plotting.arrow_3d": Call(plotting.arrow_3d, ax=AX_3D, start=_step3, step=_step3, colour=("k", FREE), text=_text, dashed=(True, FREE)),
    "plotting.dh_numbers": Call(plotting.dh_numbers, ax=AX_3D, a=(1, scalar()), alpha=(1, scalar()), d=(1, scalar()), theta=(1, scalar())),
    "plotting.ellipsoid_3d": Call(plotting.ellipsoid_3d, ax=AX_3D, centre=_step3, axes=(np.eye(3), array(3, 3)), scale=(1.0, scalar(0, -1)), colour=("k", FREE), label=_text),
    "plotting.from_above": Call(plotting.from_above, ax=AX, arm=(ELBOW, ARMS), branches=([BEND, BEND], array(2, 3)), names=(("front", "back"), FREE), offset=(0.1, scalar())),
    "plotting.joints": Call(plotting.joints, axes=GRID_AXES, run=(RUN, no("Trace"))),
    "plotting.law_of_cosines": Call(plotting.law_of_cosines, ax=AX, arm=(ELBOW, ARMS), q=(BEND, array(3))),
    "plotting.map_2d": Call(plotting.map_2d, ax=AX, x=_line, y=_line, values=(np.arange(9.0).reshape(3, 3), array(3, 3)), label=_text),
    "plotting.moving_picture": Call(plotting.moving_picture, run=(RUN, no("Trace")), planes=(("xz", "yz"), {"None": None, "a number": 3, "one plane": "xz", "another letter": ("xw", "yz")}), frames=(2, count(0))),
    "plotting.path_2d": Call(plotting.path_2d, ax=AX, run=(RUN, no("Trace")), colour=("k", FREE), label=_text),
    "plotting.pen_and_wall": Call(plotting.pen_and_wall, ax=AX),
    "plotting.regions": Call(plotting.regions, ax=AX, x=_line, y=_line, which=(np.eye(3), array(3, 3)), names=({0: "no", 1: "yes"}, {"None": None, "a list": ["no"]}), colours=(("k", "r"), FREE)),
    "plotting.stick_3d": Call(plotting.stick_3d, ax=AX_3D, arm=_panda, q=_pose, colour=("k", FREE), title=_text),
    "plotting.torques": Call(plotting.torques, axes=GRID_AXES, arm=_panda, t=([0.0, 1.0], _line[1]), tau=(np.zeros((2, 7)), array(2, 7)), label=_text),
    "plotting.use_book_style": Call(plotting.use_book_style),
    "explorer.ArmExplorer": Call(
        explorer.ArmExplorer, arm=_panda, q=(PANDA.home, optional(array(7))), views=(["table"], {"None": None, "a number": 3, "none": [], "an unknown name": ["dance"], "words": "table"}), wrench=([0] * 6, array(6)),
        trace=([PANDA.home] * 3, optional(array(3, 7)) | {"one pose": PANDA.home}), branches=([PANDA.home], {"a number": 3, "words": "all", "too few": [[0] * 6], "NaN": [[NAN] * 7]}),
        reference=(PANDA, optional(ARMS)), arms=((), {"None": None, "a number": 3, "words": ["UR10e"]}), unit=("deg", NAMES), link=(False, FREE),
    ),
}  # fmt: skip

# What the helpers make and readers only read, and steps that get what their callers have checked.
MADE = {
    "derive.Derivation", "derive.Line", "derive.Step", "urdf.Chain",
    "arm.ArmError", "checks.BranchReport", "checks.Finding", "checks.JacobianReport", "checks.TableReport", "checks.TorqueReport",
    "checks.TraceReport", "inverse.NumericSolution", "inverse.Solutions", "motion.Report", "motion.Report.rows", "motion.SingularError", "motion.Trace",
    "motion.Rates", "variants.Answer", "variants.Variant",
}  # fmt: skip
STEPS = {
    f"kinematics.{name}"
    for name in (
        "evaluated",
        "recorded",
        "rows_of",
        "skeleton",
        "cross",
        "mixed",
        "tip_entries",
        "jacobian_entries",
        "frame_columns",
        "row_motions",
        "cosines_and_sines",
        "tilted",
    )
} | {
    f"program.{name}"
    for name in ("Term", "Program", "Program.of_numbers", "Program.of_rows", "record", "workspace")
}
SAYS_FALSE = {
    "variants.Answer.accepts",
    "variants.Answer.read",
}  # a student's answer is right or wrong, never an error
DOOR = {"inputs", "rows", "polynomials"}  # the checks themselves, and what arm and symbolic show


def public():
    """The name and the object of every public function, class, and method of a public class."""
    for module in pkgutil.iter_modules(helpers.__path__):
        if module.name in DOOR:
            continue
        found = importlib.import_module(f"helpers.{module.name}")
        for name in getattr(found, "__all__", None) or _own(found):
            thing = getattr(found, name)
            if callable(thing) and not isinstance(thing, type(motion.Rates)):
                yield f"{module.name}.{name}", thing
            if inspect.isclass(thing):
                methods = vars(thing).items()
                yield from (
                    (f"{module.name}.{name}.{n}", m)
                    for n, m in methods
                    if inspect.isfunction(m) and not n.startswith("_")
                )


def _own(module):
    return [
        name
        for name, thing in vars(module).items()
        if getattr(thing, "__module__", "") == module.__name__
        and not name.startswith("_")
        and callable(thing)
    ]


@pytest.fixture(autouse=True)
def _settings_kept():
    with mpl.rc_context():
        yield


PUBLIC = dict(public())
CASES = [
    pytest.param(name, argument, bad, id=f"{name}-{argument}-{bad}")
    for name, call in CALLS.items()
    for argument, kind in call.kinds.items()
    for bad in kind
]


def test_every_public_function_is_in_the_table():
    assert set(PUBLIC) - STEPS - MADE - SAYS_FALSE == set(CALLS)
    assert set(PUBLIC) >= STEPS | SAYS_FALSE


@pytest.mark.parametrize("name", CALLS)
def test_every_argument_is_in_the_table(name):
    if name in ("arm.Arm.with_values", "arm.Arm.with_row"):
        return
    parameters = inspect.signature(PUBLIC[name]).parameters.values()
    wanted = {p.name for p in parameters if p.kind is not p.VAR_KEYWORD} - {"self"}
    assert set(CALLS[name].kinds) == wanted


@pytest.mark.parametrize("name", CALLS)
def test_the_right_input_is_taken(name, capsys):
    CALLS[name]()


@pytest.mark.parametrize(("name", "argument", "bad"), CASES)
def test_bad_input_is_told_in_words(name, argument, bad, capsys):
    call = CALLS[name]
    value = call.kinds[argument][bad]
    with pytest.raises(ArmError) as told:
        call(**{argument: value})
    message = str(told.value)
    assert re.search(
        "expected|give |it has|there are|its free joints are|known are|its limits are|needs|use |does not suit",
        message,
    ), message
    given = [SAID[bad]] if bad in SAID else _names_of(value, argument)
    assert any(words in message for words in given), message


# How a message names what no word or shape does.
SAID = {
    "tripled": "no rigid transform, by 8", "an unknown joint": "no joint 'k'", "another document": "is a <sdf>", "cut off": "is no XML", "too long": "401 characters", "no pose": "no rigid transform, by 3", "three for two poses": "(2,) and (3,)", "many targets": "holds 2 targets",
    "another name": "no value for l", "singular angles": "theta is 0 or pi", "too few": "(6,)", "a formula": "no value for t", "negative": "-1",
}  # fmt: skip


def _names_of(value, argument):
    """What a message may call a value: itself, its shape, what it holds, or the argument's own name."""
    yield from (
        repr(value)[:60],
        str(value)[:60],
        str(np.shape(value)) if not _ragged(value) else argument,
    )
    yield from ("is none", "2 bodies for 1 rows", "2 bodies for 7 rows")
    yield from ("NaN or infinity", "is nan", "is inf", "has no rows")
    if isinstance(value, Arm):
        yield value.name
    if isinstance(value, list | tuple | dict):
        items = value.values() if isinstance(value, dict) else value
        yield from (str(item) for item in items)
        yield f"{argument} are"


def _ragged(value):
    try:
        np.shape(value)
    except ValueError:
        return True
    return False
