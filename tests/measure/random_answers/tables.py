"""Write DH tables as people write them."""

from random import Random

import numpy as np

from helpers.arm import Arm
from tests.measure.random_answers import cells, layouts

_HEADERS = {
    "a": ("a", "a_i", "a", "r"),
    "alpha": ("alpha", "α", "alpha_i", "α_i", "α"),
    "d": ("d", "d_i", "d"),
    "theta": ("theta", "θ", "theta_i", "θ_i", "θ"),
}
_LATEX_HEADERS = {"a": "a_i", "alpha": r"\alpha_i", "d": "d_i", "theta": r"\theta_i"}
#: Column orders with weights: of Spong, Siciliano, Corke and online calculators.
_ORDERS = {
    ("a", "alpha", "d", "theta"): 55,
    ("theta", "d", "a", "alpha"): 25,
    ("alpha", "a", "d", "theta"): 8,
    ("d", "theta", "a", "alpha"): 8,
    ("theta", "alpha", "a", "d"): 4,
}
_VARIABLES = {
    "code": ("q{n}", "theta{n}", "q_{n}", "th{n}"),
    "print": ("q{n}", "theta{n}", "θ{n}"),
    "latex": (r"\theta_{n}", "q_{n}", r"\theta_{n}^*", r"\theta_{{{n}}}"),
    "markdown": ("θ{n}", "q{n}", "θ_{n}", r"$\theta_{n}$", "θ{n}*", "theta{n}"),
    "html": ("θ{n}", "q{n}", "θ<sub>{n}</sub>"),
    "text": ("θ{n}", "q{n}", "theta{n}", "θ_{n}", "θ{n}*", "q{n}*", "th{n}", "theta_{n}"),
}
_QUARTERS = {
    "code": ("pi/2", "pi/2", "1.5708", "np.pi/2"),
    "print": ("pi/2", "1.5708", "90"),
    "latex": (r"\frac{\pi}{2}", r"\pi/2", r"90^\circ", r"\dfrac{\pi}{2}"),
    "markdown": ("π/2", "90°", "pi/2", "90", r"$\pi/2$", "1.5708", "0.5π"),
    "html": ("π/2", "90°", "&pi;/2", "90"),
    "text": ("pi/2", "π/2", "90°", "90", "1.5708", "90 deg", "1.571", "0.5*pi"),
}
_HALVES = {
    "pi/2": "pi", "np.pi/2": "np.pi", "1.5708": "3.1416", "90": "180", r"\frac{\pi}{2}": r"\pi",
    r"\pi/2": r"\pi", r"90^\circ": r"180^\circ", "π/2": "π", "90°": "180°", r"$\pi/2$": r"$\pi$",
    "&pi;/2": "&pi;", "0.5π": "π", "90 deg": "180 deg", "1.571": "3.142", "0.5*pi": "pi",
    r"\dfrac{\pi}{2}": r"\pi",
}  # fmt: skip


def write_table(arm: Arm, rng: Random):
    """Write the DH table of an arm; return block, number texts and features."""
    pool = {name: layouts.TABLE_LAYOUTS[name] for name in layouts.SYMBOL_LAYOUTS}
    layout_name = rng.choices(list(pool), [layout.weight for layout in pool.values()])[0]
    layout = pool[layout_name]
    family = layout.family
    order = rng.choices(list(_ORDERS), list(_ORDERS.values()))[0]
    quarter = rng.choice(_QUARTERS[family])
    variable = rng.choice(_VARIABLES[family])
    lengths = rng.choices(("m", "mm", "symbols"), (65, 20, 15))[0]
    minus = "−" if family in ("text", "markdown", "html") and rng.random() < 0.1 else "-"
    plus = "+" if rng.random() < 0.1 else ""
    decimals = rng.choices((None, 3, 4), (80, 0, 20))[0]
    decoration = cells.draw_decoration(rng, family, (len(arm.rows), 4), layout_name)
    typed, rows, joint = [], [], 0
    for i, row in enumerate(arm.rows):
        joint += row.joint.kind != "fixed"
        entries = {
            "a": _length(arm, row.a, lengths, decimals),
            "alpha": _angle(arm.number(row.alpha), quarter, plus),
            "d": _length(arm, row.d, lengths, decimals),
            "theta": _angle(arm.number(row.theta), quarter, ""),
        }
        typed += [entries[x] for x in ("a", "d", "alpha")]
        if row.joint.kind == "revolute":
            entries["theta"] = _with_offset(variable.format(n=joint), entries["theta"])
        elif row.joint.kind == "prismatic":
            entries["d"] = rng.choice(("d3", "q3", "d_3")) if family != "latex" else "d_3"
            typed.pop(-2)
        rows.append(
            [
                _decorated(entries[name].replace("-", minus), decoration, (i, j))
                for j, name in enumerate(order)
            ]
        )
    if minus != "-":
        typed = [text.replace("-", minus) for text in typed]
    headers = [_LATEX_HEADERS[x] if family == "latex" else rng.choice(_HEADERS[x]) for x in order]
    place = "header" if lengths == "mm" and family != "latex" and rng.random() < 0.5 else "sentence"
    if place == "header":
        bracket = rng.choice((" (mm)", " [mm]", ", mm"))
        headers = [
            h + bracket if x in "ad" and len(x) == 1 else h
            for h, x in zip(headers, order, strict=True)
        ]
    label = rng.choice(
        ("{n}", "{n}", "{n}", "Joint {n}", "Link {n}", "J{n}", "{z}-{n}", "{z} → {n}")
    )
    names = [label.format(n=i, z=i - 1) for i in range(1, len(rows) + 1)]
    corner = rng.choice(("i", "Link", "Joint", "#", "Link, i"))
    grid = layouts.Grid(rows, np.zeros((len(rows), 4)), headers, names, corner, "DH", "")
    block = layout.write(grid, rng)
    sentences = [] if headers[1] in block else [f"Columns: {', '.join(order)}."]
    if lengths == "mm" and (place == "sentence" or headers[1] not in block):
        sentences.append(
            rng.choice(("Lengths in mm.", "(all lengths in mm)", "Units: mm, rad/deg"))
        )
    if lengths == "symbols":
        mark, gap = rng.choice((" = ", "=")), rng.choice((", ", "\n", "; "))
        sentences.append(gap.join(f"{n}{mark}{x:g}" for n, x in arm.values.items()))
    marks = {
        "layout": layout_name, "family": family, "column order": " ".join(order),
        "right angle": quarter, "lengths": lengths, "labels": label, "variable": variable,
        "decoration": decoration.pattern, "sentence": "\n".join(sentences), "name": "DH",
        "decorated": "no" if decoration.pattern == "{x}" else "one" if decoration.cell else "all",
    }  # fmt: skip
    if decoration.pattern in cells.FOOTNOTES:
        marks["footnote"] = cells.FOOTNOTES[decoration.pattern]
    return block, [text for text in typed if text != "0"], marks


def _length(arm: Arm, entry, lengths: str, decimals: int | None) -> str:
    if lengths == "symbols":
        return str(entry).replace(" ", "") if entry else "0"
    value = arm.number(entry) * (1000 if lengths == "mm" else 1)
    if decimals and value:
        return f"{value:.{max(decimals, 5) if lengths == 'm' else 2}f}"
    return f"{value:.6g}" if value else "0"


def _angle(value: float, quarter: str, plus: str) -> str:
    quarters = round(value / (np.pi / 2))
    if not quarters:
        return "0"
    text = quarter if abs(quarters) == 1 else _HALVES[quarter]
    return ("-" if quarters < 0 else plus) + text


def _with_offset(variable: str, offset: str) -> str:
    if offset == "0":
        return variable
    if offset.startswith("-"):
        return f"{variable} - {offset[1:]}"
    return f"{variable} + {offset}"


def _decorated(text: str, decoration: cells.Decoration, place) -> str:
    if not decoration.applies(place):
        return text
    if any(
        mark in decoration.pattern for mark in ("{u}", "\\num", "≈", "\\approx", "~{x}", "~ {x}")
    ):
        return text
    if "$" in decoration.pattern and "$" in text:
        return text
    return decoration.pattern.format(x=text, o="0.42", u="")
