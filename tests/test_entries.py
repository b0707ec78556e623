"""Test how the number of typed digits changes a verdict, for random arms.

Every entry is judged by its own last decimal, and a cause is stated only if it makes every entry
right. Expected numbers and mistakes come from the corpus's own kinematics, which shares no line
with `judge/`.
"""

import numpy as np
import pytest

from helpers import checks, inverse
from helpers.kinematics import forward_kinematics
from helpers.robots import ELBOW, UR10E_HOMEWORK
from tests.corpus import torques as loads
from tests.corpus.arms import draw_configuration, some_machine
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


FOUR = inverse.elbow(ELBOW, (0.3, 0.2, 0.7))
EIGHT = inverse.ur(
    UR10E_HOMEWORK, forward_kinematics(UR10E_HOMEWORK, [0.3, -0.8, 0.9, 0.4, -0.5, 0.6])
)


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
