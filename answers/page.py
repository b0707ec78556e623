"""Write an arm's answer sheet in Markdown or HTML, with each answer folded below its question.

The programs that its buttons copy (``answers.js``) are data in one <script> element.
"""

import json
from dataclasses import replace
from html import escape
from pathlib import Path

import numpy as np
import sympy as sp

from answers import displays, programs
from answers.content import Answer, AnswerSheet, Array
from answers.typeset import convert_to_mathml
from helpers.arm import Arm
from helpers.formulas import formula_latex
from helpers.inputs import ArmError, require_type, tuple_of_items

LANGUAGES = {
    "LaTeX": displays.write_latex,
    "SymPy": programs.write_sympy,
    "NumPy": programs.write_numpy,
    "MATLAB": programs.write_matlab,
}


def make_markdown_sheet(
    arm: Arm,
    heading: str,
    introduction: str,
    other_arms: tuple[Arm, ...] = (),
    description: str = "",
) -> str:
    """Write the sheet as a page of the book, in MyST Markdown.

    Args:
        arm: the arm of the sheet.
        heading: the page's title, in Markdown.
        introduction: its first paragraphs, in Markdown.
        other_arms: the same arm with other lengths; the page gives their numbers too.
        description: one sentence for search engines.

    Raises ArmError for an arm of `other_arms` with other rows, for letters that programs cannot
    use, and for an arm without joints.
    """
    require_type(arm, Arm, "arm")
    require_type(description, str, "description")
    require_type(heading, str, "heading")
    require_type(introduction, str, "introduction")
    meta = f"---\nmyst:\n  html_meta:\n    description: {json.dumps(description)}\n---\n\n"
    start = f"{meta if description else ''}# {heading}\n\n{introduction}\n\n"
    return start + _format_sections(arm, other_arms)


def make_html_sheet(arm: Arm) -> str:
    """Write the sheet as a self-contained HTML file, with formulas in MathML.

    Raises ArmError as `make_markdown_sheet` does.
    """
    require_type(arm, Arm, "arm")
    from markdown_it import MarkdownIt
    from mdit_py_plugins.dollarmath import dollarmath_plugin

    reader = MarkdownIt("commonmark").enable("table")
    reader.use(
        dollarmath_plugin, renderer=lambda tex, how: convert_to_mathml(tex, how["display_mode"])
    )
    name = escape(arm.name)
    body = reader.render(f"# {name}: answers\n\n{_format_sections(arm)}")
    return (
        f'<!doctype html>\n<html lang="en"><head><meta charset="utf-8"><title>{name}: answers'
        '</title>\n<meta name="viewport" content="width=device-width, initial-scale=1">\n'
        f'</head>\n<body class="sheet"><main>\n{body}</main></body></html>\n'
    )


def _format_sections(arm: Arm, other_arms: tuple[Arm, ...] = ()) -> str:
    """Write the style, the sections (heading, question, answers) and the script of a sheet."""
    arms = (arm, *tuple_of_items(other_arms, "other_arms", "arms with the same rows"))
    for other in other_arms:
        if other.rows != arm.rows:
            raise ArmError(
                f"{other.name} has other rows than {arm.name}; expected other values only"
            )
    sheet, *other_sheets = (AnswerSheet(replace(a, name=escape(a.name))) for a in arms)
    sections = [
        ("Link matrices", _ASK_LINKS, sheet.link_matrices),
        ("Frames seen from the base", _ask_frames(sheet), sheet.frames),
        ("Origins", _ASK_ORIGINS, sheet.origins),
        ("Axes", _ASK_AXES, sheet.axes),
        ("Jacobian", _ASK_JACOBIAN % len(arm.rows) + _format_joint_note(arm), [sheet.jacobian]),
    ]
    if det := sheet.determinant:
        sections.append(("Determinant", _ask_determinant(sheet, det), [det]))
    if sheet.energy_and_torques:
        sections.append(
            ("Gravity", _ASK_GRAVITY + _format_joint_note(arm), sheet.energy_and_torques)
        )
    questions = "\n\n".join(
        f"## {heading}\n\n**First try.** {question}\n\n"
        + "\n\n".join(_format_answer(sheet, answer, other_sheets) for answer in answers)
        for heading, question, answers in sections
    )
    style, script = ((_STATIC / f"answers.{kind}").read_text("utf-8") for kind in ("css", "js"))
    return (
        f"<style>\n{style}</style>\n\n{_TOOLS}\n\n## Table\n\n"
        f"{_format_introduction(sheet, other_sheets)}\n\n"
        f"{questions}\n\n{_format_program_data(sheet)}\n\n<script>\n{script}</script>\n"
    )


def _format_program_data(sheet: AnswerSheet) -> str:
    """Write the <script> element with the programs of each answer, by language."""
    texts = {
        _make_id(answer): {language: write(sheet, answer) for language, write in LANGUAGES.items()}
        for answer in sheet.answers
    }
    data = json.dumps(texts).replace("</", r"<\/")
    return f'<script type="application/json">{data}</script>'


def _format_answer(sheet: AnswerSheet, answer: Answer, other_sheets: list[AnswerSheet]) -> str:
    """Write a folded answer with its formula, and with its numbers at each arm's home."""
    formulas = [f"$$\n{display}\n$$" for display in displays.format_symbols(sheet, answer)]
    for caption, values in _list_home_values(sheet, answer, other_sheets):
        formulas.append(
            f"In numbers{caption}:\n\n$$\n{displays.format_numbers(answer, values)}\n$$"
        )
    name = _format_html_name(answer)
    title = f'<details class="answer" id="{_make_id(answer)}"><summary>{name}</summary>'
    return "\n\n".join([title, *formulas, "</details>"])


def _make_id(answer: Answer) -> str:
    return answer.name.replace("_", "-").lower()


def _format_html_name(answer: Answer) -> str:
    """Return an answer's name in HTML."""
    letter, _, index = answer.name.partition("_")
    names = {"det": "det <i>J</i>", "G": "<i>g</i>(<i>q</i>)", "J": "<i>J</i>", "P": "<i>P</i>"}
    if letter == "T":
        return f"<sup>0</sup><i>T</i><sub>{index[1:]}</sub>"
    return names.get(letter, f"<i>{letter}</i><sub>{index}</sub>")


def _list_home_values(
    sheet: AnswerSheet, answer: Answer, other_sheets: list[AnswerSheet]
) -> list[tuple[str, Array]]:
    """Return captions and numbers of an answer for each arm whose numbers differ."""
    captioned = [(f", {sheet.arm.name}", answer.home_values)]
    for other in other_sheets:
        if not np.allclose(other.home_values[answer.name], answer.home_values, rtol=0, atol=5e-5):
            captioned.append((f", {other.arm.name}", other.home_values[answer.name]))
    return captioned if len(captioned) > 1 else [("", answer.home_values)]


# The text above the answers


def _format_introduction(sheet: AnswerSheet, other_sheets: list[AnswerSheet]) -> str:
    """Write the table, the values of its symbols, the home configuration and the short names."""
    arm = sheet.arm
    pairs = zip(arm.variables, arm.home, strict=True)
    home = ", ".join(
        f"${name} = {sp.latex(programs.make_exact_angle(value))}$" for name, value in pairs
    )
    other_values = [other.arm._repr_markdown_().rsplit("\n\n", 1)[1] for other in other_sheets]
    zero = [f"${sp.latex(sp.Symbol(name))}$" for name, value in arm.values.items() if not value]
    parts = [arm._repr_markdown_(), *other_values]
    if zero:
        parts.append(f"What is 0, here {', '.join(zero)}, is left out of the formulas.")
    parts.append(f"Numbers are given at {home} (rad; m where a joint slides), rounded.")
    parts.append(f"Short names: {_format_legend(sheet)}.")
    if sheet.steps:
        parts.append(_STEPS_NOTE)
    parts += [_format_mass_table(s) for s in (sheet, *other_sheets) if s.arm.bodies]
    return "\n\n".join(parts)


def _ask_frames(sheet: AnswerSheet) -> str:
    """Write the question about frames. Only written-out formulas contain sums of angles."""
    return _ASK_FRAMES % ("" if sheet.steps else " Angles about parallel axes add up.")


def _format_legend(sheet: AnswerSheet) -> str:
    """List the short names of sums of angles, such as c_23 = cos(q_2 + q_3)."""
    symbols = {symbol: f for answer in sheet.answers for symbol, f in answer.definitions.items()}
    sums = [
        f"${sp.latex(symbol)} = {formula_latex(f)}$"
        for symbol, f in sorted(symbols.items(), key=str)
        if isinstance(f, sp.cos) and f.args[0].is_Add
    ]
    return ", ".join([r"$c_i = \cos(q_i)$, $s_i = \sin(q_i)$", *sums])


def _format_mass_table(sheet: AnswerSheet) -> str:
    """Write a table of the links' masses and centres of mass."""
    header = (
        f"{sheet.arm.name}: masses (kg), and centres of mass (m) in the frame that moves with"
        " each link; $g = 9.81$ m/s².\n\n| link | $m$ | $x_c$ | $y_c$ | $z_c$ |\n"
        "|:-:|:-:|:-:|:-:|:-:|\n"
    )
    letters = ("m_", "x_c", "y_c", "z_c")
    rows = [
        [i, *(sheet.symbol_values.get(f"{letter}{i}", 0.0) for letter in letters)]
        for i in range(1, len(sheet.arm.rows) + 1)
    ]
    lines = [f"| {' | '.join(f'{x:g}' for x in row)} |" for row in rows]
    return header + "\n".join(lines).replace("-", "\N{MINUS SIGN}")


def _format_joint_note(arm: Arm) -> str:
    """Name the joints of J's columns and g's entries, if some rows have no joint."""
    if arm.dof == len(arm.rows):
        return ""
    return f" Joints that move, in this order: {', '.join(map(str, arm.joints))}."


def _ask_determinant(sheet: AnswerSheet, det: Answer) -> str:
    """Write the question about det J, with the number of factors of the answer."""
    rows = "" if sheet.arm.dof == 6 else " of the first three rows"
    asked = f"At which configurations does the arm lose a freedom? Where $\\det J${rows} is 0."
    turning = {*det.definitions, *map(sp.Symbol, sheet.arm.variables)}
    factors = [f for f in sp.Mul.make_args(det.value[0]) if f.free_symbols & turning]
    if not det.value[0]:
        return f"{asked} This one is 0 everywhere."
    if len(factors) > 1:
        return f"{asked} It falls into {len(factors)} factors that depend on the configuration."
    return f"{asked} For this arm it does not fall into factors." if det.value[0].is_Add else asked


_STEPS_NOTE = (
    "Written out, the formulas of this arm would be too long. Each frame is therefore given in the"
    " entries of the frame before: $x_{3y}$ is the $y$ entry of the axis $x_3$, $o_{3y}$ that of"
    " the origin $o_3$, and $p_{3y}$ that of link 3's centre of mass. Copied programs hold every"
    " step. The determinant is left out; `kinematics.manipulability` finds singular"
    " configurations in numbers."
)
_STATIC = Path(__file__).parent / "static"
# Disabled buttons reserve the space until the script runs, so that the page does not move.
_BUTTON = '<button type="button" disabled'
_COPY = "".join(f'{_BUTTON} data-language="{to}">Copy all as {to}</button>' for to in LANGUAGES)
_TOOLS = f'<p class="answer-tools">{_BUTTON}>Open all answers</button>{_COPY}</p>'

_ASK_LINKS = r"""Put each row of the table into

$$
A_i = \mathrm{Rot}_z(\theta_i)\,\mathrm{Trans}_z(d_i)\,\mathrm{Trans}_x(a_i)\,
\mathrm{Rot}_x(\alpha_i).
$$"""
_ASK_FRAMES = (
    r"Multiply the link matrices: ${}^{0}T_i = A_1 \cdots A_i$.%s"
    " Long entries of the last two columns are named, as $(z_i)_x$ and $(o_i)_x$, and written out"
    " under Axes and Origins."
)
_ASK_ORIGINS = (
    "Where is the origin $o_i$ of each frame? Fourth column of ${}^{0}T_i$, first three rows (m)."
)
_ASK_AXES = "Which way does each $z_i$ point? Third column of ${}^{0}T_i$, first three rows."
_ASK_JACOBIAN = (
    r"One column for each joint: where it turns, $z_{i-1} \times (o_{%d} - o_{i-1})$ over"
    r" $z_{i-1}$; where it slides, $z_{i-1}$ over 0. Rows are $(v_x, v_y, v_z, \omega_x, \omega_y,"
    r" \omega_z)$ in base axes, at the tip. Long entries of an axis are only named, as $(z_i)_x$."
)
_ASK_GRAVITY = (
    r"The potential energy $P = g \sum m_i h_i$ (J), with $h_i$ the height of link $i$'s centre of"
    r" mass, whose coordinates in frame $i$ are $(x_{ci}, y_{ci}, z_{ci})$; then what holds the arm"
    r" against its weight, $g(q) = \partial P/\partial q$. Programs call it `G`, for $g$ is the"
    " acceleration of gravity there."
)
