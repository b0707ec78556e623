"""Write the text around an answer in a pasted text."""

from random import Random

import numpy as np

from tests.measure.random_answers.questions import Question

_SUBJECT = {
    "table": "DH table", "jacobian": "Jacobian", "torques": "Static torques",
    "trace": "Joint angles along the circle", "branches": "Inverse kinematics",
    "pose": "Inverse kinematics",
}  # fmt: skip


def _row(values) -> str:
    return "[" + ", ".join(f"{x:g}" for x in np.ravel(values)) + "]"


def _heading(question: Question, rng: Random) -> str:
    subject, arm = _SUBJECT[question.topic], question.arm.name
    return rng.choice(
        (
            f"## Problem {rng.randint(1, 6)} ({rng.choice('abc')}): {subject}",
            f"Homework {rng.randint(3, 6)} - {subject} of the {arm}",
            f"{rng.randint(2, 5)}.{rng.randint(1, 4)} {subject}",
            f"Q{rng.randint(1, 5)}. {subject}",
            f"HW{rng.randint(3, 5)}\nName: J. Miller   UID: 11{rng.randint(1000000, 9999999)}\n",
            f"\\section*{{Problem {rng.randint(1, 5)}}}",
            f"**{subject}**",
            f"Exercise {rng.randint(1, 9)}",
        )
    )


def _question_again(question: Question, rng: Random) -> str:
    arm = question.arm.name
    if question.topic == "table":
        return f"Question: Write the Denavit-Hartenberg table of the {arm} (6 points)."
    if question.topic == "trace":
        return (
            "Task: trace the circle of radius 0.1 m in 5 s and give the joint angles at each step."
        )
    if question.topic == "torques":
        q = question.q if question.q.ndim == 1 else question.q[0]
        return (
            f"Compute the joint torques of the {arm} at q = {_row(q)} for F ="
            f" {_row(question.wrench)} and g = 9.81 m/s^2."
        )
    if question.topic == "jacobian":
        return f"Compute the 6x{question.arm.dof} Jacobian of the {arm} at q = {_row(question.q)}."
    point = question.target if question.target.ndim == 1 else question.target[:3, 3]
    return f"Find joint values that take the tip to p = ({', '.join(f'{x:.3f}' for x in point)}) m."


def _prompt(question: Question, rng: Random, layout: str, name: str) -> str:
    if "MATLAB" in layout:
        return rng.choice((f">> {name}", f">> {name} = solve_hw(q)", ">> hw5"))
    if layout == "Julia":
        return f"julia> {name}"
    if layout == "R print":
        return f"> {name}"
    number = rng.randint(2, 60)
    return rng.choice(
        (f">>> {name}", f">>> print({name})", f"In [{number}]: {name}\nOut[{number}]:",
         f"$ python hw{rng.randint(2, 5)}.py", f"[{number}]: print({name})")
    )  # fmt: skip


def _code_before(question: Question, rng: Random) -> str:
    values = list(question.arm.values.items())[:2]
    lengths = "; ".join(f"{name.replace('_', '')} = {x:g}" for name, x in values)
    return rng.choice(
        (
            "import numpy as np\nfrom sympy import *\nq = np.zeros(6)  # start\n",
            f"clc; clear all; close all;\n% lengths in m\n{lengths};\n",
            "def dh(a, alpha, d, theta):\n    ct, st = np.cos(theta), np.sin(theta)\n"
            "    return np.array([[ct, -st, 0, a], [st, ct, 0, 0], [0, 0, 1, d], [0, 0, 0, 1]])\n",
            "for i in range(0, 1000):\n    q = q + q_dot * dt\n",
            "# step 1: transforms, step 2: Jacobian, step 3: torques\n",
        )
    )


def _constants(question: Question, rng: Random) -> str:
    arm = question.arm
    lengths = ", ".join(f"{n.replace('_', '')} = {x:g} m" for n, x in arm.values.items())
    if not arm.bodies or rng.random() < 0.5:
        return f"Given: {lengths}"
    masses = [arm.number(body.mass) for body in arm.bodies]
    return rng.choice((f"m = {_row(masses)} kg", f"Masses (kg): {_row(masses)}, g = 9.81 m/s^2"))


def _chat_opening(question: Question, rng: Random) -> str:
    subject = _SUBJECT[question.topic].lower()
    return rng.choice(
        (
            f"Sure! Here is the {subject} for the **{question.arm.name}**:\n",
            f"Great question! Let's work through this step by step.\n\n### Step 3: {subject}\n\n"
            "Substituting the values from Step 2, we get:\n",
            f"I've computed the {subject} numerically (2 checks passed). Final answer:\n",
            "After fixing the 2 issues you mentioned, the updated result is:\n",
        )
    )


def _chat_closing(question: Question, rng: Random) -> str:
    return rng.choice(
        (
            "\nLet me know if you'd like me to verify this numerically!",
            "\n**Key points:**\n- Joint 1 is vertical, so gravity does no work on it.\n"
            "- All 3 wrist axes intersect.\n\nWould you like the Python code?",
            "\n✅ The result satisfies the constraints to within 1e-6.",
            "\n### Summary\nThe values agree with the forward kinematics (error < 0.001).",
        )
    )


def _summary(values: np.ndarray, rng: Random) -> str:
    return rng.choice(
        (
            f"norm = {np.linalg.norm(values):.4f}",
            f"max |x| = {abs(values).max():.3f}",
            f"sum: {values.sum():.3f}, mean: {values.mean():.4f}",
            f"rank = {np.linalg.matrix_rank(values)}",
        )
    )


def _time(rng: Random) -> str:
    seconds = rng.uniform(0.01, 4)
    return rng.choice(
        (f"Elapsed time is {seconds:.6f} seconds.", f"CPU time: {seconds:.2f} s",
         f"[Finished in {seconds:.1f}s]", f"real\t0m{seconds:.3f}s")
    )  # fmt: skip


def _page(rng: Random) -> str:
    n = rng.randint(2, 9)
    return rng.choice((f"Page {n} of {n + 3}", f"- {n} -", f"p. {n}"))


def _check(rng: Random) -> str:
    size = 10.0 ** -rng.randint(6, 15)
    return rng.choice(
        (f"error: {size:.2e}", f"Residual = {size:.3e} (ok)", "Position error: 0.0000 m",
         "checked against Peter Corke's toolbox v10.4")
    )  # fmt: skip


def add_surroundings(
    block: str, question: Question, typed: np.ndarray, rng: Random, marks: dict
) -> str:
    """Put text around an answer.

    Args:
        block: the answer as laid out.
        question: what is asked.
        typed: numbers in the unit typed.
        rng: source of chance.
        marks: features of the draw, read for "layout" and "family"; each surrounding is added.
    """
    tool = marks["family"] in ("code", "print")

    def takes(feature: str, weight: float) -> bool:
        if rng.random() >= weight:
            return False
        marks["around: " + feature] = "yes"
        return True

    chat = takes("AI chat", 0.08 if tool else 0.15)
    before = _lines_before(question, chat, rng, marks, takes)
    if question.topic != "table" and len(typed) == 1 and takes("older list", 0.13):
        before.append(_older_list(typed, rng))
    if marks.get("sentence"):
        before.append(marks["sentence"])
    if tool and takes("prompt", 0.22):
        before.append(_prompt(question, rng, marks["layout"], marks["name"]))
    elif tool and takes("comment line", 0.08):
        before.append(rng.choice(("# final result", "% result", "# at the given pose, run 3")))
    if tool and (chat or rng.random() < 0.06):
        marks["around: code fence"] = "yes"
        block = f"```{rng.choice(('python', '', 'text'))}\n{block}\n```"
    after = _lines_after(question, chat, typed, rng, takes)
    after = [marks["footnote"], *after] if marks.get("footnote") else after
    gap = rng.choice(("\n", "\n", "\n\n"))
    return _whole_text(gap.join([*before, block, *after]), rng, takes)


def _lines_before(question: Question, chat: bool, rng: Random, marks: dict, takes) -> list[str]:
    lines = []
    if takes("heading", 0.28):
        lines.append(_heading(question, rng))
    if takes("question again", 0.15):
        lines.append(_question_again(question, rng))
    if takes("lengths or masses", 0.10):
        lines.append(_constants(question, rng))
    if takes("code before", 0.15 if marks["family"] in ("code", "print") else 0.02):
        lines.append(_code_before(question, rng))
    if chat:
        lines.append(_chat_opening(question, rng))
    return lines


def _lines_after(
    question: Question, chat: bool, typed: np.ndarray, rng: Random, takes
) -> list[str]:
    lines = []
    if question.topic != "table" and takes("norm or rank", 0.10):
        lines.append(_summary(typed, rng))
    if takes("time", 0.06):
        lines.append(_time(rng))
    if takes("check", 0.08):
        lines.append(_check(rng))
    if chat:
        lines.append(_chat_closing(question, rng))
    if takes("page number", 0.06):
        lines.append(_page(rng))
    return lines


def _older_list(typed: np.ndarray, rng: Random) -> str:
    values = typed[0] * rng.choice((-1, 0.9, 1.1))
    old = "[" + ", ".join(f"{x:.3f}" for x in values) + "]"
    return rng.choice(
        (
            f"First attempt (wrong): {old}\nCorrected:",
            f"# old, before I fixed the sign: {old}\n# new:",
            f"~~{old}~~\nUpdated answer:",
            f"My first run gave {old}, which was not right. With the right lengths:",
        )
    )


def _whole_text(text: str, rng: Random, takes) -> str:
    """Change all lines as mail programs, editors and indentation do."""
    if takes("mail quote", 0.04):
        return "\n".join("> " + line for line in text.split("\n"))
    if takes("line numbers", 0.035):
        style = rng.choice(("{:>3}  {}", "{:>2} | {}", "{}: {}", "{}\t{}"))
        return "\n".join(style.format(i, line) for i, line in enumerate(text.split("\n"), 1))
    if takes("indented", 0.05):
        return "\n".join("    " + line for line in text.split("\n"))
    if takes("hard spaces", 0.04):
        return text.replace(" ", "\u00a0")
    return text
