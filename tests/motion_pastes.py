"""Joint angles and runs of the elbow arm in the forms in which people hold them, typed by hand."""

# The tip at (0.5, 0.7, -0.4) rad by hand: r = 0.4 cos 0.7 + 0.3 cos 0.3, z = 0.5 + 0.4 sin 0.7
# + 0.3 sin 0.3.
POINT = "0.5200, 0.2841, 0.8463"
POSE = "0.5, 0.7, -0.4"

# One answer, right to its digits.
ANGLES = {
    "bare": "0.5, 0.7, -0.4",
    "blanks": "0.5 0.7 -0.4",
    "tuple": "(0.5, 0.7, -0.4)",
    "list": "[0.5, 0.7, -0.4]",
    "nested": "[[0.5, 0.7, -0.4]]",
    "numpy": "array([ 0.5,  0.7, -0.4])",
    "numpy named": "q = np.array([0.5, 0.7, -0.4])",
    "numpy print": "[ 0.5  0.7 -0.4]",
    "numpy rows": "[[ 0.5]\n [ 0.7]\n [-0.4]]",
    "sympy": "Matrix([[0.5], [0.7], [-0.4]])",
    "matlab": "q = [0.5 0.7 -0.4];",
    "matlab column": "q = [0.5; 0.7; -0.4]",
    "matlab print": "q =\n\n    0.5000    0.7000   -0.4000\n",
    "matlab print column": "ans =\n\n    0.5000\n    0.7000\n   -0.4000\n",
    "latex": r"\begin{pmatrix} 0.5 & 0.7 & -0.4 \end{pmatrix}",
    "numpy wrapped": "[ 0.5  0.7\n -0.4]",
    "transposed": "q = [0.5, 0.7, -0.4]^T",
    "latex transposed": r"\begin{bmatrix} 0.5 & 0.7 & -0.4 \end{bmatrix}^{T}",
    "matlab transposed": "q = [0.5 0.7 -0.4]';",
    "latex column": r"q = \begin{bmatrix} 0.5 \\ 0.7 \\ -0.4 \end{bmatrix}",
    "latex named": r"\theta_1 = 0.5, \theta_{2} = 0.7, \theta_3 = -0.4",
    "csv": "0.5,0.7,-0.4\n",
    "csv headed": "q1,q2,q3\n0.5,0.7,-0.4\n",
    "semicolons": "0.5;0.7;-0.4",
    "excel": "0.5\t0.7\t-0.4",
    "excel decimal": "0,5\t0,7\t-0,4\r\n",
    "excel column": "0.5\r\n0.7\r\n-0.4\r\n",
    "markdown": "| q1 | q2 | q3 |\n|---|---|---|\n| 0.5 | 0.7 | -0.4 |",
    "equations": "theta1 = 0.5, theta2 = 0.7, theta3 = -0.4",
    "equations under each other": "q_1 = 0.5\nq_2 = 0.7\nq_3 = -0.4",
    "greek": "θ1 = 0.5, θ2 = 0.7, θ3 = −0.4",
    "colons": "q1: 0.5\nq2: 0.7\nq3: -0.4",
    "pairs": "('Theta1', 0.5), ('Theta2', 0.7), ('Theta3', -0.4)",
    "list of pairs": "[('theta1', 0.5), ('theta2', 0.7), ('theta3', -0.4)]",
    "dictionary": "{'theta1': 0.5, 'theta2': 0.7, 'theta3': -0.4}",
    "json": '{"q1": 0.5, "q2": 0.7, "q3": -0.4}',
    "formulas": "1/2, 7/10, -2/5",
    "formulas of pi": "pi/2 - 1.0708, 0.7, -pi + 2.7416",
    "numpy formulas": "[np.radians(28.6479), np.deg2rad(40.107), -0.4]",
    "degrees by sign": "28.6479°, 40.1070°, -22.9183°",
    "a turn more": "6.7832, 0.7, -0.4",
    "code": "```\n0.5 0.7 -0.4\n```",
}
IN_DEGREES = {
    "bare": "28.65, 40.11, -22.92",
    "matlab": "rad2deg(q) = [28.6479 40.1070 -22.9183]",
    "named": "theta1 = 28.65, theta2 = 40.11, theta3 = -22.92",
}
UNREAD = ["", "no idea", "0.5, 0.7", "1 2 3 4", "[[0.5, 0.7], [1]]", "q_9, 0, 0", "nan 0 0"]


# Rows of joints in the forms in which a run is held.


def steps(rows, cell=", ", decimals=6):
    return [cell.join(f"{x:.{decimals}f}" for x in row) for row in rows]


def headed(rows, names, cell):
    return [cell.join(names), *steps(rows, cell)]


def turned(rows):
    return zip(*rows, strict=True)


def timed(rows, period=5.0):
    return [(period * k / (len(rows) - 1), *row) for k, row in enumerate(rows)]


RUNS = {
    "csv": lambda q: "\n".join(steps(q, ",")),
    "csv of windows": lambda q: "\r\n".join(steps(q, ",")) + "\r\n",
    "csv headed": lambda q: "\n".join(headed(q, ["q1", "q2", "q3"], ",")),
    "csv with times": lambda q: "\n".join(headed(timed(q), ["t", "q1", "q2", "q3"], ",")),
    "semicolons and decimal commas": lambda q: "\n".join(steps(q, ";")).replace(".", ","),
    "savetxt": lambda q: "\n".join(" ".join(f"{x:.18e}" for x in row) for row in q) + "\n",
    "savetxt headed": lambda q: "# q1 q2 q3\n" + "\n".join(steps(q, " ")),
    "tabs": lambda q: "\n".join(steps(q, "\t")),
    "excel": lambda q: "\r\n".join(steps(timed(q), "\t")).replace(".", ","),
    "numpy list": lambda q: "[" + ",\n ".join(f"[{row}]" for row in steps(q)) + "]",
    "numpy array": lambda q: "array([" + ",\n       ".join(f"[{row}]" for row in steps(q)) + "])",
    "numpy print": lambda q: "[" + "\n ".join(f"[{row}]" for row in steps(q, " ", 8)) + "]",
    "list per joint": lambda q: "[" + ", ".join(f"[{row}]" for row in steps(turned(q))) + "]",
    "matlab": lambda q: "q = [" + ";\n".join(steps(q, " ")) + "];",
    "matlab print": lambda q: "q =\n\n   " + "\n   ".join(steps(q, "   ", 4)) + "\n",
    "matlab transposed": lambda q: "q = [" + "; ".join(steps(turned(q), " ")) + "];",
    "markdown": lambda q: "| q1 | q2 | q3 |\n|--|--|--|\n| "
    + " |\n| ".join(steps(q, " | "))
    + " |",
    "latex": lambda q: r"\begin{tabular}{rrr} " + r" \\ ".join(steps(q, " & ")) + r" \end{tabular}",
    "without the last": lambda q: "\n".join(steps(q[:-1], ",")),
}  # fmt: skip
