"""Make and grade a class of 200 with spoiled hand-ins, with and without killed commands.

`python -m tests.measure.class_of_200 200 /tmp/class` prints what it measured. Students solve their
own sheets by plain matrices, complex steps and Newton's method instead of the key's functions;
only the DH table is copied from the key.
"""

import json
import os
import re
import signal
import subprocess
import sys
import time
from pathlib import Path

import numpy as np
import sympy as sp

from course import store
from course.making import make_right_answers
from tests.laws import complex_step_jacobian, slow_frames

ARGUMENTS = ["--arm", "Elbow arm", "--arm", "Stanford arm", "--topic", "forward kinematics"]


def write_column(arm, numbers):
    """Derive a column of the camera's Jacobian from products of symbolic DH matrices."""
    T, axes = sp.eye(4), []
    for row in arm.rows[: numbers["link"]]:
        axes.append(T[:3, 2])
        a, alpha, d, theta = (sp.sympify(entry) for entry in row.entries)
        theta += sp.Symbol(arm.variables[len(axes) - 1])
        c, s, ca, sa = sp.cos(theta), sp.sin(theta), sp.cos(alpha), sp.sin(alpha)
        T *= sp.Matrix([
            [c, -s * ca, s * sa, a * c], [s, c * ca, -c * sa, a * s], [0, sa, ca, d], [0, 0, 0, 1]
        ])  # fmt: skip
    x, z = numbers["camera"]
    column = numbers["column"]
    linear = (T * sp.Matrix([x, 0, z, 1]))[:3, 0].diff(sp.Symbol(arm.variables[column - 1]))
    return [str(entry) for entry in [*linear, *axes[column - 1]]]


def find_solutions(arm, target, count, rng):
    """Find joint angles of a point by Newton's method from random starts."""
    found = []
    for _ in range(400):
        q = rng.uniform(-np.pi, np.pi, arm.dof)
        for _ in range(30):
            error = target - slow_frames(arm, q)[-1][:3, 3]
            q = q + np.linalg.lstsq(complex_step_jacobian(arm, q)[:3], error, rcond=0.01)[0]
        q = (q + np.pi) % (2 * np.pi) - np.pi
        is_new = all(np.abs(np.exp(1j * q) - np.exp(1j * other)).max() > 1e-3 for other in found)
        if np.abs(error).max() < 1e-9 and is_new:
            found.append(q)
        if len(found) == count:
            break
    return np.array(found)


def solve(sheet, rng):
    """Solve a sheet without its answer key."""
    answers = {"table": make_right_answers(sheet)["table"]}
    for section in sheet.sections:
        arm = section.arm
        for topic, numbers in section.drawn.items():
            q = np.array(numbers.get("q", ()), dtype=float)
            if topic == "forward kinematics":
                T = slow_frames(arm, q)[-1]
                answers |= {f"p{section.suffix}": T[:3, 3], f"R{section.suffix}": T[:3, :3]}
            elif topic == "Jacobian":
                J = complex_step_jacobian(arm, q)
                answers |= {"J": J, "xi": J @ numbers["q_dot"]}
                answers["J_column"] = write_column(arm, numbers)
            elif topic == "inverse kinematics":
                count, target = len(sheet.parts["q"].value), np.array(numbers["target"])[:, 0]
                answers["q"] = find_solutions(arm, target, count, rng)
    return {
        name: np.vectorize("{:.4f}".format)(x).tolist() if isinstance(x, np.ndarray) else x
        for name, x in answers.items()
    }


def make_mistake(answers, number):
    """Change right answers as a student might."""
    p, J = np.array(answers["p"], float), np.array(answers["J"], float)
    changes = (
        {"p": (1000 * p).tolist()},
        {"J": [*(-J[:3]).tolist(), *J[3:].tolist()]},
        {"R": np.array(answers["R"], float).T.tolist()},
        {"p": (p * 1.02).tolist(), "q": answers["q"][:1]},
        {"J": J.round(1).tolist(), "J_column": ["1"] * 6},
    )
    return {**answers, **changes[number % len(changes)]}


def spoil(folder, text, number):
    """Write a hand-in that cannot be marked."""
    (folder / "answers.json").unlink()
    name, content = (
        ("answers.json", text[: len(text) // 2]),
        ("answers.json", ""),
        ("scan.pdf", "%PDF"),
        ("answers.json", "[" * 100_000),
        ("answers.json", json.dumps({"sheet": "ffffff/other", "p": [1, 2, 3]})),
    )[number % 5]
    (folder / name).write_text(content, encoding="utf-8")


def run(folder, command, until=None):
    """Run a command; kill it when `until` returns true. Return the seconds it took."""
    start = time.monotonic()
    line = [sys.executable, "-m", "course", *command]
    process = subprocess.Popen(line, cwd=folder, env={**os.environ, "PYTHONPATH": os.getcwd()})
    while process.poll() is None:
        if until and until():
            os.kill(process.pid, signal.SIGKILL)
        time.sleep(0.1)
    return time.monotonic() - start


def main(count, folder):
    """Print the times and whether killed commands end as others do."""
    folder.mkdir(parents=True)
    students = [f"s{n:03}" for n in range(count)]
    roster = "id,name\n" + "".join(f"{s},Student {s}\n" for s in students)
    (folder / "r.csv").write_text(roster, encoding="utf-8")
    hw, rng = folder / "hw", np.random.default_rng(0)
    new = ["new", "--roster", "r.csv", "--out", "hw", *ARGUMENTS]
    seconds = run(folder, new, lambda: len([*hw.glob("s*/homework.ipynb")]) >= count // 2)
    early = store.load_course(hw).sheets
    print(f"new: killed after {seconds:.0f} s with {len(early)} sheets")
    print(f"new again: {run(folder, new):.0f} s")
    course = store.load_course(hw)
    kept = all(course.sheets[student] == sheet for student, sheet in early.items())
    print(f"{len(course.sheets)} sheets; those of the killed command are kept: {kept}")
    start, parts = time.monotonic(), {}
    for number, student in enumerate(students):
        answers = {"sheet": store.name_sheet(course, student), **solve(course.sheet(student), rng)}
        answers = make_mistake(answers, number) if number % 10 in (1, 4, 7) else answers
        parts[student] = len(answers) - 1
        text = json.dumps(answers)
        (hw / student / "answers.json").write_text(text, encoding="utf-8")
        if number % 10 == 9:
            spoil(hw / student, text, number // 10)
    print(f"solved independently: {time.monotonic() - start:.0f} s")
    print(f"graded at once: {run(folder, ['grade', 'hw', '--out', 'whole']):.0f} s")
    marked = folder / "killed"
    grade = ["grade", "hw", "--out", "killed"]
    seconds = run(folder, grade, lambda: len([*marked.glob("s*/mark.json")]) >= count // 2)
    print(f"killed after {seconds:.0f} s with {len([*marked.glob('s*/mark.json')])} marked")
    print(f"graded again: {run(folder, grade):.0f} s")
    names = ["grades.csv", *(f"{student}/feedback.txt" for student in students)]
    same = [(folder / "whole" / n).read_bytes() == (marked / n).read_bytes() for n in names]
    print(f"files that are the same: {sum(same)} of {len(names)}")
    lines = (marked / "grades.csv").read_text(encoding="utf-8").splitlines()[1:]
    totals = np.array([float(re.split(",", line)[2]) for line in lines])
    for kind, digits in {"right": (0, 2, 3, 5, 6, 8), "slip": (1, 4, 7), "spoiled": (9,)}.items():
        chosen = totals[[n for n in range(count) if n % 10 in digits]]
        print(f"{kind}: {len(chosen)} students, totals {chosen.min():g} to {chosen.max():g}")


if __name__ == "__main__":
    main(int(sys.argv[1]), Path(sys.argv[2]))
