"""Test that a renamed name of the helpers still works, and warns with the new name."""

import numpy as np
import pytest

from helpers import kinematics
from helpers.deprecated import deprecated_names
from helpers.robots import ELBOW


def test_old_name_of_jacobian_in_tool_axes_still_works():
    with pytest.warns(DeprecationWarning, match=r"is now helpers.kinematics.jacobian;"):
        old_name = kinematics.jacobian_in_frame
    q = ELBOW.home
    assert np.array_equal(old_name(ELBOW, q, 3), kinematics.jacobian(ELBOW, q, "tool"))


def test_old_names_of_locked_values_still_work():
    locked = ELBOW.lock(2, at=0.5)
    with pytest.warns(DeprecationWarning, match=r"Arm.to_free is now Arm.insert_locked;"):
        assert locked.to_free([1, 3]).tolist() == [1, 0.5, 3]
    with pytest.warns(DeprecationWarning, match=r"Arm.from_free is now Arm.remove_locked;"):
        assert locked.from_free([1, 2, 3]).tolist() == [1, 3]


def test_unknown_name_raises_attribute_error():
    with pytest.raises(AttributeError, match="has no attribute 'gone'"):
        deprecated_names("helpers.motion", old="join_traces")("gone")


def test_renamed_object_may_be_in_another_module():
    get_renamed = deprecated_names("helpers.motion", old="helpers.robots.find_arm")
    with pytest.warns(DeprecationWarning, match=r"is now helpers.robots.find_arm"):
        assert get_renamed("old")("elbow arm") is ELBOW
