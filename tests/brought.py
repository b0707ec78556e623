"""What people bring, a row or more for each finding on the judge: a question of the page and what
is said of it. Numbers that are right are those of `helpers`, which share no line with `judge/`."""

import numpy as np

from helpers import inverse
from helpers.kinematics import forward_kinematics, jacobian
from helpers.robots import ELBOW, STANFORD, UR10E, UR10E_HOMEWORK
from helpers.statics import static_torque

Q = np.array([0.3, -1.1, 1.4, -0.8, 0.9, 0.2])
PUSH = [0, 0, -20, 0, 0, 0]
TAU = static_torque(UR10E, Q, PUSH).round(4)
LATEX = "\\begin{bmatrix}\n" + " \\\\\n".join(map(str, TAU)) + "\n\\end{bmatrix}"
REACHED, THERE = (forward_kinematics(UR10E, Q)[:3, 3], (0.3, 0.2, 0.7))
LAYOUT = """         theta [rad] a [m] d [m] alpha [rad]
Joint 1 0 0 0.1807 π/2
Joint 2 0 -0.6127 0 0
Joint 3 0 -0.57155 0 0
Joint 4 0 0 0.17415 π/2
Joint 5 0 0 0.11985 -π/2
Joint 6 0 0 0.21655 0"""
UR = {"arm": "UR10E", "q": ", ".join(map(str, Q))}
RIGHT, COMPLETE = "The torques of UR10e are right", "are right and complete"


def text(numbers, form=".4f", sep=", "):
    return sep.join(format(x, form) for x in numbers)


def rows(numbers, form=".4f"):
    return "\n".join(text(row, form, " ") for row in numbers)


def tau(answer):
    return {"ask": "torques", **UR, "wrench": text(PUSH, "g"), "answer": answer}


def table(answer, arm="ELBOW"):
    return {"ask": "table", "arm": arm, "answer": answer}


def angles(ask, answer, target=THERE, arm="ELBOW", **more):
    return {"ask": ask, "arm": arm, "target": text(target, "g"), "answer": answer, **more}


def answers(solver, arm, target):
    found = solver(arm, target)
    return found.q[found.valid]


def of_stanford():
    """Radians to three decimals beside a slide to four."""
    T = forward_kinematics(STANFORD, [0.3, -0.9, 0.4, 0.5, 0.8, -0.6])
    lines = [[f"{x:.{4 if k == 2 else 3}f}" for k, x in enumerate(q)]
             for q in answers(inverse.stanford, STANFORD, T)]  # fmt: skip
    asked = angles("branches", "\n".join(map(", ".join, lines)), arm="STANFORD")
    return {**asked, "target": rows(T[:3], ".6f")}


def numbered(form):
    four = answers(inverse.elbow, ELBOW, THERE).round(4)
    return "\n".join(form.format(i, *q) for i, q in enumerate(four, 1))


def swapped(arm, q):
    J = jacobian(arm, q)
    return rows(np.vstack([J[3:], J[:3]]))


UR10 = UR10E.with_values(d_1=0.1273, a_2=0.612, a_3=0.5723, d_4=0.163941, d_5=0.1157, d_6=0.0922)
BENT = {"arm": "ELBOW", "q": text(np.degrees([0.5, 0.7, -0.4]))}
FORMULAS = """[-s1*(a_2c_2+a_3c_{23}), -c1*(a_2s_2+a_3s_{23}), -c_1a_3s_{23};
 c1*(a_2c_2+a_3c_{23}), -s1*(a_2s_2+a_3s_{23}), -s_1a_3s_{23};
 0, a_2c_2+a_3c_{23}, a_3c_{23}; 0, s1, s1; 0, -c1, -c1; 1, 0, 0]"""
BROUGHT = [
    ("C.1", tau(f"My answer: 99\n{LATEX}"), "set aside: `My answer: 99`"),
    ("C.2", tau("1e9 " * 6), "are not right"),
    ("C.2", angles("branches", "1e22 1e22 1e22"), "0 of 4 branches are found"),
    ("C.3", {"ask": "jacobian", **UR, "answer": rows(jacobian(UR10E_HOMEWORK, Q))},
     "This is right for UR10e (homework), whose lengths are 128, 612.7, 571.6, 163.9"),
    ("C.4", table(LAYOUT, "UR10E"), "describes the same arm as UR10e."),
    ("C.5", of_stanford(), COMPLETE),
    ("C.6", tau(text(TAU, ".3f", "\n").replace(".", ",")), RIGHT),
    *(("C.7", tau(f"Hi, is this right?\n\n{TAU.tolist()} N m\n\nMfG\nTom"), words)
      for words in (RIGHT, "Hi, is this right?", "MfG", "Tom")),
    ("C.8", angles("pose", "33.69, 65.831, 46.525", (0.12, 0.08, 0.15), unit="deg"),
     "there: it misses the target by 997 mm."),
    ("C.8", angles("branches", "1 2 3"), "Answer 1 misses the target by 454 mm"),
    ("C.8", tau("0 0 0 0 0 0"), "every torque is 0"),
    ("C.8", tau(text(TAU, ".0f")), "are right so far"),
    ("C.8", tau(text(np.trunc(100 * TAU) / 100, ".2f")), "your digits are cut"),
    ("C.9", table("theta d a alpha\nq1 0.5 0 90\nq2 0.4 0 0\nq3 0 0.3 0"),
     "a and d of row 2 are exchanged"),
    ("C.9", {"ask": "jacobian", **UR, "answer": rows(jacobian(UR10, Q), ".5f")},
     "the lengths are those of the UR10,"),
    ("C.9", angles("pose", text(Q), 1000 * REACHED, "UR10E"), "the target is in millimetres"),
    ("C.9", tau(text(1000 * TAU, ".1f")), "the torques are in N mm"),
    ("C.10", table("q1 0.5 0 90\nq2+30 0 0.4 0\nq3 0 0.3 0"), "takes the tip elsewhere"),
    ("C.11", {"ask": "jacobian", **BENT, "answer": swapped(ELBOW, [0.5, 0.7, -0.4])},
     "linear and angular rows are exchanged"),
    ("C.12", tau(""), ""),
    *(("C.13", angles("branches", numbered(form)), COMPLETE)
      for form in ("Solution {}: Θ₁ = {}, Θ₂ = {}, Θ₃ = {}", "{}) ({}, {}, {})")),
    *(("C.13", tau("\n".join(form.format(*x) for x in enumerate(TAU, 1))), RIGHT)
      for form in ("Joint {}\t{}", "Joint {}: {} N·m", "τ_{} = {} Nm")),
    ("C.13", {"ask": "jacobian", "arm": "PANDA.lock(3)", "q": "0, " * 6 + "0", "answer": "1"},
     "write 6x6"),
    ("C.13", tau("[0.1 0.2 ... 0.5 0.6]"), "he print was cut"),
    ("C.13", {**tau(text(TAU)), "wrench": "[0, 0, -20, 0, 0, 0] N"}, RIGHT),
    *(("C.13", {"ask": "jacobian", **BENT, "unit": "deg", "answer": start + FORMULAS},
       "The Jacobian of Elbow arm is right") for start in ("", "J = @(q1,q2,q3) ")),
    ("C.14", table("q1 -0.5 0 -90\nq2 0 0.4 0\nq3 0 0.3 0"), "takes the tip elsewhere"),
]  # fmt: skip
