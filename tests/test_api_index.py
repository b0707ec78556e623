"""Test that the calls of the page "The helpers package" exist."""

import importlib
import re
from pathlib import Path

import pytest

from helpers.arm import Arm

PAGE = Path(__file__).parents[1] / "book" / "api.md"
INDEX = PAGE.read_text(encoding="utf-8").partition("## By task")[2].partition("\n## ")[0]
CALLS = sorted(set(re.findall(r"`?\b(\w+)\.(\w+)\(", INDEX)))


@pytest.mark.parametrize(("owner", "name"), CALLS)
def test_call_of_the_index_exists(owner, name):
    home = Arm if owner in ("Arm", "arm") else importlib.import_module(f"helpers.{owner}")
    assert callable(getattr(home, name))


def test_index_covers_each_module_of_calculations():
    assert {owner for owner, _ in CALLS} >= {
        "checks", "inverse", "kinematics", "motion", "other_programs", "statics", "symbolic",
    }  # fmt: skip
