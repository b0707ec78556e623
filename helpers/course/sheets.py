"""A student's sheet: a notebook to answer in, and the same as a page to print.

Neither holds anything of the key: only what the questions print, and whose sheet it is.
"""

import base64
import io
import pprint
from html import escape
from typing import Any

import numpy as np

from helpers.course.answers import PREFIX
from helpers.course.arms import to_json
from helpers.course.handed_in import SHEET
from helpers.course.store import Course
from helpers.kinematics import forward_kinematics
from helpers.variants import Part, Question, Sheet, topics

_STYLE = """body{font:16px/1.5 Georgia,serif;max-width:44rem;margin:2rem auto;padding:0 1rem}
table{border-collapse:collapse;margin:1rem 0}td,th{border:1px solid #999;padding:.2rem .6rem}
code{font:14px ui-monospace,monospace}img{max-width:100%}math{overflow-x:auto;max-width:100%}
h2{break-after:avoid}@media print{body{margin:0;max-width:none}}"""
_HOW = (
    "Answer by the names that each question gives. SI units, angles in radians unless you"
    " say otherwise."
    " What is forgiven stands beside each answer; fewer digits than that cost a little.\n\n"
    "Put each answer in place of the dots. A list, a NumPy array, a SymPy matrix or a text will"
    " do. The functions of `helpers.checks` say whether a result is right and what to look at if"
    " it is not."
)
_LAST = (
    "## Hand in\n\nThe last cell writes `answers.json` beside this notebook. Hand in both files."
    " Run *Restart and run all* first, so that what is written is what the notebook says."
)
_SETUP = """import numpy as np
import sympy as sp

from helpers import checks, kinematics, motion, statics, symbolic
from helpers.course.arms import from_json

{prefix}{sheet} = {student!r}  # whose sheet this is
arm = from_json(
{arm}
)"""


def notebook(sheet: Sheet, course: Course, student: str) -> dict[str, Any]:
    """The sheet as a notebook, nbformat 4.5: questions, answer cells, checkers, and how to hand
    in.
    """
    name = course.names.get(student, "One sheet for everybody")
    arm = pprint.pformat(to_json(sheet.arm), width=96, sort_dicts=False)
    setup = _SETUP.format(prefix=PREFIX, sheet=SHEET, student=student, arm=arm)
    cells = [
        _text("title", f"# {course.title}\n\n{name} ({student})\n\n{_HOW}"),
        _text("arm", f"## The arm\n\n{sheet.arm._repr_markdown_()}"),
        code_cell("setup", setup),
    ]
    for number, question in enumerate(sheet.questions, 1):
        cells.append(_question_cell(f"question-{number}", question))
        cells += [code_cell(f"answer-{p.name}", answer_code(p)) for p in question.parts]
    cells.append(_text("hand-in", _LAST))
    cells.append(code_cell("write", "from helpers.course import hand_in\n\nhand_in(globals())"))
    kernel = {"display_name": "Python 3", "language": "python", "name": "python3"}
    return {"cells": cells, "metadata": {"kernelspec": kernel}, "nbformat": 4, "nbformat_minor": 5}


def answer_code(part: Part) -> str:
    """The cell in which a part is answered."""
    return f"# {part.what}\n{PREFIX}{part.name} = ..."


def _question_cell(cell_id: str, question: Question) -> dict[str, Any]:
    if question.topic != "DH table":
        return _text(cell_id, question.markdown)
    cell = _text(cell_id, f"{question.markdown}\n\n![The joint axes at q = 0](attachment:axes.png)")
    picture = base64.b64encode(axes_picture(question)).decode()
    return {**cell, "attachments": {"axes.png": {"image/png": picture}}}


def _text(cell_id: str, source: str) -> dict[str, Any]:
    return {"cell_type": "markdown", "id": cell_id, "metadata": {}, "source": source}


def code_cell(cell_id: str, source: str) -> dict[str, Any]:
    """A cell of code that was not run."""
    empty: dict[str, Any] = {"execution_count": None, "metadata": {}, "outputs": []}
    return {"cell_type": "code", "id": cell_id.replace("_", "-"), "source": source, **empty}


def sheet_page(book: dict[str, Any], title: str) -> str:
    """The text of a sheet's notebook as a page to print."""
    text, pictures = [], {}
    for cell in book["cells"]:
        if cell["cell_type"] == "markdown":
            text.append(cell["source"])
            for name, kinds in cell.get("attachments", {}).items():
                pictures[f"attachment:{name}"] = f"data:image/png;base64,{kinds['image/png']}"
    body = page("\n\n".join(text), title)
    for name, data in pictures.items():
        body = body.replace(f'src="{name}"', f'src="{data}"')
    return body


def page(text: str, title: str) -> str:
    """Markdown as a page of HTML that needs nothing else: formulas in MathML."""
    from latex2mathml.converter import convert
    from markdown_it import MarkdownIt
    from mdit_py_plugins.dollarmath import dollarmath_plugin

    reader = MarkdownIt("commonmark", {"html": False}).enable("table")
    reader.use(dollarmath_plugin, renderer=lambda tex, _: convert(tex))
    return (
        '<!doctype html><html lang="en"><meta charset="utf-8">'
        f"<title>{escape(title, quote=False)}</title>"
        '<meta name="viewport" content="width=device-width">'
        f"<style>{_STYLE}</style><body>{reader.render(text)}</body></html>\n"
    )


def axes_picture(question: Question) -> bytes:
    """The joint axes, numbered, and the tip of a table question, as PNG."""
    from matplotlib.figure import Figure

    drawn = topics.drawn_arm(question.given)
    figure = Figure(figsize=(5, 4.5), dpi=120)
    ax = figure.add_subplot(projection="3d")
    for number, verb, point, direction in topics.axes(drawn, question.given["along"]):
        ends = np.array([point - 0.25 * direction, point + 0.25 * direction])
        ax.plot(*ends.T, "-" if verb == "turns" else "--", color="black", lw=1.5)
        ax.text(*ends[1], f"{number}", fontsize=12)
    tip = forward_kinematics(drawn, np.zeros(drawn.dof))[:3, 3]
    ax.plot(*tip[:, None], "o", color="black")
    ax.text(*tip, " tip", fontsize=11)
    for direction, letter in zip(0.2 * np.eye(3), "xyz", strict=True):
        ax.plot(*np.array([np.zeros(3), direction]).T, color="0.6", lw=1)
        ax.text(*direction, letter, color="0.4")
    ax.set(xlabel="x (m)", ylabel="y (m)", zlabel="z (m)")
    ax.set_aspect("equal")
    file = io.BytesIO()
    figure.savefig(file, format="png")
    return file.getvalue()
