"""Write cells: numbers with their units and decorations."""

from dataclasses import dataclass
from random import Random

TORQUE_UNITS = {
    "text": (" N m", " Nm", " N·m", " N*m", "Nm", " N-m", " [Nm]", " Newton-meters"),
    "markdown": (" N m", " Nm", " N·m", " N⋅m", " $N\\,m$"),
    "html": (" N m", " Nm", " N·m", " N&middot;m"),
    "latex": (r"\,\mathrm{N\,m}", r"\ \text{Nm}", r"~\mathrm{Nm}", r"\,\mathrm{N{\cdot}m}"),
}
ANGLE_UNITS = {
    ("text", "rad"): (" rad", " rad", " radians", " [rad]"),
    ("markdown", "rad"): (" rad", " $rad$"),
    ("html", "rad"): (" rad",),
    ("latex", "rad"): (r"\,\mathrm{rad}", r"\text{ rad}"),
    ("text", "deg"): ("°", "°", " deg", " degrees", "º", " °"),
    ("markdown", "deg"): ("°", " deg", "$^\\circ$"),
    ("html", "deg"): ("°", "&deg;"),
    ("latex", "deg"): (r"^\circ", r"^{\circ}", r"\degree"),
}
#: Prefixes of torque units with the factor from N m.
SCALED_TORQUES = {" kNm": 1e-3, " mNm": 1e3, " N mm": 1e3, " kN m": 1e-3}

#: Decorations with weights, by family: {x} is the cell, {o} an earlier value that is struck out,
#: {u} an uncertainty of one unit of the last digit. Bold is the most frequent, since teachers ask
#: for marked results.
DECORATIONS = {
    "markdown": {
        "**{x}**": 12, "*{x}*": 3, "_{x}_": 2, "`{x}`": 6, "~~{o}~~ {x}": 4, "~~{o}~~ **{x}**": 3,
        "${x}$": 5, "{x} ✓": 3, "{x} ✅": 2, "≈ {x}": 4, "≈{x}": 3, "{x} ± {u}": 3, "{x}*": 3,
        "__{x}__": 1, "<u>{x}</u>": 1, "==({x})==": 0.5, "{x}[^1]": 2, '"{x}"': 1,
    },
    "text": {
        "≈ {x}": 6, "~{x}": 5, "~ {x}": 2, "{x}*": 5, "{x} †": 2, "{x} ✓": 4, "{x} ✔": 3,
        "{x} ± {u}": 5, "{x} +/- {u}": 3, "{x} (approx.)": 3, "{x} (was {o})": 3, "≅ {x}": 1,
        "{x} (corrected)": 2, "{x} !": 1, "{x} <--": 2, "{x}(1)": 1, "'{x}'": 2, "{x} (ok)": 2,
        "{x}  # fixed": 2, "<{x}>": 0.5, "{o} → {x}": 2,
    },
    "latex": {
        r"\mathbf{{{x}}}": 8, r"\boxed{{{x}}}": 5, r"\textcolor{{red}}{{{x}}}": 4,
        r"\num{{{x}}}": 4, r"\approx {x}": 4, r"{x} \pm {u}": 3, r"\cancel{{{o}}}\, {x}": 3,
        r"\underline{{{x}}}": 3, r"{{\color{{blue}} {x}}}": 3, r"\boldsymbol{{{x}}}": 2,
        r"{x}^{{*}}": 2, r"\phantom{{-}}{x}": 2, r"{x}\,\checkmark": 1, r"\mathit{{{x}}}": 1,
    },
    "html": {
        "<b>{x}</b>": 6, '<span style="color:red">{x}</span>': 4, "<s>{o}</s> {x}": 3,
        "{x}<sup>a</sup>": 2, "<strong>{x}</strong>": 3, "<td>{x}": 0, "<code>{x}</code>": 2,
    },
}  # fmt: skip
FOOTNOTES = {
    "{x}*": "* rounded", "{x} †": "† limit of this joint not checked", "{x}[^1]": "[^1]: rounded",
    "{x}(1)": "(1) rounded to the digits shown", "{x}<sup>a</sup>": "<p>a: rounded</p>",
    r"{x}^{{*}}": "* rounded",
}  # fmt: skip


@dataclass(frozen=True)
class Decoration:
    """A pattern of decoration, and the index of the cell that has it, or all cells."""

    pattern: str = "{x}"
    cell: tuple[int, int] | None = None
    outside_unit: bool = False

    def applies(self, place: tuple[int, int]) -> bool:
        """Check whether a cell is decorated."""
        return self.cell is None or self.cell == place


def draw_decoration(rng: Random, family: str, shape: tuple[int, int], layout: str) -> Decoration:
    """Draw a decoration: most answers have none, and most decorated answers one marked cell."""
    if family not in DECORATIONS or rng.random() > 0.46:
        return Decoration()
    table = DECORATIONS[family]
    pattern = rng.choices(list(table), list(table.values()))[0]
    if (layout == "prose" and "≈" in pattern) or (
        layout == "CSV" and pattern in ("'{x}'", '"{x}"')
    ):
        return Decoration()
    cell = tuple(rng.randrange(n) for n in shape) if rng.random() < 0.6 else None
    only_one = ("{o}", "fixed", "corrected", "(was", "<--", "!", "(1)", "[^1]", "checkmark")
    if cell is None and any(mark in pattern for mark in only_one):
        cell = tuple(rng.randrange(n) for n in shape)
    return Decoration(pattern, cell, rng.random() < 0.5)
