"""An arm's answer sheet as a page: every answer folded under the question, set in plain HTML that
breaks its lines anywhere.

Formulas are HTML rather than MathJax: they are there at once on a phone, and no term of a sum is
cut at any width. The blocks that are copied stand in <template> elements, from which ``answers.js``
makes its buttons.
"""

import json
import re
from html import escape
from itertools import chain
from pathlib import Path
from typing import NamedTuple

import numpy as np
import sympy as sp

from helpers.arm import Arm, Row
from helpers.inputs import ArmError, listed, must_be
from helpers.sheets import programs
from helpers.sheets.content import Array, Item, Sheet
from helpers.sheets.formulas import HTML, html_name, pieces, written

_WIDEST = 19.0  # em; what a phone has room for beside the name of a matrix
_TALLEST = 3  # terms of an entry with which a matrix stays a matrix
_MINUS = "−"

LANGUAGES = {
    "LaTeX": programs.as_latex,
    "SymPy": programs.as_sympy,
    "NumPy": programs.as_numpy,
    "MATLAB": programs.as_matlab,
}


def answer(sheet: Sheet, item: Item, also: tuple[Sheet, ...] = ()) -> str:
    """One answer, folded: the formula, its numbers at home, for each sheet of `also` too, and the
    blocks to copy.
    """
    numbers = "".join(_numbers(item, at) for at in _at_home(sheet, item, also))
    blocks = "".join(
        f'<template data-language="{name}">{escape(block(sheet, item), quote=False)}</template>'
        for name, block in LANGUAGES.items()
    )
    return (
        f'<details class="answer" id="{_id(item)}"><summary>{title(item)}</summary>\n'
        f"{_formula(sheet, item)}{numbers}{blocks}</details>\n"
    )


def _id(item: Item) -> str:
    return re.sub(r"\W|_", "-", item.name).lower()


def title(item: Item) -> str:
    """An answer's name in HTML."""
    letter, _, index = item.name.partition("_")
    plain = {"det": "det <i>J</i>", "G": "<i>g</i>(<i>q</i>)"}
    if letter in plain:
        return plain[letter]
    if letter == "T":
        return f"<sup>0</sup><i>T</i><sub>{index[1:]}</sub>"
    return html_name(item.name)


# Formulas


def _formula(sheet: Sheet, item: Item) -> str:
    value = sheet.shortened(item)
    entries = [[pieces(entry, HTML) for entry in value.row(i)] for i in range(value.rows)]
    if not item.is_number and _fits(entries):
        return _matrix(title(item), [[_spans(entry) for entry in row] for row in entries])
    lines = [
        f"<p>{label} = {_spans(entry)}</p>"
        for label, entry in zip(_labels(sheet, item), chain(*entries), strict=True)
    ]
    return f'<div class="entries">{"".join(lines)}</div>\n'


def _fits(entries: list[list[list[str]]]) -> bool:
    """Whether a phone shows them as a matrix: each column as wide as its longest term, no entry too
    tall.
    """
    columns = zip(*entries, strict=True)
    width = sum(max(_em(term) for entry in column for term in entry) + 0.8 for column in columns)
    return width <= _WIDEST and all(len(entry) <= _TALLEST for row in entries for entry in row)


def _em(html: str) -> float:
    """About how wide a text is; an index is set smaller."""
    low = sum(len(index) for index in re.findall(r"<su[bp]>(.*?)</su[bp]>", html))
    return 0.55 * (len(re.sub(r"<[^>]+>", "", html)) - low) + 0.42 * low


def _matrix(name: str, rows: list[list[str]], kind: str = "") -> str:
    cells = "".join(f"<tr>{''.join(f'<td>{cell}</td>' for cell in row)}</tr>" for row in rows)
    columns = f' style="--columns: {len(rows[0])}"' if kind else ""
    return f'<div class="matrix{kind}"{columns}><span>{name} =</span><table>{cells}</table></div>\n'


def _spans(entry: list[str]) -> str:
    return " ".join(f"<span>{term}</span>" for term in entry)


def _labels(sheet: Sheet, item: Item) -> list[str]:
    """The names of its entries: by row and column, by component, by joint, or the number's own."""
    name, (rows, columns) = title(item), item.value.shape
    if item.is_number:
        return [name]
    if item.name == "G":
        return [f"<i>g</i><sub>{joint}</sub>" for joint in sheet.arm.joints]
    name = name if item.name == "J" else f"({name})"
    if not item.is_matrix:
        return [f"{name}<sub>{programs.component(item, i + 1)}</sub>" for i in range(rows)]
    return [f"{name}<sub>{i + 1}{k + 1}</sub>" for i in range(rows) for k in range(columns)]


# Numbers


def _at_home(sheet: Sheet, item: Item, also: tuple[Sheet, ...]) -> list[tuple[str, Array]]:
    """The item's numbers for each arm whose numbers differ, with what they are called."""
    found = [(sheet.arm.name, item.home)]
    for other in also:
        twin = next(o for o in other.items if o.name == item.name)
        if not np.allclose(twin.home, item.home, rtol=0, atol=5e-5):
            found.append((other.arm.name, twin.home))
    if len(found) == 1:
        return [("", item.home)]
    return found


def _numbers(item: Item, at: tuple[str, Array]) -> str:
    of, numbers = at
    label = f"In numbers{f', {escape(of)}' if of else ''}:"
    if item.is_number:
        value = _together(f"{title(item)} = {_digits(float(numbers[0, 0]), 6)}")
        return f"<p>{label} {value}</p>\n"
    rows = [[_digits(float(x)) for x in row] for row in numbers]
    return f"<p>{label}</p>{_matrix(title(item), rows, ' numbers')}"


def _digits(value: float, digits: int = 4) -> str:
    """A number rounded, without the zeros at its end."""
    text = f"{round(value, digits) + 0.0:.{digits}f}".rstrip("0").rstrip(".")
    return text.replace("-", _MINUS)


# Pages


class Section(NamedTuple):
    """A part of a sheet: its heading, the question in HTML, and the answers to it."""

    heading: str
    question: str
    body: str


def sections(arm: Arm, also: tuple[Arm, ...] = ()) -> list[Section]:
    """The parts of an arm's sheet; `also` are the same arm with other lengths, whose numbers stand
    beside its own.

    Raises ArmError for an arm that has a letter which programs cannot use, and for one of `also`
    with other rows.
    """
    also = listed(also, "also", "arms with the same rows")
    sheet, others = Sheet(arm), tuple(Sheet(other) for other in also)
    for other in also:
        if other.rows != arm.rows:
            raise ArmError(
                f"{other.name} has other rows than {arm.name}; expected other values only"
            )
    found = [
        ("Link matrices", _ASK_LINKS, sheet.links),
        ("Frames seen from the base", _ASK_FRAMES, sheet.frames),
        ("Origins", _ASK_ORIGINS, sheet.origins),
        ("Axes", _ASK_AXES, sheet.axes),
        ("Jacobian", _ASK_JACOBIAN.format(n=len(arm.rows)) + _joints(arm), [sheet.jacobian]),
    ]
    if sheet.determinant:
        found.append(("Determinant", _ask_determinant(sheet), [sheet.determinant]))
    if sheet.energy and sheet.torques:
        found.append(("Gravity", _ASK_GRAVITY + _joints(arm), [sheet.energy, sheet.torques]))
    answers = [
        Section(heading, question, "".join(answer(sheet, item, others) for item in items))
        for heading, question, items in found
    ]
    masses = "".join(_masses(s) for s in (sheet, *others) if s.arm.bodies)
    return [Section("Table", _given(sheet, others), table(arm) + masses), *answers]


def markdown(
    arm: Arm, heading: str, lead: str, also: tuple[Arm, ...] = (), description: str = ""
) -> str:
    """The sheet as a page of the book, in MyST Markdown.

    Args:
        arm: whose sheet.
        heading, lead: the page's title and what is said first, in Markdown.
        also: the same arm with other lengths, whose numbers stand beside.
        description: one sentence for search engines.

    Raises ArmError for an arm of `also` with other rows, and for letters that programs cannot use.
    """
    must_be(description, str, "description")
    must_be(heading, str, "heading")
    must_be(lead, str, "lead")
    meta = (
        f"---\nmyst:\n  html_meta:\n    description: {json.dumps(description)}\n---\n\n"
        if description
        else ""
    )
    parts = [f"{meta}# {heading}\n\n{lead}\n", _raw(_ASSETS.format(root="../_static") + _TOOLS)]
    for section in sections(arm, also):
        parts.append(f"## {section.heading}\n\n{_raw(section.question + section.body)}")
    return "\n".join(parts)


def _raw(html: str) -> str:
    return f"```{{raw}} html\n{html.strip()}\n```\n"


def document(arm: Arm) -> str:
    """The sheet as one HTML file that needs nothing else."""
    style, script = ((_STATIC / f"answers.{kind}").read_text("utf-8") for kind in ("css", "js"))
    body = "".join(f"<h2>{s.heading}</h2>\n{s.question}{s.body}" for s in sections(arm))
    name = escape(arm.name)
    return (
        f'<!doctype html>\n<html lang="en"><head><meta charset="utf-8"><title>{name}:'
        f" answers</title>\n"
        '<meta name="viewport" content="width=device-width, initial-scale=1">\n'
        f'<style>\n{style}</style></head>\n<body class="sheet"><main>\n<h1>{name}: answers</h1>\n'
        f"{_TOOLS}{body}</main>\n<script>\n{script}</script></body></html>\n"
    )


_STATIC = Path(__file__).parent / "static"
_ASSETS = (
    '<link rel="stylesheet" href="{root}/answers.css">'
    '<script defer src="{root}/answers.js"></script>\n'
)
# Buttons that hold the place of those that the script makes, so that nothing moves when it does.
_WORDS = ("Open all answers", *(f"Copy all as {language}" for language in LANGUAGES))
_BUTTONS = "".join(f'<button type="button" disabled>{words}</button>' for words in _WORDS)
_TOOLS = f'<p class="answer-tools">{_BUTTONS}</p>\n'

_ASK_LINKS = (
    "<p><strong>First try.</strong> Put each row of the table into <i>A<sub>i</sub></i> ="
    " Rot<sub><i>z</i></sub>(<i>θ<sub>i</sub></i>)"
    " Trans<sub><i>z</i></sub>(<i>d<sub>i</sub></i>) Trans<sub><i>x</i></sub>(<i>a<sub>i</sub></i>)"
    " Rot<sub><i>x</i></sub>(<i>α<sub>i</sub></i>).</p>\n"
)
_ASK_FRAMES = (
    "<p><strong>First try.</strong> Multiply the link matrices: <sup>0</sup><i>T<sub>i</sub></i> ="
    " <i>A</i><sub>1</sub> … <i>A<sub>i</sub></i>. Angles about parallel axes add up.</p>\n"
)
_ASK_ORIGINS = (
    "<p><strong>First try.</strong> Where is the origin <i>o<sub>i</sub></i> of each frame?"
    " Fourth column of"
    " <sup>0</sup><i>T<sub>i</sub></i>, first three rows (m).</p>\n"
)
_ASK_AXES = (
    "<p><strong>First try.</strong> Which way does each <i>z<sub>i</sub></i> point? Third column of"
    " <sup>0</sup><i>T<sub>i</sub></i>, first three rows.</p>\n"
)
_ASK_JACOBIAN = (
    "<p><strong>First try.</strong> One column for each joint: where it turns,"
    " <i>z</i><sub><i>i</i>−1</sub> × (<i>o</i><sub>{n}</sub> −"
    " <i>o</i><sub><i>i</i>−1</sub>) over <i>z</i><sub><i>i</i>−1</sub>; where it slides,"
    " <i>z</i><sub><i>i</i>−1</sub> over 0."
    " Rows are (<i>v<sub>x</sub></i>, <i>v<sub>y</sub></i>, <i>v<sub>z</sub></i>,"
    " <i>ω<sub>x</sub></i>,"
    " <i>ω<sub>y</sub></i>, <i>ω<sub>z</sub></i>) in base axes, at the tip.</p>\n"
)
_ASK_GRAVITY = (
    "<p><strong>First try.</strong> The potential energy <i>P</i> = <i>g</i> Σ <i>m<sub>i</sub>"
    " h<sub>i</sub></i> (J), with"
    " <i>h<sub>i</sub></i> the height of link <i>i</i>’s centre of mass, whose coordinates in"
    " frame <i>i</i> are"
    " (<i>x</i><sub>c<i>i</i></sub>, <i>y</i><sub>c<i>i</i></sub>, <i>z</i><sub>c<i>i</i></sub>);"
    " then what holds the arm"
    " against its weight, <i>g</i>(<i>q</i>) = ∂<i>P</i>/∂<i>q</i>. Programs call it"
    " <code>G</code>, for <i>g</i> is the"
    " acceleration of gravity there.</p>\n"
)


def _joints(arm: Arm) -> str:
    """Which joints the columns of J and the entries of g belong to, where that is not all rows."""
    if arm.dof == len(arm.rows):
        return ""
    numbers = ", ".join(map(str, arm.joints))
    return f"<p>Joints that move, in this order: {numbers}.</p>\n"


def _ask_determinant(sheet: Sheet) -> str:
    rows = "" if sheet.arm.dof == 6 else " of the first three rows"
    return (
        "<p><strong>First try.</strong> At which poses does the arm lose a freedom? Where det"
        f" <i>J</i>{rows} is 0.</p>\n{_factors(sheet)}"
    )


def _factors(sheet: Sheet) -> str:
    """In words which factors the determinant has, for the reader who has opened it."""
    if sheet.determinant is None:
        return ""
    value = sheet.shortened(sheet.determinant)[0, 0]
    turning = set(sheet.short_names.values()) | {sp.Symbol(name) for name in sheet.arm.variables}
    factors = [f.as_base_exp()[0] for f in sp.Mul.make_args(value) if f.free_symbols & turning]
    if not value:
        return "<p>This one is 0 everywhere.</p>\n"
    if len(factors) < 2:
        return "<p>For this arm it does not fall into factors.</p>\n" if value.is_Add else ""
    return f"<p>It falls into {len(factors)} factors that depend on the pose.</p>\n"


# What stands above the answers


def _given(sheet: Sheet, others: tuple[Sheet, ...]) -> str:
    """The values of the letters, the pose of the numbers, and the short names, in words."""
    arm = sheet.arm
    home = ", ".join(
        _together(f"{html_name(name)} = {_joint_value(value)}")
        for name, value in zip(arm.variables, arm.home, strict=True)
    )
    lines = [f"{escape(s.arm.name)}: {_values(s)}." for s in (sheet, *others) if s.arm.values]
    zero = [html_name(name) for name, value in arm.values.items() if not value]
    if zero:
        lines.append(f"What is 0, here {', '.join(zero)}, is left out of the formulas.")
    lines.append(f"Numbers are given at {home} (rad; m where a joint slides), rounded.")
    lines.append(f"Short names: {_legend(sheet)}.")
    return "".join(f"<p>{line}</p>\n" for line in lines)


def _together(words: str) -> str:
    """What no line may part."""
    return words.replace(" ", "\N{NO-BREAK SPACE}")


def _values(sheet: Sheet) -> str:
    """The arm's own letters, lengths and odd angles."""
    return ", ".join(
        _together(f"{html_name(name)} = {_plain(value)}")
        for name, value in sheet.arm.values.items()
    )


def _masses(sheet: Sheet) -> str:
    """The masses and centres of mass of an arm's links, a row each."""
    of = escape(sheet.arm.name)
    head = "".join(f"<th>{name}</th>" for name in ("link", "<i>m</i>", *map(_centre, "xyz")))
    rows = "".join(
        f"<tr><td>{i}</td>"
        + "".join(f"<td>{_plain(_entry(sheet, n))}</td>" for n in _letters(i))
        + "</tr>"
        for i in range(1, len(sheet.arm.rows) + 1)
    )
    return (
        f"<p>{of}: masses (kg), and centres of mass (m) in the frame that moves with each link;"
        f" <i>g</i> = 9.81 m/s².</p>\n"
        f'<table class="table dh"><thead><tr>{head}</tr></thead><tbody>{rows}</tbody></table>\n'
    )


def _letters(i: int) -> list[str]:
    return [f"m_{i}", *(f"{c}_c{i}" for c in "xyz")]


def _entry(sheet: Sheet, name: str) -> float:
    return sheet.values.get(name, 0.0)


def _centre(letter: str) -> str:
    return f"<i>{letter}</i><sub>c</sub>"


def _plain(value: float) -> str:
    return f"{value:.10g}".replace("-", _MINUS)


def _legend(sheet: Sheet) -> str:
    """c_23 = cos(q_2 + q_3) and the like, each index once, single joints in general."""
    sums = {
        n.name: f
        for f, n in sheet.short_names.items()
        if isinstance(f, sp.cos) and f.args[0].is_Add
    }
    general = (
        "<i>c<sub>i</sub></i> = cos(<i>q<sub>i</sub></i>),"
        " <i>s<sub>i</sub></i> = sin(<i>q<sub>i</sub></i>)"
    )
    return ", ".join(
        [general, *(f"{html_name(n)} = {written(f, HTML)}" for n, f in sorted(sums.items()))]
    )


def _joint_value(value: float) -> str:
    return programs.angle(value, HTML).replace("-", _MINUS)


def table(arm: Arm) -> str:
    """The arm's table in HTML."""
    head = "".join(
        f"<th>{name}</th>" for name in ("row", "<i>a</i>", "<i>α</i>", "<i>d</i>", "<i>θ</i>")
    )
    rows = "".join(_table_row(i, row) for i, row in enumerate(arm.rows, 1))
    return f'<table class="table dh"><thead><tr>{head}</tr></thead><tbody>{rows}</tbody></table>\n'


def _table_row(i: int, row: Row) -> str:
    q = sp.Symbol(f"q_{i}")
    turns, slides = (int(row.joint.kind == kind) for kind in ("revolute", "prismatic"))
    a, alpha, d, theta = (
        sp.sympify(str(e), locals=_symbols(str(e)), rational=True)
        for e in (row.a, row.alpha, row.d, row.theta)
    )
    entries = (a, alpha, d + q * slides, theta + q * turns)
    cells = "".join(f"<td>{written(entry, HTML)}</td>" for entry in entries)
    return f"<tr><td>{i}</td>{cells}</tr>"


def _symbols(text: str) -> dict[str, sp.Symbol]:
    return {name: sp.Symbol(name) for name in re.findall(r"[A-Za-z]\w*", text) if name != "pi"}
