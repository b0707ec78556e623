"""What people bring: hand-ins with text around them, labels, units and single mistakes. The sample
is small; `python -m tests.hand_ins` counts thousands."""

from collections import Counter

import numpy as np
import pytest
from hypothesis import example, given, settings
from hypothesis import strategies as st

from helpers import checks, inverse
from helpers.arm import Arm, ArmError, Body, prismatic, revolute
from helpers.kinematics import forward_kinematics, jacobian
from helpers.robots import ELBOW, PANDA, PANDA_HOMEWORK, UR10E, UR10E_HOMEWORK
from helpers.statics import static_torque
from tests.brought import LATEX, PUSH, TAU, Q
from tests.corpus import tables
from tests.corpus import torques as slips
from tests.corpus.arms import KNOWN, pose
from tests.corpus.machine import Machine
from tests.hand_ins import UNITS, hand_ins, jacobian_mistakes, names, true_causes, verdict
from tests.mixed import arm_of, heavy

LOCKED = PANDA.lock(3)


def torques(text, **options):
    return checks.compare_torques(text, UR10E, Q, PUSH, **options)


@pytest.fixture(scope="module")
def sample():
    return [(h, *verdict(h)) for h in hand_ins(0, 200)]


@pytest.mark.parametrize("word", ["called wrong", "false cause", "passed", "refused"])
def test_no_hand_in_of_the_sample_is(word, sample):
    found = [f"{h.dressed}\n{h.text}\n{report}" for h, is_, report in sample if is_ == word]
    assert not found, found[0]


def test_mistakes_of_the_sample_are_named(sample):
    for kind, least in (("single", 0.97), ("pair", 0.9)):
        counted = Counter(word for h, word, _ in sample if h.kind == kind)
        assert counted["named"] >= least * counted.total() - 1, kind


def shown(mistakes, right):
    """Those that show in five digits, each with the names that are true of it."""
    for key, made in mistakes.items():
        if made.shape != right.shape or np.abs(made - right).max() > 5e-3:
            yield key, made, true_causes(key, mistakes, 5)


@pytest.mark.parametrize("name", ["UR10E_HOMEWORK", "STANFORD", "PANDA.lock(3)"])
def test_each_mistake_in_a_jacobian_is_named(name):
    m, rng = KNOWN[name], np.random.default_rng(3)
    q = pose(m, rng)
    firsts, seconds = jacobian_mistakes(m, q, rng)
    right = m.jacobian(q)
    singles = firsts | {key: write(right) for key, write in seconds.items()}
    for key, made, true in shown(singles, right):
        report = checks.compare_jacobian(made.round(5), arm_of(m), q)
        assert any(names(cause, one) for cause in report.causes for one in true), (key, report)


@pytest.mark.parametrize("name", ["PANDA", "STANFORD"])
def test_each_mistake_in_torques_is_named(name):
    m, rng = KNOWN[name], np.random.default_rng(4)
    q, links, F = pose(m, rng), slips.bodies(m, rng), np.array([3, -5, 8, 1, -2, 0.5])
    singles = dict(slips.mistakes(m, links, q, F, rng))
    right = slips.weight(m, links, q) - slips.force(m, F, q)
    for key, made, true in shown(singles, right):
        arm = arm_of(m) if name == "PANDA" else heavy(m, links)
        report = checks.compare_torques(made.round(5), arm, q, F)
        assert any(names(cause, one) for cause in report.causes for one in true), (key, report)


@pytest.mark.parametrize("name", ["PANDA.lock(3)", "UR10E_HOMEWORK"])
def test_each_mistake_in_a_table_is_named(name):
    m = KNOWN[name]
    mistakes = tables.mistakes(m, np.random.default_rng(5))
    for key, rows in mistakes.items():
        if key in UNITS or tables.same_motion(m, rows):
            continue
        true = [k for k, x in mistakes.items() if tables.alike(x, rows)]
        report = checks.compare_tables(arm_of(Machine(rows)), arm_of(m))
        told = any(names(cause, one) for cause in report.causes for one in true)
        assert told or report.mark, (key, report)


@pytest.mark.parametrize("extra", ["99", "My answer: 99", "99 is the first", "or 0.5 perhaps"])
@pytest.mark.parametrize("above", [True, False])
@pytest.mark.parametrize("paste", [LATEX, "\n".join(map(str, TAU)), str(TAU.tolist())])
def test_no_number_vanishes(paste, above, extra):
    """Refused, wrong, or shown back."""
    try:
        report = torques(f"{extra}\n{paste}" if above else f"{paste}\n{extra}")
    except ArmError:
        return
    assert report.grade == "wrong" or extra in str(report), report


@settings(max_examples=60, deadline=None)
@example(seed=59, place=0.375)  # in the place of a locked joint
@given(seed=st.integers(0, 10**6), place=st.floats(0, 1))
def test_no_number_vanishes_wherever_it_stands(seed, place):
    """Into right work, at any place: refused, wrong, part of an entry, or shown back."""
    (found,) = (h for h in hand_ins(seed, 1))
    at = round(place * len(found.text))
    try:
        report = found.ask(f"{found.text[:at]} 99.125 {found.text[at:]}")
    except ArmError:
        return
    assert report.grade == "wrong" or report.mark or "99.125" in str(report), report


NAMED_Q = f"q = {Q.tolist()}"


@pytest.mark.parametrize(
    ("text", "left"),
    [
        (f"22.11.2026\n{TAU.tolist()}", "22.11.2026"),
        (f"Tom, 2026-11-22 14:30\n\n{TAU.tolist()}", "Tom, 2026-11-22 14:30"),
        (f"{NAMED_Q}\ntau = {TAU.tolist()}", NAMED_Q),
        (f"tau =\n\n{TAU.tolist()}\n\nF = [0, 0, -20]", "F = [0, 0, -20]"),
        (f"{TAU.tolist()} % or -99.5", "-99.5"),
        (f"{TAU.tolist()} % or 99.125 links", "99.125"),
        (f"tau 99.125 = {TAU.tolist()}", "99.125"),
    ],
)
def test_what_else_is_given_is_set_aside_and_shown(text, left):
    report = torques(text)
    assert report.agrees
    assert left in str(report)


def test_labels_say_units_and_that_a_jacobian_is_transposed():
    J = jacobian(UR10E, Q)
    names = ("vx [mm/rad]", "vy [mm/rad]", "vz [mm/rad]", "wx", "wy", "wz")
    rows = np.where(np.arange(6) < 3, 1000, 1)[:, None] * J
    lines = [f"{n} {' '.join(f'{x:.4f}' for x in row)}" for n, row in zip(names, rows, strict=True)]
    assert checks.compare_jacobian("\n".join(lines), UR10E, Q).agrees
    assert checks.compare_jacobian(f"J.T =\n{J.T.round(5)}", UR10E, Q).agrees
    assert not checks.compare_jacobian(f"J =\n{J.T.round(5)}", UR10E, Q).agrees


def test_other_numbers_about_a_jacobian_are_set_aside():
    J = jacobian(UR10E, Q).round(4)
    columns = "\n".join(f"J_{k} = [{'; '.join(map(str, J[:, k - 1]))}]" for k in range(1, 7))
    assert checks.compare_jacobian(columns, UR10E, Q).agrees
    assert checks.compare_jacobian(f"{columns}\nJ = [J_1 J_2 J_3 J_4 J_5 J_6]", UR10E, Q).agrees
    rows = "\n".join(" ".join(map(str, row)) for row in J)
    report = checks.compare_jacobian(f"{rows}\n\ndet(J) = -0.1234", UR10E, Q)
    assert report.agrees
    assert "`det(J) = -0.1234`" in str(report)


@pytest.mark.parametrize(
    "text",
    [
        "Hi,\n\\begin{equation}\ntau = [LIST]\n\\end{equation}\nBest",
        "Hi,\ntau = [LIST, ...\n  REST];\nBest",
    ],
)
def test_what_was_taken_is_not_shown_as_set_aside(text):
    """Though LaTeX's and MATLAB's lines are put together."""
    several = TAU.round(5).astype(str).tolist()
    parts = (several, []) if "REST" not in text else (several[:3], several[3:])
    for name, part in zip(("LIST", "REST"), parts, strict=True):
        text = text.replace(name, ", ".join(part))
    report = torques(text)
    assert report.agrees
    assert "set aside: `Hi,`, `Best`" in str(report)


@pytest.mark.parametrize("text", ["± 0.3, 1.1, 0.4", "0.3 \\pm 0.1, 1.1, 0.4"])
def test_two_signs_are_asked_about(text):
    with pytest.raises(ArmError, match="write out each sign"):
        checks.compare_pose(text, ELBOW, (0.3, 0.2, 0.7))


@pytest.mark.parametrize(
    "row", ["Joint {}: theta = {}, d = {}, a = {}, alpha = {}", "theta={1} d={2} a={3} alpha={4}"]
)
def test_a_table_may_be_a_line_of_entries_for_each_joint(row):
    rows = [(1, "q1", 0.5, 0, 90), (2, "q2", 0, 0.4, 0), (3, "q3", 0, 0.3, 0)]
    assert checks.compare_tables("\n".join(row.format(*one) for one in rows), ELBOW).agrees


def test_a_unit_may_end_the_heads():
    """The bracket of the last one is no matrix's."""
    rows = "Joint 1 pi/2 500 q1 0\nJoint 2 0 0 q2 400\nJoint 3 0 0 q3 300"
    report = checks.compare_tables(f"alpha [rad] a [mm] theta [rad] d [mm]\n{rows}", ELBOW)
    assert report.causes == ("table.a and d",)


def test_two_grids_are_asked_about():
    with pytest.raises(ArmError, match="several answers that differ"):
        torques(f"{TAU.tolist()}\nor rather this one\n{(2 * TAU).tolist()}")
    for which, agrees in ((1, True), (2, False)):
        assert torques(f"{TAU.tolist()}\nor\n{(2 * TAU).tolist()}", which=which).agrees is agrees


T = forward_kinematics(UR10E, Q)
HOMEWORK = inverse.ur(UR10E_HOMEWORK, T)
J_OF = [(UR10E, UR10E_HOMEWORK, Q), (UR10E_HOMEWORK, UR10E, Q)]
J_OF += [(PANDA.lock(3), PANDA_HOMEWORK.lock(3), Q)]


@pytest.mark.parametrize(("asked", "other", "q"), J_OF)
def test_the_jacobian_of_the_other_arm_is_known(asked, other, q):
    report = checks.compare_jacobian(jacobian(other, q).round(4), asked, q)
    assert report.causes == (f"arm.other:{other.name}",)
    assert f"robots.named({other.name!r})".replace("'", '"') in report.advice[0]


def test_the_other_arm_is_known_in_every_question():
    there = forward_kinematics(UR10E_HOMEWORK, Q)
    panda = static_torque(PANDA_HOMEWORK.lock(3), Q, PUSH).round(4)
    for report in (
        checks.compare_pose(Q, UR10E, there),
        checks.compare_branches(HOMEWORK.q[HOMEWORK.valid].round(4), inverse.ur(UR10E, T)),
        checks.compare_torques(panda, LOCKED, Q, PUSH),
    ):
        assert report.causes[0].startswith("arm.other:"), report
        assert not report.agrees


FRANKA = """Joint a (m) d (m) alpha (rad) theta (rad)
Joint 1 0 0.333 0 θ1
Joint 2 0 0 -π/2 θ2
Joint 3 0 0.316 π/2 θ3
Joint 4 0.0825 0 π/2 θ4
Joint 5 -0.0825 0.384 -π/2 θ5
Joint 6 0 0 π/2 θ6
Joint 7 0.088 0 π/2 θ7"""


def test_the_makers_layout_is_read():
    report = checks.compare_tables(FRANKA, PANDA.with_values(l_pen=0, d_7=0), convention="craig")
    assert report.figures["same machine"], report


def test_a_column_with_decimals_of_several_lengths_is_one_or_is_asked_about():
    column = "\n".join(f"{x:.4g}".replace(".", ",") for x in TAU)
    assert any(len(x.partition(",")[2]) != 4 for x in column.splitlines())
    assert torques("-0,0000\n" + column.partition("\n")[2]).grade != "wrong"


def test_a_table_whose_tip_is_elsewhere_is_not_green():
    """Two slides in a row: no map of the joints, and yet a_2 is wrong."""
    mine = Arm("Two slides", [prismatic(alpha=np.pi / 2), prismatic(0.114, np.pi / 2), revolute()])
    typed = "d theta a alpha\nd1 0 0 90\nd2 0 0.128 90\n0 q3 0 0"
    report = checks.compare_tables(typed, mine)
    assert report.grade == "wrong"
    assert "it is 0.014 m away; a in row 2 is 14 mm too long" in report.headline


def test_degree_signs_are_not_taken_twice():
    q = ", ".join(f"{x:.3f}°" for x in np.degrees(Q))
    for angles in ("deg", "rad"):
        assert checks.compare_pose(q, UR10E, T, angles=angles).agrees


def test_no_cause_is_stated_that_leaves_something():
    assert not checks.compare_branches("1 2 3", inverse.elbow(ELBOW, (0.3, 0.2, 0.7))).causes
    lost = checks.compare_pose([33.69, 65.831, 46.525], ELBOW, [0.12, 0.08, 0.15], angles="deg")
    zeros = checks.compare_torques(np.zeros(6), UR10E, Q, PUSH)
    assert (lost.causes, zeros.causes) == ((), ())
    nothing = checks.compare_torques(np.zeros(6), UR10E, Q)
    assert nothing.causes == ("tau.weight missing",)


def test_a_small_mistake_that_fits_is_no_rounding():
    """g = 9.8 on light links under a large push: many units off, a thousandth of the torques."""
    light = UR10E.with_bodies([Body(body.mass / 40, body.com) for body in UR10E.bodies])
    push = [0, 0, -20, 3, 0, 0]
    mine = static_torque(light, Q, push) - 0.01 / 9.81 * static_torque(light, Q, [0] * 6)
    assert checks.compare_torques(mine.round(5), light, Q, push).causes == ("tau.gravity:9.8",)


def test_other_zeros_are_told_and_not_green():
    report = checks.compare_tables("q1 0.5 0 90\nq2+30 0 0.4 0\nq3 0 0.3 0", ELBOW)
    assert report.figures["same machine"]
    tips = [forward_kinematics(ELBOW, np.add(ELBOW.home, [0, x, 0]))[:3, 3] for x in (0, np.pi / 6)]
    assert f"{np.linalg.norm(np.subtract(*tips)):.3g} m away" in report.headline
    assert "theta in row 2 should be nothing (you have q2+30)" in report.headline
