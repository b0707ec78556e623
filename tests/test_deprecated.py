"""Test that a renamed name of the helpers still works, and warns with the new name."""

import pytest

from helpers.deprecated import deprecated_names
from helpers.robots import ELBOW


def test_unknown_name_of_a_module_is_no_attribute():
    with pytest.raises(AttributeError, match="has no attribute 'gone'"):
        deprecated_names("helpers.motion", old="join_traces")("gone")


def test_renamed_object_may_stand_in_another_module():
    get_renamed = deprecated_names("helpers.motion", old="helpers.robots.find_arm")
    with pytest.warns(DeprecationWarning, match=r"is now helpers.robots.find_arm"):
        assert get_renamed("old")("elbow arm") is ELBOW
