"""Joint angles and runs of the elbow arm in the forms in which people hold them, typed by hand."""

# The tip at (0.5, 0.7, -0.4) rad by hand: r = 0.4 cos 0.7 + 0.3 cos 0.3, z = 0.5 + 0.4 sin 0.7
# + 0.3 sin 0.3.
POINT = "0.5200, 0.2841, 0.8463"

# One answer, right to its digits.
ANGLES = {
    "numpy wrapped": "[ 0.5  0.7\n -0.4]",
    "transposed": "q = [0.5, 0.7, -0.4]^T",
    "latex transposed": r"\begin{bmatrix} 0.5 & 0.7 & -0.4 \end{bmatrix}^{T}",
    "matlab transposed": "q = [0.5 0.7 -0.4]';",
    "latex named": r"\theta_1 = 0.5, \theta_{2} = 0.7, \theta_3 = -0.4",
    "equations": "theta1 = 0.5, theta2 = 0.7, theta3 = -0.4",
    "colons": "q1: 0.5\nq2: 0.7\nq3: -0.4",
    "pairs": "('Theta1', 0.5), ('Theta2', 0.7), ('Theta3', -0.4)",
    "list of pairs": "[('theta1', 0.5), ('theta2', 0.7), ('theta3', -0.4)]",
    "dictionary": "{'theta1': 0.5, 'theta2': 0.7, 'theta3': -0.4}",
    "json": '{"q1": 0.5, "q2": 0.7, "q3": -0.4}',
    "formulas of pi": "pi/2 - 1.0708, 0.7, -pi + 2.7416",
    "numpy formulas": "[np.radians(28.6479), np.deg2rad(40.107), -0.4]",
    "a turn more": "6.7832, 0.7, -0.4",
}


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
    "csv headed": lambda q: "\n".join(headed(q, ["q1", "q2", "q3"], ",")),
    "csv with times": lambda q: "\n".join(headed(timed(q), ["t", "q1", "q2", "q3"], ",")),
    "savetxt headed": lambda q: "# q1 q2 q3\n" + "\n".join(steps(q, " ")),
    "excel": lambda q: "\r\n".join(steps(timed(q), "\t")).replace(".", ","),
    "list per joint": lambda q: "[" + ", ".join(f"[{row}]" for row in steps(turned(q))) + "]",
    "matlab print": lambda q: "q =\n\n   " + "\n   ".join(steps(q, "   ", 4)) + "\n",
    "matlab transposed": lambda q: "q = [" + "; ".join(steps(turned(q), " ")) + "];",
    "without the last": lambda q: "\n".join(steps(q[:-1], ",")),
}  # fmt: skip
