"""Test that every number in a chapter's prose appears, rounded, in a cell of the chapter.

Otherwise nobody would notice when a number is no longer true. The test reads every number with a
unit or with more than two digits. It skips block quotes of the reports, names, indices and
exponents.
"""

import re

import nbformat
import numpy as np
import pytest

from tools.numbering import list_notebooks

# Pages whose numbers a live figure or a command shows.
LIVE_PAGES = {"check_your_homework", "explorer", "instructors"}
NOTEBOOKS = [path for path in list_notebooks() if path.stem not in LIVE_PAGES]
NOT_PROSE = re.compile(
    r"^> >.*$"  # the words of a report
    r"|<[^>]*>|\[[^]]*\]\((?:(?:\.\./)?references\.md)?#\w+\)"  # tags, works
    r"|\]\([^)]*\)|Chapter \d"  # links
    r"|\[Fig\. [\d.]+|\[\([\d.]+\)|^\*\*Fig\. [\d.]+|^### Exercise [\d.]+|\\tag\{[\d.]+\}"
    r"|10\^\{[^}]*\}|[_^]\{[^}]*\}|[_^]\w+",  # exponents, indices
    re.M,
)
NUMBER = r"(?<![\w.])(\d+(?:(?:\\,|[ \u00a0])\d{3}(?!\d))*(?:\.\d+)?)(?![\w.]*\w)"
# A number printed by a cell has the prose's unit or the matching SI unit.
UNITS = {
    "mm": (1, 1000),
    "cm": (1, 100, 0.1),
    "µm": (1, 1000, 1e6),
    "°": (1, 180 / np.pi),
    "degrees": (1, 180 / np.pi),
    "%": (1, 100),
    "kW": (1, 1e-3),
    "mm/s": (1, 1000),
    "mm/s²": (1, 1000),
} | dict.fromkeys(["m", "s", "ms", "kg", "N", "J", "W", "Hz", "rad", "rad/s", "m/s"], (1,))
UNIT = (
    r"(?:\\,|[\s~$]|\\text\{|\\mathrm\{|&nbsp;)*("
    + "|".join(
        re.escape(unit) + (r"(?![\w/])" if unit[-1].isalpha() else "")
        for unit in sorted(UNITS, key=len, reverse=True)
    )
    + ")"
)


def prose(cells):
    text = "\n".join(cell.source for cell in cells if cell.cell_type == "markdown")
    return NOT_PROSE.sub(" ", text.replace(r"\ ", " "))


def numbers_of(cells):
    """Return all numbers in code and printed outputs."""
    texts = []
    for cell in cells:
        if cell.cell_type == "code":
            texts.append(cell.source)
            for output in cell.outputs:
                texts.append(output.get("text", ""))
                texts += [v for k, v in output.get("data", {}).items() if k.startswith("text/")]
    found = re.findall(r"(?<![\w.])\d+\.?\d*(?:e-?\d+)?", "\n".join(texts))
    return np.unique(np.array(found, float))


def find_unbacked_numbers(cells):
    """Return the numbers of the prose that no cell contains after rounding and change of unit."""
    have = numbers_of(cells)
    missing = []
    for match in re.finditer(NUMBER + f"(?:{UNIT})?", prose(cells)):
        written, unit = re.sub(r"\\,|[ \u00a0]", "", match[1]), match[2]
        digits = written.replace(".", "").lstrip("0")
        if unit or len(digits) > 2:
            half = 0.5 * 10.0 ** -len(written.partition(".")[2])
            scaled = np.outer(UNITS.get(unit, (1, 1000, 180 / np.pi)), have)
            if not (np.abs(scaled - float(written)) <= half * (1 + 1e-9)).any():
                missing.append(match[0])
    return missing


def _make_cells(prose, source, output=""):
    code = nbformat.v4.new_code_cell(source)
    code.outputs = [nbformat.v4.new_output("stream", text=output)]
    return [nbformat.v4.new_markdown_cell(prose), code]


@pytest.mark.parametrize(
    ("prose", "source", "output", "missing"),
    [
        ("It is 7.8 mm off.", "check('off', off, 0.0078)", "", []),
        ("It is 7.9 mm off.", "check('off', off, 0.0078)", "", ["7.9 mm"]),
        ("The tip is at $x = 0.679$ m.", "tip", "[0.6735 0. 0.8195]", ["0.679$ m"]),
        ("The pen tilts by 12.3°.", "print(tilt)", "12.3412\n", []),
        ("The pen tilts by 0.2154 rad.", "print(tilt)", "12.3412\n", ["0.2154 rad"]),
        ("2\u00a0000 targets, 51 % in front", "n = 2000", "0.513", []),
        ("$571.6\\sin\\theta_1$ and $10^{-6}$ m", "a_3 = 0.5716", "", []),
        ("$x_{100}$ of 12 joints, [below](#sec-100), [Fig. 1.12](#fig-100)", "", "", []),
        ("By [(1.12)](#eq-a), x \\tag{1.12}\n### Exercise 1.12: A\n**Fig. 1.12.** B", "", "", []),
        ("> > 118 mm\n>\n> as the report says", "", "", []),
    ],
)
def test_number_without_cell_is_detected(prose, source, output, missing):
    assert find_unbacked_numbers(_make_cells(prose, source, output)) == missing


@pytest.mark.parametrize("path", NOTEBOOKS, ids=lambda path: path.stem)
def test_prose_numbers_appear_in_a_cell(path):
    assert find_unbacked_numbers(nbformat.read(path, as_version=4).cells) == []
