"""Test that old names of the helpers still work, and warn with the new name."""

import importlib

import pytest

from helpers.deprecated import deprecated_names
from helpers.robots import ELBOW
from helpers.slips import census

RENAMED = [
    ("motion", "joined", "join_traces"),
    ("motion", "Report", "TraceReport"),
    ("robots", "named", "find_arm"),
    ("derive", "Step", "DerivationStep"),
    ("show", "Shown", "MarkdownOutput"),
    ("slips", "slips", "list_slips"),
    ("slips", "Slip", "TableSlip"),
    ("symbolic", "short", "abbreviate"),
    ("formulas", "short", "abbreviate"),
    ("plotting", "seen", "project_points"),
    ("plotting", "frames", "draw_frames"),
    ("plotting", "torques", "plot_torques"),
]


@pytest.mark.parametrize(("module", "old", "new"), RENAMED)
def test_old_name_warns_and_gives_the_new_object(module, old, new):
    module = importlib.import_module(f"helpers.{module}")
    with pytest.warns(DeprecationWarning, match=f"{old} is now .*{new}; the old name"):
        assert getattr(module, old) is getattr(module, new)


def test_old_attribute_warns_and_gives_the_new_value():
    counts = census(ELBOW, [[0.3, 0.5, -0.2]])
    with pytest.warns(DeprecationWarning, match=r"Census.one is now Census.single_slips"):
        assert counts.one == counts.single_slips


def test_unknown_name_of_a_module_is_no_attribute():
    with pytest.raises(AttributeError, match="has no attribute 'gone'"):
        deprecated_names("helpers.motion", old="join_traces")("gone")


def test_renamed_object_may_stand_in_another_module():
    get_renamed = deprecated_names("helpers.motion", old="helpers.robots.find_arm")
    with pytest.warns(DeprecationWarning, match=r"is now helpers.robots.find_arm"):
        assert get_renamed("old")("elbow arm") is ELBOW
