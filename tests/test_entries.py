"""Test how the number of typed digits changes a verdict, for random arms.

Every entry is judged by its own last decimal, and a cause is stated only if it makes every entry
right. Expected numbers and mistakes come from the corpus's own kinematics, which shares no line
with `judge/`.
"""

import numpy as np
import pytest

from helpers import checks, inverse
from helpers.kinematics import forward_kinematics
from helpers.robots import ELBOW, PANDA, PANDA_HOMEWORK, STANFORD, UR10E_HOMEWORK
from tests.corpus import torques as loads
from tests.corpus.arms import KNOWN, draw_configuration, some_machine
from tests.mixed import add_masses, make_arm

SEEDS = range(25)
PUSH = np.array([3.0, -5, 8, 1, -2, 0.5])


def write_rows(rows, digits):
    """Write each entry with its own number of decimals."""
    rows = np.atleast_2d(rows)
    return "\n".join(
        " ".join(f"{x + 0.0:.{n}f}" for x, n in zip(row, ns, strict=True))
        for row, ns in zip(rows, np.broadcast_to(digits, rows.shape), strict=True)
    )


class RandomQuestion:
    """The Jacobian or the torques of a random arm, and the checker that judges them."""

    def __init__(self, about, seed, decimals=3):
        self.rng = np.random.default_rng(seed)
        self.machine = some_machine(self.rng)
        self.q, arm = draw_configuration(self.machine, self.rng, decimals), make_arm(self.machine)
        if about == "jacobian":
            self.expected = self.machine.jacobian(self.q)
            self.judge = lambda text: checks.compare_jacobian(text, arm, self.q)
            self.fewest_decimals = 4
        else:
            self.links = loads.bodies(self.machine, self.rng)
            loaded_arm = (
                arm if self.machine.name == "PANDA" else add_masses(self.machine, self.links)
            )
            weight = loads.weight(self.machine, self.links, self.q)
            self.expected = weight - loads.force(self.machine, PUSH, self.q)
            self.judge = lambda text: checks.compare_torques(text, loaded_arm, self.q, PUSH)
            self.fewest_decimals = 3

    def draw_decimals(self):
        return self.rng.integers(
            self.fewest_decimals, self.fewest_decimals + 3, np.shape(self.expected)
        )


each_question = pytest.mark.parametrize("about", ["jacobian", "torques"])


# With d_1 and d_4 exchanged, joint 1 of the UR10e carries -1.72377 instead of -1.72306 N m; the
# torques of the other joints stay. Cut to -1.723 both are equal, so the answer is right so far.
CUT_LIKE_A_MISTAKE = {("torques", 18)}


@each_question
@pytest.mark.parametrize("seed", SEEDS)
def test_rounded_or_cut_entries_are_right(about, seed):
    question = RandomQuestion(about, seed)
    digits = question.draw_decimals()
    assert question.judge(write_rows(question.expected, digits)).grade == "right"
    unit = 10.0**-digits
    cut = write_rows(np.trunc(question.expected / unit) * unit, digits)
    report = question.judge(cut)
    expected = "so far" if (about, seed) in CUT_LIKE_A_MISTAKE else "right"
    assert report.grade == expected, cut
    assert report.causes == (), cut


@each_question
@pytest.mark.parametrize("seed", SEEDS)
def test_error_of_one_in_last_place_is_no_mistake(about, seed):
    """The largest entry moves away from zero, which cutting digits never does; q is exact."""
    question = RandomQuestion(about, seed, 15)
    digits = question.draw_decimals()
    place = np.unravel_index(np.abs(question.expected).argmax(), np.shape(question.expected))
    typed = np.array(question.expected)
    typed[place] = round(typed[place], digits[place])
    typed[place] += np.sign(typed[place]) * 10.0 ** -digits[place]
    report = question.judge(write_rows(typed, digits))
    assert (report.grade, report.causes) == ("rounded", ()), report


@each_question
@pytest.mark.parametrize("seed", SEEDS[:8])
def test_tolerance_follows_decimals_of_each_joint(about, seed):
    """Joint 1 has nine decimals; the three decimals of the other joints set the tolerance."""
    question = RandomQuestion(about, seed, 15)
    question.q = " ".join(f"{x:.{9 if k == 0 else 3}f}" for k, x in enumerate(question.q))
    assert question.judge(write_rows(question.expected, 5)).grade == "right"


@each_question
@pytest.mark.parametrize("seed", SEEDS)
def test_random_error_is_located_and_gets_no_cause(about, seed):
    question = RandomQuestion(about, seed)
    digits = question.rng.integers(question.fewest_decimals - 1, question.fewest_decimals + 2)
    typed = np.array(question.expected)
    place = tuple(int(question.rng.integers(n)) for n in typed.shape)
    typed[place] += (
        question.rng.choice([-1, 1]) * question.rng.uniform(0.1, 1) * np.abs(typed).max()
    )
    report = question.judge(write_rows(typed, digits))
    joint = question.machine.joints[place[-1]] + 1
    assert (report.grade, report.causes) == ("wrong", ()), report
    where = f"column {place[-1] + 1}" if about == "jacobian" else f"joint {joint}"
    assert [finding.where for finding in report.findings] == [where]


@pytest.mark.parametrize("seed", [10, 17, 24, 27])
def test_random_error_of_whole_newton_metres_gets_no_cause(seed):
    """Without a bound on evidence, a pair of slips would fit four of forty random errors."""
    question = RandomQuestion("torques", seed)
    typed = np.array(question.expected)
    place = int(question.rng.integers(len(typed)))
    typed[place] += (
        question.rng.choice([-1, 1]) * question.rng.uniform(0.1, 1) * np.abs(typed).max()
    )
    assert not question.judge(write_rows(typed, 0)).causes


@pytest.mark.parametrize("seed", SEEDS)
def test_random_errors_of_two_columns_get_no_cause(seed):
    question = RandomQuestion("jacobian", seed)
    typed = question.expected + np.where(
        question.rng.random(question.expected.shape) < 0.1, 0.377, 0
    )
    assert not question.judge(write_rows(typed, 3)).causes


def test_whole_numbers_of_the_start_are_not_right():
    J = (
        KNOWN["PANDA"]
        .with_rows(
            [(k, np.copysign(0.088, a) if a else 0, *rest) for k, a, *rest in KNOWN["PANDA"].rows]
        )
        .jacobian(PANDA_HOMEWORK.home)
    )
    for whole in (np.trunc(J), np.round(J)):
        report = checks.compare_jacobian(write_rows(whole, 0), PANDA_HOMEWORK, PANDA_HOMEWORK.home)
        assert report.grade != "right"
        assert not report.causes
    assert "give two more" in report.headline
    assert checks.compare_jacobian(write_rows(J, 4), PANDA_HOMEWORK, PANDA_HOMEWORK.home).agrees


Q = [0.3, -0.23, 0.348, 1.07, 0.457, 2.75, 0.917]


def tau_of(links=loads.PANDA, g=9.81, machine=KNOWN["PANDA"]):
    F = np.array([-5.0, 0, 0, 0, 0, 0])
    return loads.weight(machine, links, Q, g) - loads.force(machine, F, Q)


def of_panda(tau, digits=4, arm=PANDA):
    return checks.compare_torques(write_rows(tau, digits), arm, Q, [-5, 0, 0, 0, 0, 0])


def test_digits_that_also_fit_a_mistake_are_too_few():
    assert of_panda(tau_of(), 2).agrees
    few = of_panda(tau_of(), 0)  # g = 9.8 changes 29 N m by 0.03
    assert few.grade == "so far"
    assert "give two more" in few.headline
    assert of_panda(tau_of(g=9.8), 2).causes == ("tau.gravity:9.8",)


def test_three_significant_figures_are_right():
    """Each number is rounded to its own decimal place, as by hand."""
    text = " ".join(f"{x:.3g}" for x in tau_of())
    assert checks.compare_torques(text, PANDA, Q, [-5, 0, 0, 0, 0, 0]).grade in ("right", "so far")


FORCE = -loads.force(KNOWN["PANDA"], np.array([-5.0, 0, 0, 0, 0, 0]), Q)
REPORT = [loads.PANDA[0], (0.646926 + 3.228604, 0, 0, 0.158), (0, 0, 0, 0), *loads.PANDA[3:]]
PAPERS = [loads.PAPER[0], REPORT[1], REPORT[2], *loads.PAPER[3:]]
SWAPPED = [
    (other[0], *link[1:])
    for link, other in zip(
        loads.PANDA, (loads.PANDA[i] for i in (0, 2, 1, 3, 4, 5, 6)), strict=True
    )
]


@pytest.mark.parametrize(
    ("tau", "cause"),
    [
        (tau_of(REPORT, 9.8), "tau.report"),
        (tau_of(REPORT), "tau.lumped"),
        (tau_of(PAPERS, 9.8), "tau.paper centres + tau.report"),
        (tau_of(loads.PAPER), "tau.paper centres"),
        (tau_of(SWAPPED), "tau.masses exchanged:2:3"),
    ],
)  # fmt: skip
def test_models_of_the_report_are_named(tau, cause):
    report = of_panda(tau)
    assert cause in report.causes, report


def test_torque_verdict_names_its_masses():
    assert any("4.97, 0.647, 3.23" in line for line in of_panda(tau_of()).taken)


# Joint angles

FOUR = inverse.elbow(ELBOW, (0.3, 0.2, 0.7))
EIGHT = inverse.ur(
    UR10E_HOMEWORK, forward_kinematics(UR10E_HOMEWORK, [0.3, -0.8, 0.9, 0.4, -0.5, 0.6])
)


def of_elbow(*answers, digits=4):
    return checks.compare_branches(write_rows(answers, digits), FOUR)


@pytest.mark.parametrize("seed", SEEDS)
@pytest.mark.parametrize("found", [FOUR, EIGHT], ids=["ELBOW", "UR10E_HOMEWORK"])
def test_rounded_branches_are_right_random_errors_unnamed(found, seed):
    rng = np.random.default_rng(seed)
    q = np.array(found.q[found.valid])
    digits = rng.integers(3, 6, q.shape)
    assert checks.compare_branches(write_rows(q, digits), found).agrees
    place = tuple(int(rng.integers(n)) for n in q.shape)
    q[place] += rng.uniform(0.2, 1.2)
    report = checks.compare_branches(write_rows(q, 4), found)
    assert (report.grade, report.causes) == ("wrong", ()), report


def test_mixed_branches_and_turned_shoulder_are_named():
    """The cases are the demonstration of chapter 5, and report E's list with slip 12 corrected."""
    first, second = FOUR.q[0], FOUR.q[1]
    mixed = of_elbow(first, (second[0], first[1], second[2]))
    assert mixed.causes[0] == "ik.mixed"
    assert "two branches are mixed" in str(mixed)
    turned = of_elbow(first, first + np.array([np.pi, 0, 0]))
    assert turned.causes == ("ik.shoulder",)
    assert "take all from one side" in str(turned)


def test_forgotten_length_is_named_by_all_answers():
    """The answer puts the shoulder on the floor: the formulas use z_c in place of z_c - d_1."""
    floor = inverse.elbow(ELBOW.with_values(d_1=1e-9), (0.3, 0.2, 0.4))
    report = checks.compare_branches(write_rows(floor.q, 4), inverse.elbow(ELBOW, (0.3, 0.2, 0.4)))
    assert report.causes == ("table.missing:d:1",), report
    assert "d in row 1 is missing" in report.headline


def test_branches_beyond_the_range_are_not_asked_for():
    found = inverse.stanford(
        STANFORD, forward_kinematics(STANFORD, [0.3, -0.4, 0.6, 0.5, 1.1, -0.2])
    )
    inside = found.q[found.q[:, 2] > 0]
    report = checks.compare_branches(write_rows(inside, 4), found)
    assert report.agrees
    assert "beyond the range of q_3" in str(report)


def test_value_of_a_locked_joint_is_set_aside():
    arm = PANDA.lock(3)
    q = np.array([0.3, -0.23, 1.07, 0.457, 2.75, 0.917])
    T = forward_kinematics(arm, q)
    report = checks.compare_pose(np.insert(q, 2, 0.0), arm, T)
    assert report.agrees
    assert "all joints; 3 is locked, so its 0 is set aside" in report.taken


def test_locked_joint_is_set_aside_in_a_configuration():
    q = [0.4, -0.6, -1.9, 0.3, 1.8, 0.7]
    typed = "0.4, -0.6, 0, -1.9, 0.3, 1.8, 0.7"
    J = KNOWN["PANDA.lock(3)"].jacobian(q)
    report = checks.compare_jacobian(J, PANDA.lock(3), typed)
    assert report.agrees
    assert "all joints; 3 is locked, so its 0 is set aside" in report.taken


def test_nothing_is_set_aside_without_locked_joint():
    q = [0.4, -0.6, 0.3, 0.3, 1.8, 0.7]
    report = checks.compare_jacobian(KNOWN["STANFORD"].jacobian(q), STANFORD, q)
    assert report.agrees
    assert "set aside" not in str(report)
