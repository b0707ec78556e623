"""Test which wrong lengths the judge expects in a student's arm."""

import pytest

from helpers.arm import Arm, revolute
from helpers.checks import compare_tables
from helpers.checks.arms import judge_data
from helpers.robots import ELBOW, PANDA, STANFORD, UR10E, UR10E_HOMEWORK


def test_lengths_of_one_letter_with_similar_values_are_paired():
    lengths = {"a_1": 1.0, "a_2": 0.91, "a_3": 0.8, "a_4": -0.95, "a_5": 0.8, "d_1": 0.99}
    arm = Arm("five", [revolute(name) for name in lengths], values=lengths)
    found = [(one["name"], one["other"]) for one in judge_data(arm)["alike"]]
    assert found == [("a_1", "a_2"), ("a_2", "a_1")]
    assert not any("alike" in judge_data(one) for one in (STANFORD, ELBOW))


@pytest.mark.parametrize(
    ("arm", "robots"),
    [
        # |a_2| and d_1 in the makers' tables are 0.6127, 0.1807 (UR10e) and 0.612, 0.1273 (UR10).
        # The homework draws 0.6127, 0.128.
        (UR10E, [("UR10", 0.6127, 0.128), ("UR10", 0.612, 0.1273)]),
        (UR10E_HOMEWORK, [("UR10e", 0.6127, 0.1807)]),
        (UR10E.with_values(a_2=0.6), []),
        (PANDA, []),
    ],
    ids=str,
)
def test_robots_of_similar_name_are_listed(arm, robots):
    found = judge_data(arm).get("robots", [])
    lengths = [(one["name"], abs(one["rows"][1]["a"]), one["rows"][0]["d"]) for one in found]
    assert lengths == robots
    pens = [one["rows"][5]["d"] - one["penless"][5]["d"] for one in found]
    assert pens == pytest.approx([0.1] * len(robots))


def test_forgotten_pen_and_exchanged_lengths_are_listed():
    found = judge_data(UR10E)
    assert found["rows"][5]["d"] - found["penless"]["rows"][5]["d"] == pytest.approx(0.1)
    lengths = [(one["name"], one["other"], one["rows"][1]["a"]) for one in found["alike"]]
    assert lengths == [("a_2", "a_3", -0.57155), ("a_3", "a_2", -0.6127)]
    bare = judge_data(PANDA.with_values(l_pen=0, a_3=0.088))
    assert not {"penless", "alike"} & bare.keys()


@pytest.mark.parametrize("a", ["-a_2", "a_2"])
def test_exchanged_length_is_named_with_either_sign(a):
    """Since only one entry differs, the cause "wrong number" would also fit."""
    assert compare_tables(UR10E.with_row(3, a=a), UR10E).causes == ("table.length:a_3:a_2",)
