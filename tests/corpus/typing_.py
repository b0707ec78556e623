"""Matrices as people type and paste them."""

import numpy as np

FORMS = ("array", "numpy", "matlab", "latex", "csv", "tabs", "list", "print", "columns")


def _words(M, d):
    M = np.round(np.atleast_2d(M), d) + 0.0
    return [[f"{x:.{d}f}" for x in row] for row in M]


def _short(text):
    """Trailing zeros left out, as people do."""
    return text.rstrip("0").rstrip(".") if "." in text else text


def typed(M, d, rng):
    """A matrix with d decimals in a form of the writer's; "array" stays a list of numbers."""
    form = str(rng.choice(FORMS))
    words = _words(M, d)
    if form == "array":
        return [[float(x) for x in row] for row in words], form
    if form in ("list", "matlab", "tabs") or (form == "latex" and rng.random() < 0.5):
        words = [[_short(x) for x in row] for row in words]
    rows = {
        "numpy": lambda: (
            "array([" + ",\n       ".join("[" + ", ".join(row) + "]" for row in words) + "])"
        ),
        "print": lambda: "[" + "\n ".join("[" + "  ".join(row) + "]" for row in words) + "]",
        "list": lambda: "[" + ", ".join("[" + ", ".join(row) + "]" for row in words) + "]",
        "matlab": lambda: "[" + "; ".join(" ".join(row) for row in words) + "]",
        "latex": lambda: (
            r"\begin{bmatrix} " + r" \\ ".join(" & ".join(row) for row in words) + r" \end{bmatrix}"
        ),
        "csv": lambda: "\n".join(",".join(row) for row in words),
        "tabs": lambda: "\n".join("\t".join(row) for row in words),
        "columns": lambda: "\n".join("   ".join(row) for row in words),
    }
    text = rows[form]()
    if form in ("latex", "columns") and rng.random() < 0.3:
        text = text.replace("-", "−")
    return text, form
