"""The elbow arm's table in the forms in which people hold one, typed by hand, and what is none."""

ROWS = [("0", "pi/2", "0.5", "q1"), ("0.4", "0", "0", "q2"), ("0.3", "0", "0", "q3")]


def joined(rows, cell, row, start="", end=""):
    return start + row.join(cell.join(line) for line in rows) + end


MATRICES = (
    "[cos(q1), 0, sin(q1), 0], [sin(q1), 0, -cos(q1), 0], [0, 1, 0, 0.5], [0, 0, 0, 1]",
    "[c2, -s2, 0, 0.4*c2], [s2, c2, 0, 0.4*s2], [0, 0, 1, 0], [0, 0, 0, 1]",
    "[c3, -s3, 0, 0.3*c3], [s3, c3, 0, 0.3*s3], [0, 0, 1, 0], [0, 0, 0, 1]",
)
PRINTED = """+---+-----------+-----------+-----------+-----------+-----------+
| j |     theta |         d |         a |     alpha |    offset |
+---+-----------+-----------+-----------+-----------+-----------+
|  1|         q1|        0.5|          0|     1.5708|          0|
|  2|         q2|          0|        0.4|          0|          0|
|  3|         q3|          0|        0.3|          0|          0|
+---+-----------+-----------+-----------+-----------+-----------+"""
CRAIG = ("0 0 0.5 q1", "0 pi/2 0 q2", "0.4 0 0 q3", "0.3 0 0 0")

RIGHT = {
    "stars first": "theta a alpha d\nθ_1* 0 pi/2 0.5\nθ_2* 0.4 0 0\nθ_3* 0.3 0 0",
    "stars raised": "theta^* a alpha d\nq_1^* 0 pi/2 0.5\nq_2^* 0.4 0 0\nq_3^* 0.3 0 0",
    "LaTeX in CSV": "$\\theta_1^*$, 0, $\\pi/2$, 0.5\n"
    "$\\theta_2^*$, 0.4, 0, 0\n$\\theta_3^*$, 0.3, 0, 0",
    "centimetres": "q1 50 0 pi/2\nq2 0 40 0\nq3 0 30 0",
    "centimetres, numbers alone": "50 0 90 0\n0 40 0 0\n0 30 0 0",
    "quoted": "[[0, 'pi/2', 0.5, 'q1'], [0.4, 0, 0, 'q2'], [0.3, 0, 0, 'q3']]",
    "sympy": "Matrix([[0, pi/2, 1/2, q_1(t)], [2/5, 0, 0, q_2(t)], [3/10, 0, 0, q_3(t)]])",
    "matlab inf": "[0 pi/2 0.5 inf\n0.4 0 0 inf\n0.3 0 0 inf]",
    "matlab inf first": "DH = [inf 0.5 0 pi/2; inf 0 0.4 0; inf 0 0.3 0];",
    "matlab mm": "[0 90 500 0; 400 0 0 0; 300 0 0 0]",
    "dictionary of lists": "{'a': [0, 0.4, 0.3], 'alpha': [pi/2, 0, 0],\n 'd': [0.5, 0, 0], "
    "'theta': ['q1', 'q2', 'q3']}",
    "greek dictionaries": "[{'a': 0, 'α': 90°, 'd': 0.5, 'θ': q1}, {'a': 0.4, 'α': 0, 'd': 0, "
    "'θ': q2}, {'a': 0.3, 'α': 0, 'd': 0, 'θ': q3}]",
    "substitutions": "{a1: 0, alpha1: pi/2, d1: 0.5, a2: 0.4, d2: 0, a3: 0.3}",
    "links": "L(1) = Link('d', 0.5, 'a', 0, 'alpha', pi/2);\nL(2) = Link('d', 0, 'a', 0.4, "
    "'alpha', 0);\nL(3) = Link('d', 0, 'a', 0.3, 'alpha', 0);",
    "short links": "L1 = Link([0 0.5 0 pi/2]); L2 = Link([0 0 0.4 0]); L3 = Link([0 0 0.3 0]);",
    "links of python": "RevoluteDH(d=0.5, alpha=pi/2), RevoluteDH(a=0.4), RevoluteDH(a=0.3)",
    "matrices": "[[" + "], [".join(MATRICES) + "]]",
    "units apart": "a (mm) alpha (deg) d (mm) theta (deg)\n0 90 500 q1\n400 0 0 q2\n300 0 0 q3",
    "joints in brackets": "[[0, pi/2, 0.5, q[0]], [0.4, 0, 0, q[1]], [0.3, 0, 0, q[2]]]",
    "joints in round ones": "[0 deg2rad(90) 0.5 q(1); 0.4 0 0 q(2); 0.3 0 0 q(3)]",
    "a row of units": "a\talpha\td\ttheta\n[mm]\t[deg]\t[mm]\t\n0\t90\t500\tq1\n400\t0\t0\tq2\n"
    "300\t0\t0\tq3",
    "rows numbered": "1) 0, 90°, 0.5, θ1\n2) 0.4, 0, 0, θ2\n3) 0.3, 0, 0, θ3",
    "two blanks": "0   pi / 2   1 / 2   -q_1\n0.4   0   0   q_2\n0.3   0   0   q_3",
    "two blanks, as many": "0  pi /2   0.5  q_1\n0.4  0 /2   0  q_2\n0.3  0 /2   0  q_3",
    "captions": "Table 1: the elbow\n\n(by hand)\na  alpha  d  theta\n" + joined(ROWS, "  ", "\n"),
    "curled quotes": "[{‘a’: 0, ‘alpha’: pi/2, ‘d’: 0.5}, {“a”: 0.4, “alpha”: 0, “d”: 0}, "
    "{‘a’: 0.3, ‘alpha’: 0, ‘d’: 0}]",
    "degrees in words": "0, 90 degrees, 0.5, q1\n0.4, 0 degrees, 0, q2\n0.3, 0, 0, q3",
    "degrees of siunitx": r"\begin{tabular}{cccc} 0 & \ang{90} & 0.5 & $q_1$ \\ "
    r"0.4 & \SI{0}{\degree} & 0 & $q_2$ \\ 0.3 & \ang{0} & 0 & $q_3$ \end{tabular}",
    "printed": PRINTED,
    "craig": "a_{i-1} alpha_{i-1} d theta\n" + "\n".join(CRAIG),
}

REFUSED = {
    "a alpha d theta": "expected rows of four entries",
    "| alpha_{i-1} | a_{i-1} | d | theta |": "expected rows of four entries",
    "": "empty",
    "hello": "expected rows of four entries",
    "0 1 2\n0 1 2 3": "the line '0 1 2' stands beside the rows",
    "0\t90\t0.5\tq1\n0.4\t0\n0.3\t0\t0\tq3": "the line '0.4 0' stands beside the rows",
    "a = [0, 0.4]\nalpha = [pi/2, 0, 0]\nd = [0.5, 0, 0]": "lists have 2, 3 entries",
    "a alpha d theta\n0 pi/2 l_9 q1\n0.4 0 0 q2\n0.3 0 0 q3": "no value for l_9",
    "a alpha d theta\n0 pi/2 0.5 q1 + q2\n0.4 0 0 q2\n0.3 0 0 q3": "no value for q2",
    "a alpha d theta\n0 pi/2 0.5 q1/2\n0.4 0 0 q2\n0.3 0 0 q3": "theta grows by 0.5",
    "a alpha d theta\n0 pi/0 0.5 q1\n0.4 0 0 q2\n0.3 0 0 q3": "divides by zero",
    "d999999999 = 1\n" * 6: "expected rows of four entries",
    "a alpha d theta\n0 90 0.5 q1\n0.4 0 0 q2\n0.3 1.57 0 q3": "90 and 1.57, an angle in degrees",
    "0 0 0.1 q1\n" * 40: "40 rows; expected at most 32",
    "1 0 0 0\n0 1 0\n0 0 1 0\n0 0 0 1\n" * 2: "the line '0 1 0' stands beside",
    "a alpha d theta\n0 0 0 __import__('os')": "expected rows of four entries",
}
