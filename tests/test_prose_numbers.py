"""Test that every number in the book's prose appears, rounded, in a cell.

Otherwise nobody would notice when a number is no longer true. The test reads every number with a
unit or with more than two digits. It skips block quotes of the reports, names, indices and
exponents. A number of a notebook appears in the notebook itself. A number of a Markdown page
appears in a notebook to which its section links, or in any if it links to none. Counts of exercises
are also read in words. A torque that a cell lists must belong to the joint that the prose names.
"""

import re
from functools import cache
from pathlib import Path

import nbformat
import numpy as np
import pytest

from tools.numbering import list_notebooks

BOOK = Path(__file__).parents[1] / "book"
NOTEBOOKS = list_notebooks()
# Pages whose numbers a program measures in minutes: benchmarks/ and tests/measure/random_answers/.
MEASURED_PAGES = {"benchmarks", "judging"}
MARKDOWN = [path for path in sorted(BOOK.glob("*.md")) if path.stem not in MEASURED_PAGES]
# Numbers that no cell prints.
SHOWN_ELSEWHERE = {
    "check_your_homework": {"36.3", "1.0003"},  # of answers to type
    "explorer": {"43 mm", "10 mm"},  # of the live figure
    "instructors": {"201"},  # of a command
    "errata": {
        *("118 mm", "127.3 mm"),  # in robot_data
        "999",  # the last of 1000 steps that count from 0
    },
}
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


# A torque with a decimal after the joint that carries it. The unit may be left out when repeated.
JOINT_TORQUE = re.compile(
    r"joints? (\d)(?: and (\d))?(?!\d)((?:(?!joint)[^.:;\d$|°])*?)"
    r"(?<![\w.])(\d+\.\d+)(?!\d|[ \u00a0]?(?:°|%|(?:[cm]?m|rad|s|kg)\b)|[ \u00a0]N m in joint)"
)


def list_rows_of_numbers(cells):
    """Return the lists of four or more numbers that stand in brackets in code and outputs."""
    texts = [cell.source for cell in cells if cell.cell_type == "code"]
    texts += [
        text
        for cell in cells
        for output in cell.get("outputs", [])
        for text in (output.get("text", ""), output.get("data", {}).get("text/plain", ""))
    ]
    lists = re.findall(r"[\[(]([-\d.,\s]+)[\])]", "\n".join(texts))
    rows = [np.array(re.findall(r"\d+\.?\d*", numbers), float) for numbers in lists]
    return [row for row in rows if len(row) >= 4]


def find_torques_of_other_joints(cells):
    """Return the torques that the cells list, but not at the joints which the prose names."""
    rows, wrong = list_rows_of_numbers(cells), []
    for match in JOINT_TORQUE.finditer(prose(cells)):
        joints, torque = [int(match[k]) for k in (1, 2) if match[k]], match[4]
        half = 0.5 * 10.0 ** -len(torque.partition(".")[2])
        places = [np.abs(row - float(torque)) <= half * (1 + 1e-9) for row in rows]
        listed = {int(place) + 1 for row in places for place in np.flatnonzero(row)}
        if listed and not listed & set(joints):
            wrong.append(match[0])
    return wrong


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
    missing = find_unbacked_numbers(_read_cells(path))
    assert set(missing) == SHOWN_ELSEWHERE.get(path.stem, set())


@pytest.mark.parametrize("path", NOTEBOOKS, ids=lambda path: path.stem)
def test_prose_gives_torques_at_their_joints(path):
    assert find_torques_of_other_joints(_read_cells(path)) == []


@pytest.mark.parametrize(
    ("prose", "wrong"),
    [
        ("Joint 2 needs nothing. Here joint 3 carries 2.2 N m and joint 4 1.9.", []),
        ("Here joint 4 carries 2.2 N m.", ["joint 4 carries 2.2"]),
        ("It changes joint 3 by 2.2 N m, joint 2 by 1.9.", ["joint 2 by 1.9"]),
        ("There joints 2 and 3 carry 2.2 N m less.", []),
        ("It is 0.5 N m in joint 3 and 1.9 N m in joint 4. Joint 3 is 1.9 m long.", []),
    ],
)
def test_torque_of_another_joint_is_detected(prose, wrong):
    cells = _make_cells(prose, "", "apart (N m): [0. 0.5 2.2 1.92]")
    assert find_torques_of_other_joints(cells) == wrong


@cache
def _read_cells(path):
    return nbformat.read(path, as_version=4).cells


@pytest.mark.parametrize("path", MARKDOWN, ids=lambda path: path.stem)
def test_numbers_of_a_markdown_page_appear_in_a_cell(path):
    missing = set()
    for section in re.split(r"^(?=#+ )", path.read_text(encoding="utf-8"), flags=re.M):
        linked = [BOOK / name for name in re.findall(r"\]\(([\w/]+\.ipynb)", section)]
        code = [
            cell
            for notebook in linked or NOTEBOOKS
            for cell in _read_cells(notebook)
            if cell.cell_type == "code"
        ]
        cells = [nbformat.v4.new_markdown_cell(section), *code]
        missing |= {*find_unbacked_numbers(cells)}
        assert find_torques_of_other_joints(cells) == []
    assert missing == SHOWN_ELSEWHERE.get(path.stem, set())


COUNT_WORDS = re.findall(r"\w+", "one two three four five six seven eight nine ten eleven twelve")
COUNT = re.compile(
    rf"\b({'|'.join(COUNT_WORDS)}) exercises\b(?:[^.]*? are on \[[^]]*\]\(([^)#]+))?", re.I
)


def find_wrong_counts(text, count_exercises):
    """Return the counts, in words, that differ from the exercises of this page or a linked one."""
    return [
        word
        for word, link in COUNT.findall(text)
        if COUNT_WORDS.index(word.lower()) + 1 != count_exercises(link)
    ]


def test_wrong_count_in_words_is_detected():
    counts = {"": 11, "other.ipynb": 2}
    assert find_wrong_counts("Ten exercises to chapter 5.", counts.get) == ["Ten"]
    assert find_wrong_counts("Eleven exercises to chapter 5.", counts.get) == []
    assert find_wrong_counts("Two exercises are on [a page](other.ipynb#a).", counts.get) == []


@pytest.mark.parametrize("path", NOTEBOOKS, ids=lambda path: path.stem)
def test_exercises_are_counted_right(path):
    def join_text(notebook):
        return "\n".join(c.source for c in _read_cells(notebook) if c.cell_type == "markdown")

    def count_exercises(link):
        page = (path.parent / link).resolve() if link else path
        return len(re.findall(r"^### Exercise", join_text(page), re.M))

    assert find_wrong_counts(join_text(path), count_exercises) == []
