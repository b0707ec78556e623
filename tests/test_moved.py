"""Test that old addresses lead to the new places of their sections."""

from tools.moved import find_targets

IDS = {"05_x": {"kept"}, "further/ur": {"sec-ur", "eq-1"}, "exercises/x": {"ex-1"}, "where": {"a"}}


def test_moved_anchor_is_found_on_its_new_page():
    old = {"05_x": ["kept", "sec-ur", "ex-1"]}
    targets = find_targets(old, {}, IDS)
    assert targets == {"05_x": {"sec-ur": "further/ur#sec-ur", "ex-1": "exercises/x#ex-1"}}


def test_renamed_anchor_is_found_in_the_table():
    moved = {"05_x#old-name": "further/ur#eq-1", "gone": "further/ur"}
    targets = find_targets({"05_x": ["old-name"], "gone": ["sec-ur", "top"]}, moved, IDS)
    assert targets["05_x"] == {"old-name": "further/ur#eq-1"}
    assert targets["gone"] == {"sec-ur": "further/ur#sec-ur", "top": "further/ur"}


def test_removed_anchor_has_an_empty_target():
    assert find_targets({"05_x": ["a"]}, {}, IDS) == {"05_x": {"a": ""}}
