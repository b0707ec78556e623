"""Call every public function with invalid arguments and check the messages of its ArmErrors.

A message names the argument, shows the invalid value and states what was expected. The functions
are those of every `__all__`. Each is called with valid arguments, of which one is replaced: RIGHT
holds values for one function, SHARED holds values for all arguments of a name. `test_inputs.py`
tests every way in which one kind of argument can be invalid.
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

import answers
import helpers
from helpers import (
    arm,
    derive,
    inverse,
    kinematics,
    motion,
)
from helpers.arm import Arm, ArmError, Body, Row, revolute
from helpers.robots import ELBOW, PANDA, PANDA_HOMEWORK, STANFORD, UR10E

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

FLAT = Figure().add_subplot()
GRID = Figure().subplots(2, 4)
AXES = [derive.Axis((0, 0, 0), (0, 0, 1)), derive.Axis((1, 0, 0), (0, 1, 0))]
ROBOT = """<robot name="one"><link name="a"/><link name="b"/><joint name="j" type="continuous">
<parent link="a"/><child link="b"/></joint></robot>"""
DERIVED = derive.derive(AXES, np.eye(4))
MASSLESS = PANDA.with_bodies(())

# fmt: off
# Valid values of arguments by their names. Each function with such an argument takes this value.
SHARED = dict(
    J=np.ones((3, 2)), a=0.1, a_3=0.1, actual=1, alpha="pi/2", angles="rad",
    angular_first=False, answer="J", arm=PANDA, arms=(), ax=FLAT, axes=GRID, base="a",
    between=(0, 90), book_only=False, branches=[PANDA.home], colour="k", colours=("k", "r"),
    columns="theta d a alpha", convention="standard", cutoff=1e-9, d=0, damping=0.1, dashed=True,
    description="Its answers.", display=True, effort=1, end=[1, 1], derivation=DERIVED, expected=1,
    frames_from=FRAMES, frames_to=FRAMES, gain=1.0, goal=[0.0] * 7, gravity=(0, 0, -9.81),
    heading="Elbow", home=(0.1,), inertia=np.eye(3), inertias=np.zeros((7, 3, 3)), iterations=3,
    jacobian=kinematics.jacobian, joints=[2], label="anything", language="NumPy",
    introduction="An arm.", length=0.1, lengths="m", limits=(-1, 1), link=False, lower=-1,
    many=True, masses=[1.0, 2.0], method="euler", name="mine", named={"A_1": np.eye(4)},
    negative=False, normal=[1, 0, 0], number=3, offset=0.1, other_arms=(ELBOW,), part="linear",
    path=PATH, phase=0.0,
    program="sympy", planes=("xz", "yz"), points=np.zeros((2, 3)), configurations=[PANDA.home] * 2,
    position=PATH.position,
    q=PANDA.home, q_ddot=[0.0] * 7, q_dot=[0.0] * 7, radius=0.1, reference=PANDA, restarts=0, row=1,
    answer_number=1, rows=[Row(a=0.1), Row()], run=RUN, scale=0.1, seed=1, size=1,
    solver=partial(inverse.ur, UR10E),
    speed=1, start=[0.1] * 6, t=[0.0, 1.0], tau=np.zeros((2, 7)), tex="x", text="anything", theta=0,
    times=[0.0, 1.0], title="anything", titles=("one", "two"), tolerance=1e-3, tool=0.1,
    topic="Jacobian", topics=["Jacobian"], trace=[PANDA.home] * 3, unit="deg", upper=1, values={},
    velocity=PATH.velocity, view="xz", views=["table"],
    wrench=[0.0] * 6, written="−π/2", x=[0.0, 1.0, 2.0], y=[0.0, 1.0, 2.0],
)
# Valid values for one function only. A method also needs its object, `self`.
RIGHT = {
    "arm.Arm": dict(rows=[revolute(a="l")], values={"l": 1.0}, bodies=[Body(1, (0, 0, 0))],
        source="anything", circle=UR10E.circle),
    "arm.Arm.with_values": dict(self=PANDA),
    "arm.Arm.lock": dict(self=PANDA, joint=3, at=0.1),
    "kinematics.jacobian": dict(frame="tool"),
    "kinematics.roll_pitch_yaw": dict(T=np.eye(4)),
    "kinematics.quaternion": dict(T=np.eye(4)),
    "arm.Arm.with_row": dict(self=PANDA),
    "arm.Arm.with_base": dict(self=PANDA, pose=np.eye(4)),
    "arm.Arm.with_tool": dict(self=PANDA, pose=[0.0] * 6),
    "arm.Arm.with_bodies": dict(self=PANDA, bodies=PANDA.bodies, name=None),
    "arm.Arm.insert_locked": dict(self=PANDA.lock(3), q=PANDA.home[:6]),
    "arm.Arm.remove_locked": dict(self=PANDA.lock(3)),
    "arm.Arm.joint_vector": dict(self=PANDA, name="anything"),
    "arm.Arm.number": dict(self=PANDA, value="a_3"),
    "arm.Joint": dict(kind="revolute", at=None),
    "arm.Row": dict(joint=arm.Joint()),
    "arm.Body": dict(mass=1, com=(0, 0, 0)),
    "robots.find_arm": dict(name="panda"),
    "robots.restore_lengths": dict(arm=ELBOW, names=["a_2"]),
    "derive.Axis": dict(point=(0, 0, 0), direction=(0, 0, 1), joint="revolute"),
    "derive.derive": dict(axes=AXES, tip=np.eye(4), tolerance=1e-9),
    "derive.Derivation.with_bodies": dict(self=derive.derive(AXES, np.eye(4)),
        centres=np.zeros((2, 3)), inertias=np.zeros((2, 3, 3))),
    "answers.make_html_sheet": dict(arm=ELBOW),
    "answers.make_markdown_sheet": dict(arm=ELBOW),
    "urdf.from_urdf": dict(source=ROBOT, tip="b", tolerance=1e-9, angle_tolerance=1e-4),
    "statics.static_torque": dict(q=[PANDA.home] * 2),
    "statics.with_payload": dict(mass=1.0, com=(0, 0, 0.1)),
    "statics.centres_in": dict(centres=np.zeros((8, 3))),
    "symbolic.determinant": dict(arm=ELBOW),
    "symbolic.potential_energy": dict(arm=HEAVY),
    "symbolic.gravity_torque": dict(arm=HEAVY),
    "symbolic.body_numbers": dict(gravity=9.81),
    "symbolic.abbreviate": dict(expression=sp.cos(sp.Symbol("q_1"))),
    "symbolic.latex": dict(expression=sp.cos(sp.Symbol("q_1"))),
    "symbolic.latex_lines": dict(expression=sp.cos(sp.Symbol("q_1")), width=60),
    "symbolic.with_numbers": dict(expression=sp.Symbol("a_3")),
    "motion.line": dict(start=[0, 0, 0], end=[0, 0.1, 0], period=5, steps=10),
    "motion.circle": dict(centre=[0, 0, 0], plane="yz", period=5, steps=10),
    "motion.circle_below": dict(arm=SIX, start=[0.1, 0.2, 1.4, 0.3, 1.6, 0.2], plane="zy",
        period=5.0, steps=4),
    "motion.trace": dict(arm=SIX, start=[0.1, 0.2, 1.4, 0.3, 1.6, 0.2], rates=motion.damped(0.1),
        gain=0.0),
    "motion.self_motion": dict(start=PANDA.home, direction=[1, 0, -1, 0, 0, 0, 0], step=0.05,
        speed=0.5),
    "motion.join_traces": dict(runs=[RUN]),
    "inverse.solve": dict(arm=UR10E, targets=REACH, limits=True, tolerance=1e-10),
    "inverse.elbow": dict(arm=ELBOW, targets=POINT, start=[0.1] * 3),
    "inverse.rod": dict(arm=ROD, targets=[0.3, 0.3, 0.4], start=[0.1] * 3),
    "inverse.spherical_wrist": dict(arm=WRISTED, targets=WRISTED_POSE),
    "inverse.stanford": dict(arm=STANFORD, targets=ROD_POSE),
    "inverse.ur": dict(arm=UR10E, targets=[REACH] * 2),
    "inverse.solutions": dict(arm=UR10E, targets=[REACH] * 2),
    "inverse.follow": dict(targets=REACH[None], start=[0.4, -1.2, 1.3, -1.2, -1.2, 0.3]),
    "inverse.Solutions.nearest": dict(self=FOUND, q=[0.4] * 6),
    "checks.check": dict(label="one is one", tolerance=0.1),
    "checks.compare_tables": dict(answer=[["q1", 0, 0, 0]], tolerance=1e-6,
        start_configuration=PANDA.home),
    "checks.compare_jacobian": dict(answer=kinematics.jacobian(SIX, [0.1] * 6), arm=SIX,
        q=[0.1] * 6, frame=0),
    "checks.compare_torques": dict(answer=[0.0] * 7),
    "checks.compare_trace": dict(answer=RUN.q, arm=SIX, tolerance=2e-3),
    "checks.compare_branches": dict(answer=FOUND.q[0], solutions=FOUND),
    "checks.compare_pose": dict(q=[0.1] * 7, T=[0.1, 0.2, 0.3]),
    "plotting.draw_angle": dict(centre=[0, 0]),
    "plotting.draw_joint_axes": dict(view=(30, 18), length=0.3),
    "plotting.draw_dimension": dict(start=[0, 1], aside=(0, 1)),
    "plotting.draw_frames": dict(which=[0, 7], names="x"),
    "plotting.draw_lengths": dict(aside={"d_1": (0, 1)}),
    "plotting.draw_postures": dict(axes=GRID[0][:2]),
    "plotting.draw_row": dict(view=(30, 18)),
    "plotting.plot_arm": dict(plane="xz", alpha=1),
    "plotting.draw_arrow": dict(start=[0, 1], step=[0, 1]),
    "plotting.draw_shoulder_triangles": dict(
        point=[0.3, 0.2], names=("left", "right"), symbols=("d", "r")
    ),
    "plotting.draw_wrist_triangles": dict(twists=(60, 50), apart=70),
    "plotting.draw_ur_triangle": dict(arm=UR10E, q=UR10E.home),
    "plotting.draw_law_of_cosines": dict(arm=ELBOW, q=BEND),
    "plotting.animate_trace": dict(frames=2),
    "plotting.plot_regions": dict(which=np.eye(3), names={0: "no", 1: "yes"}),
    "plotting.plot_torque_shares": dict(runs={"one": np.zeros((2, 7))}),
    "explorer.ArmExplorer": dict(wrench=[0] * 6),
    "explorer.ArmFigure": dict(kind="columns"),
    "show.frames": dict(T=FRAMES),
    "symbolic.joint_symbols": dict(arm=ELBOW),
    "symbolic.link_transforms": dict(arm=ELBOW),
    "symbolic.link_frames": dict(arm=ELBOW),
    "symbolic.forward_kinematics": dict(arm=ELBOW),
    "symbolic.jacobian": dict(arm=ELBOW),
    "symbolic.jacobian_by_differentiation": dict(arm=ELBOW),
}
# fmt: on

# Arguments that are not tested: Python or Matplotlib checks them, or any value is valid.
FREE = {
    *("actual", "ax", "book_only", "colour", "colours", "dashed", "expected", "link", "many"),
    *("negative", "display", "self", "title", "what", "arm.Arm source"),
    "arm.Arm.joint_vector name",
    *("inverse.solve limits", "plotting.plot_arm alpha"),
    "plotting.draw_arrow text",
    *("plotting.draw_shoulder_triangles names", "plotting.draw_shoulder_triangles symbols"),
    *("plotting.plot_joints axes", "plotting.plot_torques axes", "plotting.draw_postures axes"),
    *("plotting.draw_angle text", "plotting.draw_dimension text", "plotting.draw_postures titles"),
}

# Descriptions of arguments in messages, if they differ from the name.
NAMES_IN_MESSAGES = {
    "arm.Arm.joint_vector q": "anything",
    "arm.Body com": "centre of mass",
    "arm.Arm.number value": "the entry",
    **{
        f"inverse.{name} targets": "a target"
        for name in ("elbow", "rod", "solutions", "solve", "spherical_wrist", "stanford", "ur")
    },
    "robots.find_arm name": "no arm is called",
    "checks.compare_tables answer": "the table",
    "checks.compare_jacobian answer": "your Jacobian",
    "checks.compare_torques answer": "your torques",
    "checks.compare_trace answer": "your joints",
    "checks.compare_branches answer": "your answer",
    "checks.compare_pose q": "your answer",
    "checks.compare_pose T": "the target",
    "explorer.ArmExplorer trace": "q ",
    "explorer.ArmExplorer reference": "arm is",
}

# Vectors of a fixed length. A vector that is too short gives the same message as no number.
VECTORS = ("centre", "direction", "normal", "point", "q", "start", "step", "wrench")
ANY_LENGTH = {"inverse.follow start", "explorer.ArmExplorer q", "explorer.ArmExplorer wrench"}

# Arguments that take a single configuration. A list of them is rejected, even of length 1.
SINGLE_CONFIGURATIONS = {
    *("motion.trace start", "motion.circle_below start", "motion.self_motion start"),
    *("motion.self_motion direction", "motion.self_motion_directions q"),
    "plotting.plot_arm q",
}

# Numbers just outside the range of an argument. They give the same message as no number.
OUT_OF_RANGE = {
    **dict.fromkeys(("below", "length", "period", "radius", "motion.self_motion speed"), (0, -1)),
    "motion.self_motion step": (0, -1),
    **dict.fromkeys(("cutoff", "damping", "gain", "iterations", "restarts"), (-1,)),
    **dict.fromkeys(("scale", "tolerance", "angle_tolerance"), (-1,)),
    **{"frames": (0,), "steps": (0,), "joint": (0, 8), "number": (0, 8)},
    **{"inverse.solve tolerance": (0,)},
    **{"derive.derive tolerance": (0,), "statics.with_payload mass": (-1,)},
}

# Invalid values that give a special message: function, replaced arguments, part of the message.
# fmt: off
SPECIAL = [
    ("arm.Arm", dict(rows=[]), 'mine: rows are (); expected one Row or more'),
    ("arm.Arm", dict(values={"m": 1.0}), "mine: no value for l; give values={'l': ...}"),
    ("arm.Arm", dict(bodies=[Body(1, (0, 0, 0))] * 2), 'mine: 2 bodies for 1 rows;'),
    ("arm.Arm", dict(home=(0, 0)), 'mine: q has shape (2,); expected numbers (..., 1), one value'),
    ("arm.Arm.with_values", dict(l=1), 'Panda has no symbol l; it has d_1, d_3'),
    ("arm.Arm.lock", dict(at="1/0"), '1/0 divides by zero or is too large;'),
    ("arm.Arm.lock", dict(at="b"), 'no value for b; there are d_1'),
    ("arm.Arm.with_bodies", dict(bodies=PANDA.bodies[:2]), 'Panda: 2 bodies for 7 rows;'),
    ("plotting.draw_shoulder_triangles", dict(point=[0.01, 0]), "point is 0.01 m from the axis"),
    ("plotting.draw_lengths", dict(aside={"b_1": (0, 1)}), "aside names 'b_1'; expected steps"),
    ("plotting.draw_lengths", dict(aside={"d_8": (0, 1)}), "aside names 'd_8'; expected steps"),
    ("plotting.draw_lengths", dict(view="xx"), "view is 'xx'; expected two different letters"),
    ("plotting.draw_row", dict(row=9), "row is 9; expected one of 1 to"),
    ("plotting.draw_frames", dict(which=[8]), "which holds 8; expected numbers of frames"),
    ("arm.Joint", dict(upper=-2), 'joint limits are (-1, -2); expected lower <= upper'),
    ("arm.Joint", dict(kind="fixed", at=1j), "joint at is '1j'; expected numbers, symbols"),
    ("arm.Joint", dict(speed=0), 'joint speed and effort are 0, 1; expected both > 0'),
    ("arm.Body", dict(com=(0, 0)), 'centre of mass is (0, 0); expected three'),
    ("arm.revolute", dict(limits=(0,)), 'joint limits are (0,); expected two numbers'),
    ("derive.Axis", dict(direction=(0, 0, 0)), "an axis's direction is (0, 0, 0);"),
    ("derive.Axis", dict(joint="fixed"), "an axis's joint is fixed; expected revolute"),
    ("derive.derive", dict(axes=[]), 'axes are []; expected one Axis or more'),
    ("derive.derive", dict(tip=3 * np.eye(4)), 'tip is no rigid transform, by 8'),
    ("derive.derive", dict(tip=(1, 2, np.nan)), 'tip holds NaN or infinity; expected a rigid'),
    ("conventions.standard_from_modified", dict(rows=[]), 'the modified table has no rows;'),
    ("conventions.modified_from_standard", dict(rows=[]), 'the standard table has no rows;'),
    ("derive.derive", dict(tip=np.eye(4) + np.eye(4, k=1) * [0, 0.02, 0, 0]),
     'tip is no rigid transform, by 0.02'),
    ("derive.Derivation.with_bodies", dict(masses=[1, -1]), 'masses are [1, -1];'),
    ("statics.static_torque", dict(q=[PANDA.home] * 2, wrench=np.zeros((3, 6))), '(2,) and (3,)'),
    ("statics.potential_energy", dict(arm=MASSLESS), 'Panda has no masses; give bodies'),
    ("symbolic.determinant", dict(arm=PANDA), '7 joints; a determinant needs 3'),
    ("symbolic.potential_energy", dict(arm=MASSLESS), 'Panda has no masses; give bodies'),
    ("motion.Path", dict(times=[]), 'times are []; expected each later than the one before'),
    ("motion.Path", dict(times=[1, 0]), 'times are [1. 0.]; expected each later'),
    ("motion.circle_below", dict(plane="xy"), "plane is 'xy'; expected one with z"),
    ("inverse.ur", dict(start=np.zeros((3, 6))), 'targets and start have shapes (2,) and (3,)'),
    ("inverse.follow", dict(targets=[0.1, 0.1]), 'targets have shape (2,); expected (n, 3)'),
    ("checks.compare_torques", dict(arm=MASSLESS), 'Panda has no masses and no wrench'),
    ("checks.compare_torques", dict(q=[PANDA.home] * 2, wrench=np.zeros((3, 1, 6))),
     'configurations and wrenches have shapes (2,) and (3,); expected the same or one of one'),
    ("checks.compare_torques", dict(answer=[10**400] * 7),
     'your torques: one of the numbers is NaN'),
    ("checks.compare_tables", dict(values={"a": [1, 2]}), "values['a'] is [1, 2]; expected a"),
    ("checks.compare_jacobian", dict(values={1: 2.0}), 'a name in values is 1; expected a str'),
    ("checks.compare_branches", dict(solutions=inverse.ur(UR10E, [REACH] * 2)),
     'solutions hold 2'),
    ("plotting.animate_trace", dict(planes="xz"), "planes are 'xz'; expected two planes such as"),
    ("explorer.ArmExplorer", dict(trace=PANDA.home), 'the trace has shape (7,);'),
    ("explorer.ArmFigure", dict(joints=[9]), 'joints has 9; the Panda has 1, 2, 3, 4, 5, 6, 7'),
    ("explorer.ArmFigure", dict(kind="triangles"), 'the figure triangles shows the Elbow arm'),
    ("explorer.ArmExplorer", dict(branches=[[0] * 6]), 'Panda: q has shape (6,);'),
]
# fmt: on

# Classes that only the helpers create, and functions whose callers have checked the arguments.
NOT_CALLED_BY_USERS = {
    "derive.Derivation", "derive.Line", "derive.DerivationStep",
    "arm.ArmError", "explorer.ArmExplorer.set_state", "checks.Finding", "checks.Verdict",
    "checks.UnreadNumberError",
    "inverse.NumericSolution", "inverse.Solutions", "motion.TraceReport",
    "motion.TraceReport.rows", "motion.SingularError", "motion.Trace",
    "motion.UnreachableError",
    "show.MarkdownOutput", "stepwise.StepwiseFormulas",
}  # fmt: skip


def find_public():
    """Yield name and object of everything callable in an `__all__`, with the methods of classes."""
    names = sorted(module.name for module in pkgutil.iter_modules(helpers.__path__))
    modules = {name: importlib.import_module(f"helpers.{name}") for name in names}
    for module_name, module in {**modules, "answers": answers}.items():
        for name in getattr(module, "__all__", ()):
            member = getattr(module, name)
            if callable(member) and not isinstance(member, type(motion.Rates)):
                yield f"{module_name}.{name}", member
            if inspect.isclass(member):
                methods = vars(member).items()
                yield from (
                    (f"{module_name}.{name}.{n}", m)
                    for n, m in methods
                    if inspect.isfunction(m) and not n.startswith("_")
                )


@pytest.fixture(autouse=True)
def _settings_kept():
    with mpl.rc_context():
        yield


PUBLIC = dict(find_public())


def look_up(table, name, argument, default=None):
    """Return a table's entry for one function's argument, or else for all of that name."""
    return table.get(f"{name} {argument}", table.get(argument, default))


def valid_arguments(name):
    """Return a valid value for every argument of a public function."""
    specific, parameters = RIGHT.get(name, {}), inspect.signature(PUBLIC[name]).parameters.values()
    named = [p.name for p in parameters if p.kind is not p.VAR_KEYWORD]
    missing = {*named} - {*specific} - {*SHARED}
    assert not missing, f"{name}: give {missing} a right value, in RIGHT or in SHARED"
    return {argument: SHARED.get(argument) for argument in named} | specific


CALLS = {name: valid_arguments(name) for name in sorted(set(PUBLIC) - NOT_CALLED_BY_USERS)}


def invalid_arguments():
    """Yield function, argument and an invalid value for it."""
    for name, call in CALLS.items():
        for argument, value in call.items():
            if argument in FREE or f"{name} {argument}" in FREE:
                continue
            yield name, argument, 1j
            if isinstance(value, np.ndarray):
                yield name, argument, np.full_like(value, np.nan, dtype=float)
                if not name.startswith("checks."):  # the checks give a verdict on any finite number
                    yield name, argument, np.full_like(value, 1e308, dtype=float)
            if argument in VECTORS and f"{name} {argument}" not in ANY_LENGTH and np.ndim(value):
                yield name, argument, np.asarray(value)[..., :-1]
            if f"{name} {argument}" in SINGLE_CONFIGURATIONS:
                yield name, argument, np.asarray(value)[None]
            for number in look_up(OUT_OF_RANGE, name, argument, ()):
                yield name, argument, number


def test_tables_name_only_public_functions():
    assert set(RIGHT) <= set(CALLS), "a name in RIGHT is not public"
    assert set(PUBLIC) >= NOT_CALLED_BY_USERS, "a name in NOT_CALLED_BY_USERS is not public"


@pytest.mark.parametrize("name", CALLS)
def test_valid_call_is_accepted(name):
    PUBLIC[name](**CALLS[name])


@pytest.mark.parametrize(("name", "argument", "bad"), list(invalid_arguments()))
def test_invalid_argument_is_named_in_the_message(name, argument, bad):
    with pytest.raises(ArmError) as error:
        PUBLIC[name](**{**CALLS[name], argument: bad})
    before, _, after = re.split("(expected|its free joints are) ", str(error.value), maxsplit=1)
    called = re.escape(look_up(NAMES_IN_MESSAGES, name, argument, argument).strip())
    assert re.search(rf"(?<!\w){called}(?!\w)", before), "the message must name the argument"
    assert len(after) > 3, "the message must state what was expected"
    assert isinstance(bad, np.ndarray) or str(bad) in before, "the message must show the value"


@pytest.mark.parametrize(("name", "changed", "message"), SPECIAL)
def test_special_invalid_input_has_its_message(name, changed, message):
    with pytest.raises(ArmError) as error:
        PUBLIC[name](**{**CALLS[name], **changed})
    assert message in str(error.value)
