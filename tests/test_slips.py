"""Test the list of simple mistakes in a table against counts by hand and direct products."""

from itertools import combinations
from math import pi

import numpy as np
import pytest

from helpers.arm import Arm, ArmError, fixed, prismatic, revolute
from helpers.robots import ELBOW, PANDA, STANFORD, UR10E_HOMEWORK
from helpers.slips import TableSlip, census, list_slips
from tests.laws import slow_frames

TURN = np.pi / 2


def test_slips_of_a_table_are_listed():
    arm = Arm(
        "two", [revolute(a=0.3, alpha="pi"), fixed(d=-0.1, theta="pi"), prismatic(theta="pi/2")]
    )
    assert list(list_slips(arm)) == [
        TableSlip(1, "q", -1),
        TableSlip(1, "a", 0),
        TableSlip(1, "a", -0.3),
        TableSlip(1, "alpha", 0),  # -180° is 180°
        TableSlip(2, "d", 0),
        TableSlip(2, "d", 0.1),
        TableSlip(2, "theta", 0),
        TableSlip(3, "q", -1),
        TableSlip(3, "theta", 0),
        TableSlip(3, "theta", -pi / 2),
    ]


def tip_with_slips(arm, q, wrong):
    """Return the tip's pose with wrong table entries and joint signs."""
    q = np.array(q)
    for row, entry, value in wrong:
        if entry == "q":
            q[arm.joints.index(row)] *= value
        else:
            arm = arm.with_row(row, **{entry: value})
    return slow_frames(arm, q)[-1]


@pytest.mark.parametrize(
    "arm", [UR10E_HOMEWORK, PANDA, STANFORD, ELBOW.with_values(d=0.12)], ids=str
)
def test_unseen_slips_match_direct_products(arm):
    rng = np.random.default_rng(7)
    poses = TURN * rng.integers(-1, 2, (2, arm.dof))  # right angles: many slips stay unseen
    one = [(slip,) for slip in list_slips(arm)]
    two = [a + b for a, b in combinations(one, 2) if a[0][:2] != b[0][:2]]
    right = [tip_with_slips(arm, q, ()) for q in poses]
    off = {
        w: [np.abs(tip_with_slips(arm, q, w) - T) for q, T in zip(poses, right, strict=True)]
        for w in one + two
    }
    found = census(arm, poses)
    assert (found.single_slips, found.slip_pairs) == (len(one), len(two))
    assert found.unseen_by_tip == [w for w, o in off.items() if np.max(o, 0)[:3, 3].max() < 1e-9]
    assert found.unseen_by_pose == [w for w, o in off.items() if np.max(o) < 1e-9]
    assert found.unseen_by_tip


def test_census_rejects_invalid_pose():
    with pytest.raises(ArmError, match="q"):
        census(PANDA, [0, 1])
