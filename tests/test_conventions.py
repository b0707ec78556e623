"""Test that tables in the standard and the modified convention describe the same arm."""

import numpy as np
from hypothesis import given

from helpers.arm import Arm, fixed, revolute
from helpers.conventions import modified_from_standard, standard_from_modified
from helpers.kinematics import forward_kinematics
from tests.laws import joint_vectors, random_arms, slow_modified_frames


@given(arm=random_arms)
def test_standard_from_modified_matches_craigs_product(arm):
    q = joint_vectors(arm, ())
    converted = Arm("converted", standard_from_modified(arm.rows))
    np.testing.assert_allclose(
        forward_kinematics(converted, q), slow_modified_frames(arm.rows, q)[-1], atol=1e-13
    )


@given(arm=random_arms)
def test_modified_from_standard_keeps_the_poses(arm):
    q = joint_vectors(arm, ())
    modified = modified_from_standard(arm.rows)
    tip = slow_modified_frames(modified, q)[-1]
    np.testing.assert_allclose(tip, forward_kinematics(arm, q), atol=1e-13)


def test_conversion_shifts_a_and_alpha_by_one_row():
    standard = standard_from_modified([revolute(d=1), revolute(2, "pi/2"), fixed(3, 0, 4)])
    assert standard == (revolute(2, "pi/2", 1), revolute(3), fixed(d=4))
    assert modified_from_standard(standard) == (revolute(d=1), revolute(2, "pi/2"), fixed(3, 0, 4))


def test_tilted_base_becomes_a_fixed_row():
    assert standard_from_modified([revolute(1, "pi/2")])[0] == fixed(1, "pi/2")
