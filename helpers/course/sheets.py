"""A student's sheet as a notebook to answer in and as a page to print."""

import base64
import io
from html import escape
from typing import Any

import numpy as np

from helpers import variants
from helpers.course.arms import to_json
from helpers.course.store import Course, as_json
from helpers.variants import Part, Question, Sheet

FILE = "sheet.json"

_STYLE = """body{font:16px/1.5 Georgia,serif;max-width:44rem;margin:2rem auto;padding:0 1rem}
table{border-collapse:collapse;margin:1rem 0}td,th{border:1px solid #999;padding:.2rem .6rem}
code{font:14px ui-monospace,monospace}img{max-width:100%}math{overflow-x:auto;max-width:100%}
h2{break-after:avoid}@media print{body{margin:0;max-width:none}}"""


def markdown(sheet: Sheet, course: Course, student: str, name: str) -> str:
    """The whole sheet as Markdown; a drawing stands as `![...](axes.svg)`."""
    head = f"# {course.title}\n\n{name} ({student})\n\n{_HOW}"
    return "\n\n".join([head, _arm(sheet), *(_with_picture(q) for q in sheet.questions)])


def _arm(sheet: Sheet) -> str:
    """The table of the arm that the questions are about, in its own section."""
    return f"## The arm\n\n{sheet.arm._repr_markdown_()}"


_HOW = (
    "Answer by the names that each question gives. SI units, angles in radians unless you"
    " say otherwise."
    " What is forgiven stands beside each answer; fewer digits than that cost a little."
)


def _with_picture(question: Question) -> str:
    if question.topic != "DH table":
        return question.markdown
    return f"{question.markdown}\n\n![The joint axes at q = 0, drawn in the base frame](axes.svg)"


def notebook(sheet: Sheet, course: Course, student: str, name: str) -> dict[str, Any]:
    """The sheet as a notebook, nbformat 4.5: questions, answer cells, checkers, and how to hand
    in.
    """
    cells = [_text("title", f"# {course.title}\n\n{name} ({student})\n\n{_HOW}\n\n{_NAMES}")]
    cells += [_text("arm", _arm(sheet)), _code("setup", _setup(sheet))]
    for number, question in enumerate(sheet.questions, 1):
        cells.append(_question_cell(f"question-{number}", question))
        cells += [_code(f"answer-{part.name}", answer_code(part)) for part in question.parts]
    cells.append(_text("hand-in", _LAST))
    cells.append(_code("write", "from helpers.course import hand_in\n\nhand_in(globals())"))
    kernel = {"display_name": "Python 3", "language": "python", "name": "python3"}
    return {"cells": cells, "metadata": {"kernelspec": kernel}, "nbformat": 4, "nbformat_minor": 5}


def notebook_text(book: dict[str, Any]) -> str:
    """A notebook as it is written to a file."""
    return as_json(book)


def numbers_text(sheet: Sheet) -> str:
    """The arm and the drawn numbers of a sheet, as sheet.json keeps them for `look`."""
    return as_json({"arm": to_json(sheet.arm), "drawn": dict(sheet.drawn)})


_NAMES = (
    "Put each answer in place of the dots. A list, a NumPy array, a SymPy matrix or a text will"
    " do. The functions of `helpers.checks` say whether a result is right and what to look at if"
    " it is not."
)
_LAST = (
    "## Hand in\n\nThe last cell writes `answers.json` beside this notebook. Hand in both files."
    " Run *Restart and run all* first, so that what is written is what the notebook says."
)


def answer_code(part: Part) -> str:
    """The cell in which a part is answered."""
    return f"# {part.what}\nanswer_{part.name} = ..."


def _setup(sheet: Sheet) -> str:
    """The imports, and the arm of the sheet from its table."""
    lines = [
        "import numpy as np",
        "import sympy as sp",
        "",
        "from helpers import checks, kinematics, motion, statics, symbolic",
        "from helpers.course.arms import from_json",
        "",
        f"arm = from_json({arm_literal(sheet)})",
    ]
    return "\n".join(lines)


def arm_literal(sheet: Sheet) -> str:
    """The sheet's arm as the data that `from_json` reads, one row a line."""
    data = to_json(sheet.arm)
    rows = "".join(f"        {row!r},\n" for row in data["rows"])
    bodies = "".join(f"        {body!r},\n" for body in data["bodies"])
    rest = {key: data[key] for key in ("values", "home", "source")}
    words = "".join(f"    {key!r}: {value!r},\n" for key, value in rest.items())
    return (
        f"{{\n    'name': {data['name']!r},\n    'rows': [\n{rows}    ],\n"
        f"    'bodies': [\n{bodies}    ],\n{words}}}"
    )


def _question_cell(cell_id: str, question: Question) -> dict[str, Any]:
    if question.topic != "DH table":
        return _text(cell_id, question.markdown)
    cell = _text(cell_id, f"{question.markdown}\n\n![The joint axes at q = 0](attachment:axes.png)")
    picture = base64.b64encode(axes_picture(question, "png")).decode()
    return {**cell, "attachments": {"axes.png": {"image/png": picture}}}


def _text(cell_id: str, source: str) -> dict[str, Any]:
    return {"cell_type": "markdown", "id": cell_id, "metadata": {}, "source": source}


def _code(cell_id: str, source: str) -> dict[str, Any]:
    empty: dict[str, Any] = {"execution_count": None, "metadata": {}, "outputs": []}
    return {"cell_type": "code", "id": cell_id.replace("_", "-"), "source": source, **empty}


def page(text: str, picture: bytes | None, title: str) -> str:
    """A page of HTML that needs nothing else: formulas in MathML, the drawing inside."""
    from latex2mathml.converter import convert
    from markdown_it import MarkdownIt
    from mdit_py_plugins.dollarmath import dollarmath_plugin

    reader = MarkdownIt("commonmark", {"html": False}).enable("table")
    reader.use(dollarmath_plugin, renderer=lambda tex, _: convert(tex))
    body = reader.render(text)
    if picture is not None:
        data = f"data:image/svg+xml;base64,{base64.b64encode(picture).decode()}"
        body = body.replace('src="axes.svg"', f'src="{data}"')
    return (
        '<!doctype html><html lang="en"><meta charset="utf-8">'
        f"<title>{escape(title, quote=False)}</title>"
        '<meta name="viewport" content="width=device-width">'
        f"<style>{_STYLE}</style><body>{body}</body></html>\n"
    )


def sheet_page(sheet: Sheet, course: Course, student: str, name: str) -> str:
    """The sheet as a page to print."""
    drawings = [axes_picture(q, "svg") for q in sheet.questions if q.topic == "DH table"]
    text = markdown(sheet, course, student, name)
    return page(text, drawings[0] if drawings else None, f"{course.title}, {student}")


def axes_picture(question: Question, form: str) -> bytes:
    """The joint axes, numbered, and the tip of a table question, as PNG or SVG."""
    from matplotlib.figure import Figure

    drawn = variants.drawn_arm(question.given)
    figure = Figure(figsize=(5, 4.5))
    ax = figure.add_subplot(projection="3d")
    found = variants.axes(drawn, question.given["along"])
    tip = variants.forward_kinematics(drawn, np.zeros(drawn.dof))[:3, 3]
    for number, verb, point, direction in found:
        ends = np.array([point - 0.25 * direction, point + 0.25 * direction])
        ax.plot(*ends.T, "-" if verb == "turns" else "--", color="black", lw=1.5)
        ax.text(*ends[1], f"{number}", fontsize=12)
    ax.plot(*tip[:, None], "o", color="black")
    ax.text(*tip, " tip", fontsize=11)
    for direction, letter in zip(0.2 * np.eye(3), "xyz", strict=True):
        ax.plot(*np.array([np.zeros(3), direction]).T, color="0.6", lw=1)
        ax.text(*direction, letter, color="0.4")
    ax.set(xlabel="x (m)", ylabel="y (m)", zlabel="z (m)")
    ax.set_aspect("equal")
    file = io.BytesIO()
    figure.savefig(file, format=form, metadata={"Date": None} if form == "svg" else None)
    return file.getvalue()
