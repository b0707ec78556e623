"""Which other lengths a student may have given an arm."""

import pytest

from helpers.arm import Arm, revolute
from helpers.checks import compare_tables
from helpers.checks.lengths import alike, other_robots, wrong_lengths
from helpers.robots import ELBOW, PANDA, STANFORD, UR10E, UR10E_HOMEWORK


def test_lengths_of_one_letter_within_a_tenth_are_taken_for_one_another():
    lengths = {"a_1": 1.0, "a_2": 0.91, "a_3": 0.8, "a_4": -0.95, "a_5": 0.8, "d_1": 0.99}
    arm = Arm("five", [revolute(name) for name in lengths], values=lengths)
    assert alike(arm) == [("a_1", "a_2"), ("a_2", "a_1")]
    assert [alike(one) for one in (STANFORD, ELBOW)] == [[], []]


@pytest.mark.parametrize(
    ("arm", "robots"),
    [
        # a_2 and d_1 of the two, by their makers' tables: the UR10e (0.6127, 0.1807), the UR10
        # (0.612, 0.1273), and as the homework draws it (0.6127, 0.128).
        (UR10E, [("UR10", 0.6127, 0.128), ("UR10", 0.612, 0.1273)]),
        (UR10E_HOMEWORK, [("UR10e", 0.6127, 0.1807)]),
        (UR10E.with_values(a_2=0.6), []),
        (PANDA, []),
    ],
    ids=str,
)
def test_robots_of_nearly_one_name(arm, robots):
    found = other_robots(arm)
    assert [(name, one.values["a_2"], one.values["d_1"]) for name, one in found] == robots
    assert all(one.values["l_pen"] == arm.values["l_pen"] for _, one in found)


def test_the_pen_forgotten_and_a_length_taken_for_another():
    found = [(c.name, a.values["l_pen"], a.values["a_2"]) for c, a in wrong_lengths(UR10E)]
    assert found == [
        ("table.pen", 0, 0.6127),
        ("table.length:a_2:a_3", 0.1, 0.57155),
        ("table.length:a_3:a_2", 0.1, 0.6127),
    ]
    assert not list(wrong_lengths(PANDA.with_values(l_pen=0, a_3=0.088)))


@pytest.mark.parametrize("a", ["-a_2", "a_2"])
def test_one_length_for_another_is_named_also_where_x_points_back(a):
    """Not as a wrong number, though one entry alone differs."""
    assert compare_tables(UR10E.with_row(3, a=a), UR10E).causes == ("table.length:a_3:a_2",)
