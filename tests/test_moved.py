"""Test that old addresses lead to the places where their parts stand today."""

from tools.moved import find_targets

IDS = {"05_x": {"kept"}, "further/ur": {"sec-ur", "eq-1"}, "exercises/x": {"ex-1"}, "where": {"a"}}


def test_anchor_that_moved_is_found_beside_the_chapters():
    old = {"05_x": ["kept", "sec-ur", "ex-1"]}
    targets = find_targets(old, {}, IDS)
    assert targets == {"05_x": {"sec-ur": "further/ur#sec-ur", "ex-1": "exercises/x#ex-1"}}


def test_table_decides_for_anchors_with_another_name():
    moved = {"05_x#old-name": "further/ur#eq-1", "gone": "further/ur"}
    targets = find_targets({"05_x": ["old-name"], "gone": ["sec-ur", "top"]}, moved, IDS)
    assert targets["05_x"] == {"old-name": "further/ur#eq-1"}
    assert targets["gone"] == {"sec-ur": "further/ur#sec-ur", "top": "further/ur"}


def test_removed_anchor_has_an_empty_target():
    assert find_targets({"05_x": ["a"]}, {}, IDS) == {"05_x": {"a": ""}}
