"""Test that the reference documents every public name that chapters use."""

import ast
import importlib
import inspect
import json
import re
from pathlib import Path

import pytest

from helpers import dynamics, kinematics, motion, rows, statics
from tools.numbering import list_notebooks

BOOK = Path(__file__).parents[1] / "book"
API = (BOOK / "api.md").read_text(encoding="utf-8")
MODULES = re.findall(r"automodule:: (helpers\.\w+|answers)", API)


def names_used():
    """Yield the names that cells use from modules of the helpers, as `helpers.motion.circle`.

    The instructors' page is the reference of what it uses: students need no `course`.
    """
    for path in sorted(set(list_notebooks()) - {BOOK / "instructors.ipynb"}):
        cells = json.loads(path.read_text(encoding="utf-8"))["cells"]
        code = "\n".join("".join(c["source"]) for c in cells if c["cell_type"] == "code")
        modules = {}
        for node in ast.walk(ast.parse(code)):
            if isinstance(node, ast.ImportFrom) and node.module == "helpers":
                modules |= {a.asname or a.name: f"helpers.{a.name}" for a in node.names}
            elif isinstance(node, ast.ImportFrom) and (node.module or "").startswith("helpers."):
                yield from (f"{node.module}.{a.name}" for a in node.names)
        for name, attribute in re.findall(r"\b(\w+)\.(\w+)", code):
            if name in modules:
                yield f"{modules[name]}.{attribute}"


def test_names_used_in_chapters_are_documented():
    public = {f"{name}.{n}" for name in MODULES for n in importlib.import_module(name).__all__}
    used = set(names_used())
    assert len(used) > 80
    assert used - public <= {"helpers.explorer.ArmExplorer", "helpers.explorer.ArmFigure"}


def test_public_names_have_docstrings():
    for name in MODULES:
        module = importlib.import_module(name)
        public = [getattr(module, n) for n in module.__all__]
        silent = [x for x in public if inspect.isroutine(x) or inspect.isclass(x) if not x.__doc__]
        assert not silent, name


# Rows of the glossary by the beginning of their meaning, with the docstrings that state the units.
UNITS_IN_CODE = {
    "variable of joint": (kinematics.jacobian, ["q"]),
    "link length, twist": (rows.Row, ["a", "alpha", "d", "theta"]),
    "[wrench]": (statics.static_torque, ["wrench"]),
    "joint torques of": (statics.static_torque, ["Returns"]),
    "time for one turn": (motion.circle, ["period"]),
    "radius of the circle": (motion.circle, ["radius"]),
    "gain of the feedback": (motion.trace, ["gain"]),
    "[torques]": (statics.gravity_torque, ["Returns"]),
    "the acceleration of gravity": (statics.gravity_torque, ["gravity"]),
    "[potential energy]": (statics.potential_energy, ["Returns"]),
    "mass of link": (rows.Body, ["mass", "com"]),
    "inertia matrix": (dynamics.mass_matrix, ["Returns"]),
    "inertia of a link": (rows.Body, ["inertia"]),
}
UNIT = r"(?<!\w)(?:1/s|kg m²|kg|m/s²|rad|N m|N|J|m|s)(?![\w²/])"


@pytest.mark.parametrize("meaning", UNITS_IN_CODE)
def test_glossary_gives_units_of_docstrings(meaning):
    glossary = (BOOK / "glossary.md").read_text(encoding="utf-8")
    row = rf"(?m)^\|[^|]*\| {re.escape(meaning)}[^|]*\|([^|]*)\|"
    (column,) = re.findall(row, glossary)
    function, entries = UNITS_IN_CODE[meaning]
    docstring = inspect.getdoc(function).replace("^2", "²")
    stated = []
    for entry in entries:
        (text,) = re.findall(rf"(?m)^ *{entry}:\s(.*(?:\n     +.*)?)", docstring)
        stated += re.findall(rf"\bin ({UNIT})(?:(?: or| and) ({UNIT}))?", text)[0]
    stated = [unit for unit in stated if unit]
    assert re.findall(UNIT, column)[: len(stated)] == stated
