"""Test the checks of torques against the corpus.

The tests vary the layout of the answer, its error at one configuration or along a trajectory, and
the messages for single joints. The arm has joints 1, 3 and 4, and joint 3 slides.
"""

from fractions import Fraction

import numpy as np
import pytest
import sympy as sp

from helpers.arm import ArmError
from helpers.checks import compare_torques
from tests.corpus.torques import force, weight
from tests.mixed import HEAVY, MIXED, add_masses, make_arm

ARM = add_masses(MIXED, HEAVY)
F = np.array([3.0, -7, 11, 0.5, -2, 1.5])
BENT = np.array([0.4137, 0.3281, -0.9452])
Q2, Q3 = (BENT + np.outer(np.linspace(0, 1, n), [0.1, 0.2, 0.5]) for n in (2, 3))
LINKS = "links of 2.5, 0, 1.7, 0.9 kg under g = 9.81 m/s²"
TURNED = "one list for each joint, transposed into one row for each configuration"
LOCKED = "all joints; 2 is locked, so its 0.7 is set aside"
OFF = np.eye(3)


def compute_torques(q, F=F):
    """Return the right torques at one configuration or several."""
    if np.ndim(q) > 1:
        return np.array([compute_torques(x, F) for x in q])
    return weight(MIXED, HEAVY, q) - force(MIXED, F, q)


TAU, TAU2, TAU3 = compute_torques(BENT), compute_torques(Q2), compute_torques(Q3)


def compare(mine, q=BENT, **options):
    report = compare_torques(mine, ARM, q, **({"wrench": F} | options))
    assert (report.topic, report.arm) == ("torques", "your arm")
    return report


def test_wrench_alone_loads_an_arm_without_masses():
    arm, right = make_arm(MIXED), -force(MIXED, F, BENT)
    assert compare_torques(right.round(4), arm, BENT, F).grade == "right"
    assert compare_torques(-right.round(4), arm, BENT, F).causes[0] == "tau.force sign"
    assert compare_torques(right.round(4), ARM, BENT, F).grade == "wrong"


# Layouts


@pytest.mark.parametrize(
    ("mine", "q", "taken"),
    [
        (TAU3, Q3, ()),
        (TAU2.T, Q2, (TURNED,)),
        (TAU2[:, None], Q2[:, None], ()),
        (TAU2[..., None], Q2[None], ()),
        (np.insert(TAU2, 1, 0.7, axis=1), Q2, (LOCKED,)),
        (np.insert(TAU3, 1, 0.7, axis=1).T, Q3, (TURNED, LOCKED)),
        (np.insert(TAU, 1, 0.7), BENT, (LOCKED,)),
        (TAU2[:1], Q2[:1], ()),
        (TAU[:, None], BENT, ()),
    ],
)
def test_other_layouts_of_torques_are_read_and_noted(mine, q, taken):
    report = compare(np.round(mine, 5), q)
    assert (report.grade, report.taken) == ("right", (*taken, LINKS))
    assert report.figures["right"] == 3
    assert "to the digits you gave" in report.headline


@pytest.mark.parametrize(
    ("by", "cause"),
    [(-1, "tau.all signs"), (OFF[::-1], "tau.reversed order")],
)
def test_square_matrix_is_not_transposed(by, cause):
    mine = (TAU3 @ by if np.ndim(by) else by * TAU3).round(4)
    for some, causes in ((mine, (cause,)), (mine.T, ())):
        report = compare(some, Q3)
        assert (report.taken, report.causes) == ((LINKS,), causes)
    nearly = compare((TAU3 + 0.1 * OFF[2][:, None] * OFF[1]).round(4), Q3)
    assert str(nearly.findings[0]) == "Joint 3: off by up to 0.1 N."


@pytest.mark.parametrize(
    ("mine", "q", "shape", "wanted"),
    [
        (TAU2[:, :2], Q2, "2x2", "2x3"),
        (TAU2[:1], Q2, "1x3", "2x3"),
        (TAU2[:, :1], Q2, None, None),
        (7.5, BENT, None, None),
        (TAU[1:], BENT, "2", "3"),
        (np.ones((2, 2, 3)), Q2, "2x2x3", "2x3"),
    ],
)
def test_wrong_shape_is_reported(mine, q, shape, wanted):
    report = compare(mine, q)
    (finding,) = report.findings
    key = "tau.energy" if shape is None else "tau.shape"
    assert (report.grade, report.causes, finding.what) == ("wrong", (key,), "shape")
    assert (finding.mine, finding.expected) == (np.shape(mine), (len(np.atleast_2d(q)), 3))
    shape = (
        "Your list has one number for each configuration"
        if shape is None
        else f"Its shape is {shape};"
    )
    assert finding.words.startswith(shape)
    assert wanted is None or f"give {wanted}, one torque for each of 3 joints" in finding.words
    assert report.headline.startswith(f"The torques of your arm are not right: {shape[:3].lower()}")


def test_degrees_apply_only_to_revolute_joints():
    q = np.array([[30.0, 0.25, -45.0], [10.0, 0.5, 60.0]])
    turned = np.where([True, False, True], np.radians(q), q)
    tau = compute_torques(turned).round(5)
    for mine, at in ((tau, q), (tau.T, q), (tau[0], q[0]), (tau[1], q[1:])):
        assert compare(mine, at, angles="deg").agrees
    assert compare(compute_torques(q).round(5), q, angles="deg").causes == ("tau.degrees",)


def test_loads_of_any_number_type_are_read():
    load = {
        "wrench": [Fraction(int(2 * x), 2) for x in F],
        "gravity": (sp.Integer(0), 0, sp.Rational(-981, 100)),
    }
    for mine, agrees in ((TAU, True), (compute_torques(BENT, 0 * F), False), (1.02 * TAU, False)):
        assert compare(mine.round(4), **load).agrees == agrees
    mine = np.round([compute_torques(x, f) for x, f in zip(Q2, (F, 2 * F), strict=True)], 4)
    for wrench, agrees in (([F, 2 * F], True), ([[F], [2 * F]], True), (F, False)):
        assert compare(mine, Q2, wrench=wrench).agrees == agrees
    mine = np.round([compute_torques(BENT, F), compute_torques(BENT, 2 * F)], 4)
    assert compare(mine, BENT, wrench=[F, 2 * F]).agrees
    assert compare(-mine, BENT, wrench=[F, 2 * F]).causes == ("tau.all signs",)


# Functions


def raise_key_error(q):
    raise KeyError("no such run")


def torques_at_one_configuration(q):
    assert np.shape(q) == (3,)
    return compute_torques(q)


def test_text_of_long_trajectory_is_read():
    q = np.repeat([BENT], 340, axis=0)
    text = "\n".join(" ".join(f"{x:.5f}" for x in TAU) for _ in q)
    assert compare(text, q).agrees


@pytest.mark.parametrize("text", ["tau: 0.5\n", "{1} ", "\\tau_{1} = 0.5\n"])
def test_text_of_far_too_many_numbers_is_refused(text):
    with pytest.raises(ArmError, match="I find 510 numbers; expected: 3 numbers"):
        compare(text * 510)


def test_function_is_called_for_each_configuration():
    for mine in (
        torques_at_one_configuration,
        lambda q: torques_at_one_configuration(q)[:, None],
        lambda a, b, c: torques_at_one_configuration([a, b, c]),
    ):
        assert compare(mine, Q2).agrees
    assert compare(torques_at_one_configuration).agrees
    assert compare(lambda q: torques_at_one_configuration(q)[:2], Q2).causes == ("tau.shape",)
    for mine, words in (
        (raise_key_error, "your arm: your torques: your function failed .KeyError: .no such run"),
        (lambda q: None, "your arm: your torques"),
    ):
        for q in (Q2, BENT):
            with pytest.raises(ArmError, match=words):
                compare(mine, q)


# Grades, and messages about joints


@pytest.mark.parametrize(
    ("digits", "share", "grades"),
    [(3, 0.49, ("right", "so far")), (3, 1.4, ("wrong",)), (2, 0.49, ("wrong",))],
)
def test_rounded_q_widens_torque_tolerance(digits, share, grades):
    """Joint values with three decimals count as rounded, with two decimals as exact."""
    off = share * 10.0**-digits * np.array([1, -1, 1])
    for q in (BENT.round(digits), BENT.round(digits)[None], Q3.round(digits)):
        shown = "\n".join(", ".join(f"{x:.{digits}f}" for x in y) for y in np.atleast_2d(q))
        assert compare(compute_torques(q + off).round(6), shown).grade in grades


@pytest.mark.parametrize(("off", "grade"), [(0.0, "right"), (0.001, "rounded"), (0.5, "wrong")])
@pytest.mark.parametrize("at", [0, 1, 33, 59])
def test_error_at_any_configuration_makes_the_answer_wrong(off, grade, at):
    """The judge samples five of the sixty configurations first, and the second is not sampled."""
    q = np.linspace(BENT, 1.3 * BENT, 60)
    mine = compute_torques(q)
    mine[at, 1] += off
    report = compare([[f"{x:.3f}" for x in row] for row in mine], q)
    assert report.grade == grade
    assert report.figures["right"] == (2 if grade == "wrong" else 3)
    assert report.figures["worst"] == pytest.approx(off, abs=6e-4)
    if grade == "wrong":
        assert [f.where for f in report.findings] == ["joint 3"]
        assert str(report.findings[0]).startswith("Joint 3: off by up to 0.")


@pytest.mark.parametrize(
    ("mine", "said", "options"),
    [
        (
            TAU3 * (1 - 2 * OFF[2]) - 0.75 * OFF[1],
            ["Joint 3: off by up to 0.75 N.",
             "Joint 4: the sign is wrong."],
            {},
        ),
        (TAU3 + 0.3 * OFF[0] + 0.1, ["Joint 1: off by up to 0.4 N m."], {"tolerance": 0.2}),
        (TAU3 + 0.3 * OFF[0] + 0.1, [], {"tolerance": 0.5}),
    ],
)  # fmt: skip
def test_wrong_joints_are_described(mine, said, options):
    report = compare(mine.round(4), Q3, **options)
    assert [f.words for f in report.findings] == said
    assert (report.grade == "wrong") == bool(said)
    alone = compare(mine[0].round(4), **options)
    assert [f.words for f in alone.findings] == [x.replace("up to ", "") for x in said]
