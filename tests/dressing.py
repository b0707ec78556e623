"""Numbers dressed as students type and paste them: the programs, the papers, the text around."""

import numpy as np

NAMES = ("a", "alpha", "d", "theta")


def number(x: float, digits: int, style: str = "fixed") -> str:
    """With so many decimals, or so many significant digits."""
    if style == "significant":
        text = f"{x:.{digits}g}"
        return text if "e" not in text else f"{x:.{digits}f}"
    text = f"{x:.{digits}f}"
    return f"{0:.{digits}f}" if float(text) == 0 else text


def around(rng, grid: str, units: str = "SI units") -> tuple[str, str]:
    """A grid with what people write above and below it."""
    above = ["", "", "", "My answer:\n", "Hi, is this right?\n\n", "Anna Schmidt\n\n", "Result:\n",
             f"({units})\n", f"in {units}:\n", "Here is what I got:\n", "% my result\n",
             "# my result\n", "Is this correct for my arm?\n", "Table 1: my result\n", "Hello,\n\n",
             "Exercise 2 b)\n", "Solution:\n\n", "Dear all,\nI get this, what is wrong?\n",
             "Problem 3.\n", "Moin, kann das stimmen?\n", "Computed with MATLAB:\n"]  # fmt: skip
    below = ["", "", "", "\n\nMfG", "\n\nBest regards,\nTom", "\n(SI units)", f"\n{units}",
             "\n\nThanks", "\n\n-- \nTom", "\nIs that right?", "\n\nVG Lena", "\n>> ", "\nIn [4]: ",
             "\nin SI units", "\n\nCheers, Jo", "\n% done", "\nWhy is it wrong?"]  # fmt: skip
    a, b = str(rng.choice(above)), str(rng.choice(below))
    return a + grid + b, f"around {a!r} {b!r}" if a + b else "bare"


def prompted(rng, text: str, name: str) -> str:
    """What a program puts before its answer, or what one types to be given it."""
    before = ["", "", f"{name} = ", f"{name} =\n\n", f">> {name} = ", f">> {name}\n\n{name} =\n\n",
              "In [3]: ", "Out[3]: ", f"In [3]: {name}\nOut[3]: ", ">>> ", f">>> {name}\n",
              f"{name}:\n", "ans =\n\n", f"{name} := "]  # fmt: skip
    return str(rng.choice(before)) + text


def aligned(cells: list[list[str]], gap: str = "  ") -> str:
    width = max(len(c) for row in cells for c in row)
    return "\n".join(gap.join(c.rjust(width) for c in row).rstrip() for row in cells)


def _listed(cells: list[list[str]], brackets: str = "[]", comma: str = ", ", row: str = ",\n "):
    first, last = brackets
    return first + row.join(first + comma.join(r) + last for r in cells) + last


def _latex(cells: list[list[str]], kind: str) -> str:
    body = " \\\\\n".join(" & ".join(row) for row in cells)
    if kind == "array":
        return f"\\left[\\begin{{array}}{{{'c' * len(cells[0])}}}\n{body}\n\\end{{array}}\\right]"
    return f"\\begin{{{kind}}}\n{body}\n\\end{{{kind}}}"


def grid(rng, cells: list[list[str]], name: str) -> tuple[str, str]:
    """A matrix of printed numbers in one of the notations."""
    comma = [[c.replace(".", ",") for c in row] for row in cells]
    n = len(cells[0])
    ways = {
        "plain": lambda: aligned(cells),
        "matlab typed": lambda: f"{name} = [" + ";\n ".join(" ".join(r) for r in cells) + "];",
        "matlab commas": lambda: f"{name} = [" + "; ".join(", ".join(r) for r in cells) + "]",
        "matlab printed": lambda: f"{name} =\n\n" + aligned(cells, "   ") + "\n",
        "matlab columns": lambda: _matlab_columns(cells, name),
        "numpy print": lambda: prompted(rng, _listed(cells, "[]", " ", "\n "), name),
        "numpy repr": lambda: prompted(rng, f"array({_listed(cells)})", name),
        "numpy code": lambda: f"{name} = np.array({_listed(cells)})",
        "numpy dtype": lambda: f"array({_listed(cells)}, dtype=float32)",
        "sympy": lambda: prompted(rng, f"Matrix({_listed(cells)})", name),
        "mathematica": lambda: _listed(cells, "{}"),
        "bmatrix": lambda: f"$${name} = " + _latex(cells, "bmatrix") + "$$",
        "pmatrix": lambda: _latex(cells, "pmatrix"),
        "array": lambda: f"\\[ {name} = " + _latex(cells, "array") + " \\]",
        "excel": lambda: "\n".join("\t".join(r) for r in cells),
        "excel comma": lambda: "\n".join("\t".join(r) for r in comma),
        "csv": lambda: "\n".join(",".join(r) for r in cells),
        "csv semicolon": lambda: "\n".join(";".join(r) for r in comma),
        "markdown": lambda: "\n".join("| " + " | ".join(r) + " |" for r in cells),
        "pandas": lambda: aligned([["", *map(str, range(n))],
                                   *([str(i), *r] for i, r in enumerate(cells))]),
        "pandas named": lambda: aligned([["", *(f"q{i + 1}" for i in range(n))],
                                         *([f"r{i + 1}", *r] for i, r in enumerate(cells))]),
        "r": lambda: aligned([["", *(f"[,{i + 1}]" for i in range(n))],
                              *([f"[{i + 1},]", *r] for i, r in enumerate(cells))]),
        "julia": lambda: f"{len(cells)}×{n} Matrix{{Float64}}:\n" + aligned(cells),
        "octave": lambda: f"{name} =\n\n" + aligned(cells, "   ") + "\n\n",
        "eigen": lambda: f"{name} << " + ",\n ".join(", ".join(r) for r in cells) + ";",
    }  # fmt: skip
    how = str(rng.choice(list(ways)))
    return ways[how](), how


def _matlab_columns(cells: list[list[str]], name: str) -> str:
    n = len(cells[0])
    if n < 5:
        return f"{name} =\n\n" + aligned(cells, "   ")
    first = aligned([r[:4] for r in cells], "   ")
    rest = aligned([r[4:] for r in cells], "   ")
    last = f"Columns 5 through {n}" if n > 5 else "Column 5"
    return f"{name} =\n\n  Columns 1 through 4\n\n{first}\n\n  {last}\n\n{rest}\n"


# Jacobians


def jacobian_text(rng, J: np.ndarray, digits: int) -> tuple[str, str]:
    style = "significant" if rng.random() < 0.15 else "fixed"
    cells = [[number(x, digits, style) for x in row] for row in J]
    if rng.random() < 0.12:
        names = ("v_x", "v_y", "v_z", "w_x", "w_y", "w_z")
        heads = ["", *(f"Joint {i + 1}" for i in range(J.shape[1]))] if rng.random() < 0.5 else None
        labelled = [[n, *r] for n, r in zip(names, cells, strict=True)]
        text = "\n".join("\t".join(r) for r in ([heads] if heads else []) + labelled)
        how = "labelled rows" + (", heads" if heads else "")
    else:
        text, how = grid(rng, cells, str(rng.choice(["J", "jac", "J0", "Jacobian"])))
    text, more = around(rng, text, "m and rad")
    return text, f"{how}, {style} {digits}, {more}"


# Torques


def column(rng, x: np.ndarray, digits: int, name: str, unit: str) -> tuple[str, str]:
    style = "significant" if rng.random() < 0.2 else "fixed"
    values = [number(v, digits, style) for v in x]
    n = range(1, len(values) + 1)
    ways = {
        "row": lambda: " ".join(values),
        "commas": lambda: ", ".join(values),
        "brackets": lambda: "[" + ", ".join(values) + "]",
        "brackets unit": lambda: "[" + ", ".join(values) + f"] {unit}",
        "Nm": lambda: "[" + ", ".join(values) + "] Nm",
        "N·m each": lambda: "\n".join(f"{v} N·m" for v in values),
        "Nm listed": lambda: ", ".join(f"{v} Nm" for v in values),
        "lines": lambda: "\n".join(values),
        "comma lines": lambda: "\n".join(v.replace(".", ",") for v in values),
        "named": lambda: "\n".join(f"{name}{i} = {v}" for i, v in zip(n, values, strict=True)),
        "named unit": lambda: "\n".join(
            f"{name}_{i} = {v} {unit}" for i, v in zip(n, values, strict=True)
        ),
        "greek": lambda: ", ".join(f"τ{i} = {v}" for i, v in zip(n, values, strict=True)),
        "joint": lambda: "\n".join(f"Joint {i}: {v} Nm" for i, v in zip(n, values, strict=True)),
        "joint tab": lambda: "\n".join(f"Joint {i}\t{v}" for i, v in zip(n, values, strict=True)),
        "series": lambda: (
            "\n".join(f"{i - 1}    {v}" for i, v in zip(n, values, strict=True))
            + "\ndtype: float64"
        ),
        "matlab": lambda: f"{name} =\n\n" + "\n".join(f"   {v}" for v in values) + "\n",
        "matlab typed": lambda: f"{name} = [" + "; ".join(values) + "];",
        "numpy": lambda: "array([" + ", ".join(values) + "])",
        "numpy print": lambda: "[" + " ".join(values) + "]",
        "numpy column": lambda: "[[" + "]\n [".join(values) + "]]",
        "latex": lambda: f"\\tau = {_latex([[v] for v in values], 'bmatrix')} \\text{{Nm}}",
        "latex plain": lambda: _latex([[v] for v in values], "pmatrix"),
        "transposed": lambda: f"{name} = (" + ", ".join(values) + ")^T",
        "heads": lambda: "\t".join(f"Joint {i}" for i in n) + "\n" + "\t".join(values),
    }
    how = str(rng.choice(list(ways)))
    text, more = around(rng, ways[how](), unit)
    return text, f"{how}, {style} {digits}, {more}"


# Joint values


def joints_text(rng, answers: np.ndarray, turns: list[bool], digits: int):
    """Joint lists in rad or degrees, the option that says which, and how they were typed."""
    turning = np.array(turns)
    degrees = bool(rng.random() < 0.4)
    shown = np.where(turning, np.degrees(answers) if degrees else answers, answers)
    sliding = 4 if rng.random() < 0.5 else digits
    values = [
        [
            number(x, max(digits - 2, 2) if degrees and turn else digits if turn else sliding)
            for x, turn in zip(row, turns, strict=True)
        ]
        for row in shown
    ]
    mark = "°" if degrees else ""
    one = len(values) == 1

    def named(row, sep, name="θ"):
        signs = [mark if turn else "" for turn in turns]
        return sep.join(
            f"{name}{i + 1} = {v}{s}" for i, (v, s) in enumerate(zip(row, signs, strict=True))
        )

    ways = {
        "listed": lambda: _listed(values) if not one else "[" + ", ".join(values[0]) + "]",
        "plain": lambda: aligned(values),
        "excel": lambda: "\n".join("\t".join(r) for r in values),
        "numpy print": lambda: _listed(values, "[]", " ", "\n "),
        "named": lambda: "\n".join(named(r, ", ") for r in values),
        "solutions": lambda: "\n".join(
            f"Solution {i + 1}: {named(r, ', ')}" for i, r in enumerate(values)
        ),
        "solution lists": lambda: "\n".join(
            f"Solution {i + 1}: [{', '.join(r)}]" for i, r in enumerate(values)
        ),
        "numbered": lambda: "\n".join(f"{i + 1}) ({', '.join(r)})" for i, r in enumerate(values)),
        "lines": lambda: "\n\n".join(named(r, "\n", "q") for r in values),
        "semicolons": lambda: "q = [" + "; ".join(" ".join(r) for r in values) + "]",
        "latex": lambda: _latex(values, "bmatrix"),
        "heads": lambda: "\t".join(f"q{i + 1}" for i in range(len(turns)))
        + "\n" + "\n".join("\t".join(r) for r in values),
    }  # fmt: skip
    how = str(rng.choice(list(ways)))
    text, more = around(rng, ways[how](), "rad") if not degrees else around(rng, ways[how](), "deg")
    return text, {"angles": "deg" if degrees else "rad"}, f"{how}, {digits}, {more}"


# Tables


def table_text(rng, rows: list, unitless: bool = False) -> tuple[str, str]:
    """A table with its joint variables, units and heads; in m and rad without units in the heads
    where asked for."""
    unit = "m" if unitless else str(rng.choice(["m", "mm"]))
    angle = "rad" if unitless else str(rng.choice(["pi", "deg", "rad", "π", "°"]))
    variable = str(rng.choice(["q{}", "theta{}", "θ{}", "θ_{}", "q_{}", "theta_{}*", "Θ{}"]))
    order = [list(NAMES), ["theta", "d", "a", "alpha"], ["alpha", "a", "theta", "d"],
             ["theta", "a", "d", "alpha"]][rng.integers(4)]  # fmt: skip
    cells = [_row(i + 1, row, unit, angle, variable) for i, row in enumerate(rows)]
    heads = {
        "bare": order,
        "units": [f"{n} [{unit if n in 'ad' else _unit(angle)}]" for n in order],
        "round": [f"{n} ({unit if n in 'ad' else _unit(angle)})" for n in order],
        "greek": [{"alpha": "α", "theta": "θ"}.get(n, n) for n in order],
        "indexed": [f"{n}_i" for n in order],
    }
    kind = str(rng.choice(list(heads)))
    if unitless or unit == "mm":
        kind = "greek" if unitless else "units"
    body = [[row[n] for n in order] for row in cells]
    first = str(rng.choice(["", "", "i", "Joint", "Link", "Joint N", "Link N", "n."]))
    head = heads[kind]
    if first:
        labels = {"Joint N": "Joint {}", "Link N": "Link {}", "n.": "{}."}.get(first, "{}")
        top = {"Joint N": "", "Link N": "Link", "n.": "No."}.get(first, first)
        head = [top, *head]
        body = [[labels.format(i + 1), *r] for i, r in enumerate(body)]
    ways = {
        "excel": lambda: "\n".join("\t".join(r) for r in [head, *body]),
        "csv": lambda: "\n".join(",".join(r) for r in [head, *body]),
        "csv semicolon": lambda: "\n".join(
            ";".join(c.replace(".", ",") for c in r) for r in [head, *body]
        ),
        "spaces": lambda: aligned([head, *body], "   "),
        "single spaces": lambda: "\n".join(" ".join(c for c in r if c) for r in [head, *body]),
        "markdown": lambda: "\n".join(
            "| " + " | ".join(r) + " |" for r in [head, ["---"] * len(head), *body]
        ),
        "latex": lambda: "\\begin{tabular}{|" + "c|" * len(head) + "}\n\\hline\n"
        + " \\\\ \\hline\n".join(" & ".join(map(_tex, r)) for r in [head, *body])
        + " \\\\ \\hline\n\\end{tabular}",
    }  # fmt: skip
    how = str(rng.choice(list(ways)))
    text, more = around(rng, ways[how]())
    return text, f"{how}, {kind} {first!r}, {unit} {angle} {variable}, {more}"


def _unit(angle: str) -> str:
    return {"deg": "deg", "°": "°"}.get(angle, "rad")


def _tex(cell: str) -> str:
    for word in ("alpha", "theta", "pi"):
        cell = cell.replace(word, f"\\{word}")
    return "$" + cell.replace("°", "^\\circ") + "$" if any(c.isalpha() for c in cell) else cell


def _row(i: int, row: tuple, unit: str, angle: str, variable: str) -> dict[str, str]:
    kind, a, alpha, d, theta = row
    cells = {n: _length(x, unit) for n, x in (("a", a), ("d", d))}
    cells |= {n: _angle(x, angle) for n, x in (("alpha", alpha), ("theta", theta))}
    if kind == "F":
        return cells
    moves = "theta" if kind == "R" else "d"
    q = variable.format(i) if kind == "R" or "q" in variable else f"d{i}"
    offset = cells[moves]
    sign = "" if offset.startswith("-") else "+"
    return cells | {moves: q if float(row[4 if kind == "R" else 3]) == 0 else f"{q}{sign}{offset}"}


def _length(x: float, unit: str) -> str:
    text = f"{x * (1000 if unit == 'mm' else 1):.6g}"
    return "0" if float(text) == 0 else text


def _angle(x: float, style: str) -> str:
    turns = round(x / (np.pi / 2), 9)
    if turns == 0:
        return "0"
    if style in ("pi", "π") and turns in (1, -1, 2, -2):
        sign = "-" if turns < 0 else ""
        return f"{sign}{style}" + ("/2" if abs(turns) == 1 else "")
    if style in ("deg", "°"):
        return f"{np.degrees(x):.6g}" + ("°" if style == "°" else "")
    return f"{x:.4f}"
