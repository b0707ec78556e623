"""Draw right answers and their twins by seed: the question, its numbers and how to write them."""

from dataclasses import dataclass, replace
from random import Random

import numpy as np

from tests.measure.random_answers import cells, labels, layouts, numbers
from tests.measure.random_answers.mistakes import draw_mistake
from tests.measure.random_answers.questions import TOPICS, Question, draw_question
from tests.measure.random_answers.surroundings import add_surroundings
from tests.measure.random_answers.tables import write_table

#: Layouts of tools that print numbers in their own format.
TOOL_PRINTS = ("NumPy print", "MATLAB print", "SymPy pretty")
#: Layouts of trajectories, which are too long to type by hand.
_TRACE_LAYOUTS = (
    "nested list", "NumPy print", "MATLAB print", "MATLAB literal", "Markdown table", "CSV",
    "spreadsheet", "pandas frame", "tabulate", "spaced columns", "Julia", "JSON", "HTML table",
    "LaTeX tabular",
)  # fmt: skip

#: Layouts in which a plain number before a value can only be the joint's number.
_NUMBERED = (
    "lines", "bullets", "Markdown table", "CSV", "spreadsheet", "Word table", "HTML table",
    "prettytable", "tabulate", "org table", "pandas frame", "pandas series",
)  # fmt: skip


@dataclass(frozen=True)
class Draw:
    """A pasted text with an answer in it.

    Attributes:
        question: what is asked, with its right numbers.
        text: the paste.
        typed: number texts that stand in it, undecorated.
        angles: the setting beside the field.
        features: name and value of each feature.
        units: unit of each number's last typed digit, None for tables and prints of tools.
        factors: typed unit of each column per SI unit.
        mistake: name of the mistake of a twin, or "".
    """

    question: Question
    text: str
    typed: tuple[str, ...]
    angles: str
    features: dict[str, str]
    units: np.ndarray | None = None
    factors: np.ndarray | None = None
    mistake: str = ""


def draw_answer(seed: int, index: int) -> Draw:
    """Draw a right answer."""
    question = _question_of(seed, index)
    return _write_answer(question, question, Random(f"clothes {seed} {index}"))


def draw_twin(seed: int, index: int) -> Draw:
    """Draw the same answer, written in the same way, with one mistake in it."""
    question = _question_of(seed, index)
    rng = Random(f"mistake {seed} {index}")
    while True:
        name, mistaken = draw_mistake(question, rng)
        twin = _write_answer(question, mistaken, Random(f"clothes {seed} {index}"))
        if shows_mistake(twin, mistaken.right):
            return replace(twin, mistake=name)


def shows_mistake(twin: Draw, mistaken: np.ndarray) -> bool:
    """Check that a number changed by more than its typed digits show."""
    if twin.units is None:
        return True
    moved = abs(mistaken - twin.question.right) * twin.factors
    return bool((moved > twin.units).any())


def _question_of(seed: int, index: int) -> Question:
    topic = TOPICS[index % len(TOPICS)]
    return draw_question(Random(f"question {seed} {index}"), topic)


def _write_answer(question: Question, answer: Question, rng: Random) -> Draw:
    """Write an answer (right or mistaken) to a question as a pasted text."""
    if question.topic == "table":
        block, typed, marks = write_table(answer.arm, rng)
        values, angles, units, factors = np.zeros((1, 1)), "rad", None, None
    else:
        block, typed, values, marks = _write_numbers(question, answer.right, rng)
        angles, units, factors = (marks.pop(name) for name in ("setting", "units", "factors"))
    text = add_surroundings(block, question, values, rng, marks)
    inner = ("sentence", "footnote", "name")
    features = {"topic": question.topic, "arm": question.arm.name}
    features |= {name: x for name, x in marks.items() if name not in inner}
    return Draw(question, text, tuple(typed), angles, features, units, factors)


def _write_numbers(question: Question, values: np.ndarray, rng: Random):
    """Write numbers in a layout; return block, number texts, numbers as typed, and features."""
    is_list = len(values) == 1 and question.topic != "branches"
    layout_name, layout = _draw_layout(question.topic, is_list, rng)
    family = layout.family
    has_angles = "angle" in question.kinds
    unit, place, setting = _draw_unit(question, layout_name, layout, rng)
    factors = np.array([_factor(kind, unit) for kind in question.kinds])
    typed = values * factors
    style = numbers.draw_format(
        rng, family, angles=has_angles and "length" not in question.kinds and unit != "deg",
        commas=layout.commas,
    )  # fmt: skip
    if factors.min() < 0.1:
        style = replace(style, digits=style.digits + 3)
    written = [[numbers.write_number(x, style, family) for x in row] for row in typed]
    texts = [[text for text, _ in row] for row in written]
    is_print = layout_name in TOOL_PRINTS
    decoration = cells.draw_decoration(rng, family, typed.shape, layout_name)
    marks = {
        "layout": layout_name, "family": family, "number": style.kind,
        "unit": unit or "none", "unit place": place, "decoration": decoration.pattern,
        "decorated": "no" if decoration.pattern == "{x}" else "one" if decoration.cell else "all",
        "setting": setting, "factors": factors,
        "units": None if is_print else np.array([[unit for _, unit in row] for row in written]),
    }  # fmt: skip
    marks |= _format_features(layout_name, style)
    marks["footnote"] = cells.FOOTNOTES.get(decoration.pattern, "")
    numbering = layout_name in _NUMBERED
    columns, label_style = _columns(question, layout, numbering, rng)
    marks["labels"] = label_style if layout.labelled else "none"
    if place == "label":
        columns = [
            f"{name} [{_plain_unit(kind, unit)}]"
            for name, kind in zip(columns, question.kinds, strict=True)
        ]
    spelled = {kind: _spelled(kind, unit, family, rng) for kind in ("angle", "length", "torque")}
    units = [spelled.get(kind, "") if place == "cell" else "" for kind in question.kinds]
    cell_texts = [
        [_cell(x, units[j], decoration, (i, j), typed[i, j]) for j, x in enumerate(row)]
        for i, row in enumerate(texts)
    ]
    name = rng.choice(_NAMES[question.topic])
    marks["name"] = name
    heading = _plain_unit(question.kinds[0], unit) if place == "heading" else ""
    rows, corner = _row_names(question, len(values), is_list, rng)
    grid = layouts.Grid(cell_texts, typed, columns, rows, corner, name, heading)
    marks["sentence"] = _sentence(question, unit, place, rng)
    grid = _with_neighbours(grid, question, layout_name, rng, marks)
    block = layout.write(grid, rng)
    if place in ("label", "heading") and not _shows_unit(block, unit):
        # This layout has no headers, so a sentence gives the unit.
        marks["unit place"] = "sentence"
        marks["sentence"] = _sentence(question, unit, "sentence", rng)
    if layout_name in _COMMENTED and rng.random() < 0.15:
        marks["line comments"] = "yes"
        block = _with_comments(block, question, rng)
    if layout_name in ("Python list", "array(...)") and unit == "deg" and rng.random() < 0.4:
        inner = block.split(" = ")[-1]
        block = f"{name} = {rng.choice(('np.radians', 'np.deg2rad'))}({inner})"
        marks["unit place"], marks["setting"], marks["sentence"] = "np.radians", "rad", ""
    kept = [] if is_print else [text for row in texts for text in row]
    return block, kept, typed, marks


def _format_features(layout_name: str, style: numbers.NumberFormat) -> dict[str, str]:
    """Return the features of a number format."""
    features = {"number": "tool's own"} if layout_name in TOOL_PRINTS else {}
    marks = ("comma", "plus", "bare_point")
    features |= {f"number: {mark}": "yes" for mark in marks if getattr(style, mark)}
    return features | ({"number: Unicode minus": "yes"} if style.minus != "-" else {})


_NAMES = {
    "jacobian": ("J", "J", "Jv", "J0", "jac"),
    "torques": ("tau", "tau", "tau", "torques", "T"),
    "trace": ("q", "Q", "q_traj", "theta"),
    "branches": ("q", "solutions", "sols", "theta"),
    "pose": ("q", "q", "theta", "q_sol"),
}


def _draw_layout(topic: str, is_list: bool, rng: Random):
    table = layouts.LIST_LAYOUTS if is_list else dict(layouts.TABLE_LAYOUTS)
    if topic == "branches" or (topic == "torques" and not is_list):
        table = table | layouts.ROW_LAYOUTS
    if topic == "trace":
        table = {name: table[name] for name in _TRACE_LAYOUTS}
    name = rng.choices(list(table), [layout.weight for layout in table.values()])[0]
    return name, table[name]


def _draw_unit(question: Question, layout_name: str, layout: layouts.Layout, rng: Random):
    """Draw the unit, its place in the text, and the unit chosen beside the field.

    A third of the angles are typed in degrees, since people check them by eye. Half of the torques
    have no unit, since programs print none. A unit that is not the SI unit always stands somewhere.
    """
    if question.topic == "jacobian":
        return "", "nowhere", "rad"
    handwritten = layout.family in ("text", "markdown", "html", "latex")
    places = {"nowhere": 40, "sentence": 12}
    if handwritten:
        places |= {"cell": 30 if len(question.right) < 9 else 4}
    if handwritten and layout.labelled and layout.family != "latex":
        places |= {"label": 10}
    if layout_name in ("Markdown table", "spreadsheet", "CSV", "Word table", "plain sentence"):
        places |= {"heading": 15}
    place = rng.choices(list(places), list(places.values()))[0]
    if len(question.right) > 1 and place == "heading":
        place = "label"
    if question.topic == "torques":
        scaled = place in ("cell", "sentence", "heading") and layout.family != "latex"
        if scaled and layout_name not in TOOL_PRINTS and rng.random() < 0.12:
            return rng.choice(list(cells.SCALED_TORQUES)), place, "rad"
        return "N m", place, "rad"
    if rng.random() >= 0.35:
        return "rad", place, "rad"
    setting = "deg" if place == "nowhere" or rng.random() < 0.5 else "rad"
    return "deg", place, setting


def _shows_unit(block: str, unit: str) -> bool:
    shown = {"deg": ("deg", "°"), "rad": ("rad",), "N m": ("Nm", "N m")}
    return any(mark in block for mark in shown.get(unit, (unit.strip(),)))


def _factor(kind: str, unit: str) -> float:
    if kind == "angle" and unit == "deg":
        return 180 / np.pi
    return cells.SCALED_TORQUES.get(unit, 1.0) if kind == "torque" else 1.0


def _spelled(kind: str, unit: str, family: str, rng: Random) -> str:
    if family not in cells.TORQUE_UNITS or not unit:
        return ""
    if kind == "length":
        return r"\,\mathrm{m}" if family == "latex" else " m"
    if kind == "torque":
        return unit if unit in cells.SCALED_TORQUES else rng.choice(cells.TORQUE_UNITS[family])
    return rng.choice(cells.ANGLE_UNITS.get((family, unit), ("",)))


def _plain_unit(kind: str, unit: str) -> str:
    if kind == "length":
        return "m"
    return {"N m": "Nm"}.get(unit, unit.strip())


def _cell(text: str, unit: str, decoration: cells.Decoration, place, value: float) -> str:
    """Write a cell with its unit and decoration."""
    if not decoration.applies(place):
        return text + unit
    older = f"{value * 1.25 + 0.5:.3f}"
    outside = decoration.outside_unit and "num" not in decoration.pattern
    inner = text + unit if outside else text
    decorated = decoration.pattern.format(x=inner, o=older, u="0.001")
    return decorated if outside else decorated + unit


def _columns(
    question: Question, layout: layouts.Layout, numbering: bool, rng: Random
) -> tuple[list[str], str]:
    kinds, joints = question.kinds, question.joints
    if question.topic == "jacobian":
        style = rng.choice(("J{n}", "q{n}", "joint {n}", "{n}", "Col {n}", "J_{n}", "θ{n}"))
        return [style.format(n=n) for n in joints], style
    style, names = labels.draw_labels(
        rng, layout.family, kinds, joints, question.arm.name, numbering=numbering
    )
    return names, style


def _row_names(question: Question, count: int, is_list: bool, rng: Random):
    if question.topic == "jacobian":
        return list(rng.choice(labels.JACOBIAN_ROWS)), rng.choice(("", "row", " "))
    if is_list:
        return [""], rng.choice(("Joint", "joint", "i", "#", ""))
    style = rng.choice(labels.ROW_STEMS[question.topic])
    names = [style.format(n=i + 1, z=i) for i in range(count)]
    corner = {"trace": ("step", "k", "i", ""), "branches": ("#", "Solution", "", "Branch")}
    return names, rng.choice(corner.get(question.topic, ("pose", "#", "")))


#: Tables whose header can name a column that is not part of the answer.
_WIDE = (
    "Markdown table", "spreadsheet", "CSV", "Word table", "HTML table", "LaTeX tabular",
    "prettytable", "tabulate", "org table", "pandas frame",
)  # fmt: skip
_COMMENTED = ("lines", "assignments", "one a line", "YAML")


def _with_neighbours(grid: layouts.Grid, question: Question, layout: str, rng: Random, marks: dict):
    """Add columns that tables have beside the answer: times, tip, limits, errors, remarks."""
    # Nearly half of the tables have such columns: logs have times, tables of torques limits.
    if layout not in _WIDE or question.topic == "jacobian" or rng.random() > 0.45:
        return grid
    count = len(question.right) if len(grid.cells) > 1 else len(grid.columns)
    if question.topic == "trace":
        times = question.extra.times
        if rng.random() < 0.6:
            marks["neighbours"] = "time"
            return replace(
                grid, rows=[f"{t:.3f}" for t in times], corner=rng.choice(("t", "t [s]"))
            )
        marks["neighbours"] = "tip"
        tip = question.extra.positions
        columns = {x: [f"{p:.4f}" for p in tip[:, i]] for i, x in enumerate("xyz")}
    elif question.topic == "torques" and len(grid.cells) == 1:
        marks["neighbours"] = "limits"
        rows = [question.arm.rows[n - 1] for n in question.joints]
        columns = {"limit": [f"{row.joint.effort:g}" for row in rows]}
    elif question.topic == "pose" and np.isfinite(question.arm.limits).all():
        marks["neighbours"] = "range"
        scale = [_factor(kind, marks["unit"]) for kind in question.kinds]
        lower, upper = (limit * scale for limit in question.arm.limits)
        columns = {"range": [f"{x:.4g}..{y:.4g}" for x, y in zip(lower, upper, strict=True)]}
    else:
        marks["neighbours"] = "remarks"
        pool = {"error": ["1e-12", "0.0", "3e-16"], "ok?": ["yes", "✓"], "note": ["-", "checked"]}
        title = rng.choice(list(pool))
        columns = {title: [rng.choice(pool[title]) for _ in range(count)]}
    return replace(grid, neighbours=columns)


def _with_comments(block: str, question: Question, rng: Random) -> str:
    """Add a remark at the end of each line, or of a single line."""
    lines, mark = block.split("\n"), rng.choice(("  # ", "  % ", "  // ", "   <- "))
    pool = ("joint {n}", "checked", "ok", "limit 87", "see eq. {n}", "2nd try")
    remark = rng.choice(pool)
    chosen = range(len(lines)) if rng.random() < 0.5 else (rng.randrange(len(lines)),)
    for i in chosen:
        lines[i] += mark + remark.format(n=i + 1)
    return "\n".join(lines)


def _sentence(question: Question, unit: str, place: str, rng: Random) -> str:
    if place != "sentence" or not unit:
        return ""
    if question.topic == "torques":
        shown = unit.strip()
        return rng.choice(
            (f"All torques in {shown}.", f"Joint torques ({shown}):", f"Units: {shown}")
        )
    full = "degrees" if unit == "deg" else "radians"
    slide = " (d3 in m)" if "length" in question.kinds else ""
    return rng.choice(
        (
            f"All angles in {full}{slide}.",
            f"Joint angles in {full}{slide}:",
            f"(angles: {unit}){slide}",
        )
    )
