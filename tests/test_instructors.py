"""Test that an arm and a chapter added as the instructors' page describes are accepted."""

import inspect

import nbformat
from nbformat.v4 import new_code_cell, new_markdown_cell, new_notebook

from helpers.checks import compare_tables
from helpers.explorer import ArmExplorer
from helpers.robots import ARMS
from tests import test_notebooks
from tests.laws import ALL_ARMS, instructors_arm
from tools.refresh import refresh_notebook

LAWS_OF_A_NOTEBOOK = [
    law
    for name, law in inspect.getmembers(test_notebooks, inspect.isfunction)
    if name.startswith("test_") and "path" in inspect.signature(law).parameters
]


def test_instructors_arm_is_in_all_arms():
    arm = instructors_arm()
    assert arm in ALL_ARMS
    assert arm.name not in {other.name for other in ARMS}
    assert "prismatic" in {row.joint.kind for row in arm.rows}


def test_instructors_arm_works_in_explorer_and_checks():
    arm = instructors_arm()
    assert ArmExplorer(arm, arms=[*ARMS, arm]).arm_name == arm.name
    assert not compare_tables(arm, arm).findings


def a_chapter():
    """Run steps 1 and 2 of the page for the smallest course."""
    title = "# Dynamics\n\nWhat moves it?\n\nAfter this chapter you can\n\n- say what moves it."
    names = ("checks import check", "plotting import use_book_style")
    imports = "".join(f"from helpers.{name}\n" for name in names) + "\nuse_book_style()"
    cells = [
        new_markdown_cell(title),
        new_code_cell(imports),
        new_markdown_cell("## The sum\n\nTwo and two."),
        new_code_cell('check("two and two", 2 + 2, 4)'),
    ]
    about = {"myst": {"html_meta": {"description": "What moves an arm."}}}
    return new_notebook(cells=cells, metadata=about)


def test_new_chapter_passes_notebook_tests(tmp_path):
    path = tmp_path / "06_dynamics.ipynb"
    nbformat.write(a_chapter(), path)
    refresh_notebook(path)  # step 4
    assert len(LAWS_OF_A_NOTEBOOK) > 8
    for law in LAWS_OF_A_NOTEBOOK:
        law(path)
