"""The page's judge against the checkers: the same questions to both, their words compared letter by
letter.

As a command, which ``make judge`` is: ``python -m tests.judge_words --cases 20000``. It needs
Node.js, and as many cores as it may have.
"""

import argparse
import difflib
import hashlib
import os
import sys
import time
from collections.abc import Iterable, Iterator
from concurrent.futures import ProcessPoolExecutor, as_completed
from functools import cache
from multiprocessing import get_context
from pathlib import Path

import numpy as np
import sympy as sp

from helpers import checks, symbolic
from helpers.arm import Arm, Body, fixed, prismatic, revolute
from helpers.checks.torques_causes import Load, catalogue, paper_centres, reversed_joints
from helpers.explorer.judge import judged_data
from helpers.inputs import ArmError
from helpers.reading.sentences import templates
from helpers.robots import ELBOW, PANDA, PANDA_HOMEWORK, STANFORD, UR10E, UR10E_HOMEWORK
from helpers.statics import GRAVITY
from tests import judge_matrices, judge_motion, judge_tables, readings
from tests.corpus import jacobians, torques
from tests.corpus.typing_ import typed
from tests.node import ask_node

ROOT = Path(__file__).parents[1]
KNOWN = {
    "PANDA": PANDA,
    "UR10E": UR10E,
    "UR10E_HOMEWORK": UR10E_HOMEWORK,
    "STANFORD": STANFORD,
    "ELBOW": ELBOW,
    "PANDA.lock(3)": PANDA.lock(3),
}
HEAVY = tuple(arm for arm in (PANDA, PANDA_HOMEWORK, UR10E, UR10E_HOMEWORK) if arm.bodies)
_ROWS = {"R": revolute, "P": prismatic, "F": fixed}


def arm_of(machine) -> Arm:
    """The arm of a corpus's machine: that of the catalogue where it is one."""
    if machine.name in KNOWN:
        return KNOWN[machine.name]
    rows = [
        _ROWS[kind](a=a, alpha=alpha, d=d, theta=theta) for kind, a, alpha, d, theta in machine.rows
    ]
    return Arm("your arm", rows)


def jacobian_questions(rng, count: int) -> Iterator[tuple[Arm, dict]]:
    """The corpus's Jacobians; some in other axes, in (omega, v), or half of them only."""
    for case in jacobians.cases(rng, count):
        arm, options = arm_of(case["machine"]), {}
        if rng.random() < 0.1:
            options["frame"] = int(rng.integers(1, len(arm.rows) + 1))
        if rng.random() < 0.1:
            options["angular_first"] = True
        typed = case["typed"]
        if case["form"] == "array" and rng.random() < 0.2:
            typed = typed[:3] if rng.random() < 0.5 else typed[3:]
        yield arm, {"topic": "jacobian", "typed": typed, "q": case["q"], "options": options}


def torque_questions(rng, count: int) -> Iterator[tuple[Arm, dict]]:
    """Right and mistaken torques at one pose or along a few, under a push or none, in any form."""
    for _ in range(count):
        arm = HEAVY[int(rng.integers(len(HEAVY)))]
        poses = 1 if rng.random() < 0.8 else int(rng.integers(2, 40))
        q = np.round(rng.uniform(-1.4, 1.4, (poses, arm.dof)), 3)
        options = {}
        wrench = np.zeros(6)
        if rng.random() < 0.6:
            wrench = np.round(rng.uniform(-20, 20, 6) * (rng.random(6) < 0.6), 1)
            options["wrench"] = [float(x) for x in wrench]
        if rng.random() < 0.2:
            options["gravity"] = [0.0, 0.0, 9.81] if rng.random() < 0.5 else [0.0, -9.81, 0.0]
        gravity = np.array(options.get("gravity", GRAVITY))
        load = Load(arm, q, np.broadcast_to(wrench, (poses, 6)), gravity)
        tau = _mistaken(rng, load)
        typed_tau, _ = typed(tau, int(rng.choice([1, 2, 3, 4, 6])), rng)
        at = q.tolist() if poses > 1 else q[0].tolist()
        yield arm, {"topic": "torques", "typed": typed_tau, "q": at, "options": options}


def _mistaken(rng, load: Load) -> np.ndarray:
    right = load.torques()
    what = rng.random()
    if what < 0.2:
        return right
    if what < 0.65:
        made = np.concatenate([catalogue(load, count)[1] for count in (1, 2)])
        besides = np.arange(right.shape[1]) == rng.integers(3 * right.shape[1])
        return made[int(rng.integers(len(made)))] + besides * rng.uniform(0.05, 5)
    if what < 0.75:
        made = (reversed_joints(load, right) if rng.random() < 0.5 else paper_centres(load))[1]
        return made[int(rng.integers(len(made)))]
    if what < 0.85:
        return right * np.where(rng.random(right.shape[1]) < 0.3, -1, 1)
    if what < 0.9:
        return right.T if rng.random() < 0.5 else right[:, : int(rng.integers(1, right.shape[1]))]
    return right + np.where(rng.random(right.shape) < 0.3, rng.uniform(0.05, 5, right.shape), 0)


@cache
def _formulas() -> list[tuple[Arm, str]]:
    found = []
    for arm in (ELBOW, STANFORD, PANDA.lock(3)):
        J = symbolic.jacobian(arm)
        found += [(arm, str(J)), (arm, sp.latex(J))]
    return found


def formula_questions(rng, count: int) -> Iterator[tuple[Arm, dict]]:
    """Jacobians in symbols, some with letters of their own, with a slip in some: another function,
    another sign, another joint.
    """
    slips = [("sin", "cos"), ("cos", "sin"), ("+", "-"), (" - ", " + "), ("q_1", "q_2"),
             ("q_{2}", "q_{1}"), ("q_", "theta_"), ("q_4", "q_9"), ("d_", "e_")]  # fmt: skip
    for _ in range(count):
        arm, text = _formulas()[int(rng.integers(len(_formulas())))]
        options = {}
        if rng.random() < 0.25:
            own = str(rng.choice(["h_", "w_", "D_", "beta_"]))
            text = text.replace("d_", own)
            named = [(own + name[2:], x) for name, x in arm.values.items() if name[:2] == "d_"]
            options["values"] = {name: x + 0.01 * (rng.random() < 0.2) for name, x in named}
        for old, new in slips:
            if rng.random() < 0.07:
                at = text.find(old, int(rng.integers(len(text))))
                text = text if at < 0 else text[:at] + new + text[at + len(old) :]
        q = [float(x) for x in np.round(rng.uniform(0.2, 1.4, arm.dof), 3)]
        yield arm, {"topic": "jacobian", "typed": text, "q": q, "options": options}


def stored_questions(rng, count: int) -> Iterator[tuple[Arm, dict]]:
    """Torques of the corpus, with its own arms and masses, along paths too."""
    for case in torques.cases(rng, count):
        machine, bodies = case["machine"], case["bodies"]
        rows = [_ROWS[r[0]](a=r[1], alpha=r[2], d=r[3], theta=r[4]) for r in machine.rows]
        arm = Arm("your arm", rows, bodies=[Body(m, tuple(c)) for m, *c in bodies])
        options = {"wrench": case["wrench"]}
        yield arm, {"topic": "torques", "typed": case["typed"], "q": case["q"], "options": options}


QUESTIONS = {
    "jacobian": jacobian_questions,
    "torques": torque_questions,
    "corpus's torques": stored_questions,
    "formula": formula_questions,
    "Jacobian's slips": lambda rng, count: judge_matrices.jacobian_slips(rng, count, arm_of),
    "torques' slips": lambda rng, count: judge_matrices.torque_slips(rng, count, arm_of, HEAVY),
    "table": lambda rng, count: judge_tables.corpus_questions(rng, count, arm_of),
    "table's forms": lambda rng, count: judge_tables.form_questions(rng, count, arm_of),
    "table's slips": lambda rng, count: judge_tables.slip_questions(rng, count, arm_of),
    "branches": judge_motion.branch_questions,
    "corpus's branches": judge_motion.stored_branches,
    "pose": judge_motion.pose_questions,
    "corpus's poses": lambda rng, count: judge_motion.stored_poses(rng, count, arm_of),
    "trace": judge_motion.trace_questions,
    "corpus's traces": lambda rng, count: judge_motion.stored_traces(rng, count, arm_of),
    "table's geometry": lambda rng, count: judge_tables.geometry_questions(rng, count, arm_of),
    "readings": readings.questions,
}
# The kinds of each checker, the dearest first: a run takes the time of twenty tables.
CHECKERS = {
    "trace": ("corpus's traces", "trace"),
    "torques": ("corpus's torques", "torques", "torques' slips"),
    "Jacobian": ("formula", "jacobian", "Jacobian's slips"),
    "table": ("table's forms", "table's slips", "table", "table's geometry"),
    "pose": ("corpus's poses", "pose"),
    "branches": ("corpus's branches", "branches"),
    "reading": ("readings",),
}
SHARES = {
    "jacobian": 0.06,
    "Jacobian's slips": 0.14,
    "torques": 0.03,
    "corpus's torques": 0.03,
    "torques' slips": 0.06,
    "formula": 0.03,
    "table": 0.1,
    "table's geometry": 0.06,
    "table's forms": 0.1,
    "table's slips": 0.1,
    "branches": 0.08,
    "corpus's branches": 0.05,
    "pose": 0.08,
    "corpus's poses": 0.04,
    "trace": 0.035,
    "corpus's traces": 0.005,
    "readings": 0.3,
}
_AT_ONCE = 600  # questions of a part: Node.js is fast only after a while
_DEAR = {"trace": 100, "corpus's traces": 50}
_TWICE = 1.03  # some questions come twice, and do not count
_TOLD = 10  # of those with different words


def questions(rng, count: int, only: str | None = None) -> list[tuple[Arm, dict]]:
    """So many of every kind, or of one."""
    if only:
        return list(QUESTIONS[only](rng, count))
    return [
        pair for kind, make in QUESTIONS.items() for pair in make(rng, round(count * SHARES[kind]))
    ]


def python_words(arm: Arm, question: dict) -> list:
    """What the checkers say: grade, causes, words; the topic and whose, and each finding."""
    calls = {"jacobian": checks.compare_jacobian, "torques": checks.compare_torques}
    topic = question["topic"]
    if topic == "reading":
        return ["read", [], readings.words(question["typed"], question["options"])]
    try:
        if topic in judge_motion.SAYS:
            report = judge_motion.SAYS[topic](question["typed"], arm, question)
        elif topic == "table":
            report = checks.compare_tables(question["typed"], arm, **question["options"])
        else:
            report = calls[topic](question["typed"], arm, question["q"], **question["options"])
    except ArmError as error:
        return ["refused", [], str(error)]
    places = [[report.topic, report.arm], *([f.what, f.where, f.words] for f in report.findings)]
    return [report.grade, list(report.causes), str(report), places]


def page_words(questions: list[tuple[Arm, dict]], sentences: dict | None = None) -> list:
    """What the page's judge says, under Node.js, in these sentences."""
    arms = list({id(arm): arm for arm, _ in questions}.values())
    at = {id(arm): k for k, arm in enumerate(arms)}
    asked = [{**q, "arm": at[id(arm)], "options": _in_page(q["options"])} for arm, q in questions]
    return in_node([judged_data(arm) for arm in arms], asked, sentences)


def in_node(arms: list[dict], questions: list[dict], sentences: dict | None = None) -> list:
    """What tests/judge_words.mjs answers: of each what `python_words` says."""
    given = {"sentences": sentences or templates(), "arms": arms, "questions": questions}
    return ask_node("judge_words.mjs", given)


def _in_page(options: dict) -> dict:
    names = {"angular_first": "angularFirst"}
    found = {names.get(key, key): value for key, value in options.items()}
    return found | {"values": list(found["values"].items())} if "values" in found else found


def different(questions: list[tuple[Arm, dict]]) -> Iterator[tuple[dict, list, list]]:
    """The questions to which the two do not say the same, as they are found."""
    both = zip(questions, page_words(questions), strict=True)
    return unlike((arm, question, words) for (arm, question), words in both)


def unlike(answered: Iterable[tuple[Arm, dict, list]]) -> Iterator[tuple[dict, list, list]]:
    """Those of questions that the page has answered to which the checkers say something else."""
    found = ((q, python_words(arm, q), theirs) for arm, q, theirs in answered)
    return ((q, ours, theirs) for q, ours, theirs in found if ours != theirs)


# Many, on all cores


def parts_of(cases: int, only: str | None = None) -> list[tuple[str, int, int]]:
    """The work in parts that do not depend on how many cores there are: kind, number, questions."""
    kinds = [only] if only else [kind for of_one in CHECKERS.values() for kind in of_one]
    found = []
    for kind in kinds:
        count = round(cases * _TWICE * (1 if only else SHARES[kind]))
        size = _DEAR.get(kind, _AT_ONCE)
        found += [(kind, k // size, min(size, count - k)) for k in range(0, count, size)]
    return found


@cache
def answered(seed: int, part: tuple[str, int, int]) -> list[tuple[Arm, dict, list]]:
    """The questions of a part, and what the page says to each."""
    kind, number, size = part
    rng = np.random.default_rng([seed, list(QUESTIONS).index(kind), number])
    asked = questions(rng, size, kind)
    return [(*pair, words) for pair, words in zip(asked, page_words(asked), strict=True)]


def compared(seed: int, part: tuple[str, int, int]) -> tuple[set[str], list[tuple]]:
    """The questions of a part, by their hashes, and those to which the two do not say the same."""
    found = answered(seed, part)
    return {_digest(arm, question) for arm, question, _ in found}, [*unlike(found)]


def _digest(arm: Arm, question: dict) -> str:
    given = repr((arm.name, arm.rows, arm.bodies, sorted(question.items())))
    return hashlib.blake2b(given.encode(), digest_size=12).hexdigest()


def readable(kind: str, question: dict, ours: list, theirs: list) -> str:
    """A question on which the two differ, and the lines in which they do."""
    asked = {key: value for key, value in question.items() if key != "typed"}
    typed = question["typed"] if isinstance(question["typed"], str) else str(question["typed"])
    said = ["\n".join(map(str, answer)).splitlines() for answer in (ours, theirs)]
    lines = difflib.unified_diff(*said, "helpers.checks", "judge", lineterm="", n=0)
    return "\n".join([f"{kind}: {str(asked)[:600]}", typed[:800], *lines, ""])


def main() -> None:
    """Compare many, and say how many differ."""
    parser = argparse.ArgumentParser(description=main.__doc__)
    parser.add_argument("--seed", type=int, default=2026)
    parser.add_argument("--cases", type=int, default=1000, help="different questions at least")
    parser.add_argument("--only", choices=QUESTIONS)
    parser.add_argument("--processes", type=int, default=os.cpu_count())
    given = parser.parse_args()
    os.environ |= {"OPENBLAS_NUM_THREADS": "1", "OMP_NUM_THREADS": "1"}
    asked: dict[str, set] = {kind: set() for kind in QUESTIONS}
    odd = dict.fromkeys(QUESTIONS, 0)
    started, told = time.monotonic(), 0
    with ProcessPoolExecutor(given.processes, get_context("spawn")) as pool:
        parts = parts_of(given.cases, given.only)
        tasks = {pool.submit(compared, given.seed, part): part[0] for part in parts}
        for task in as_completed(tasks):
            kind, (hashes, found) = tasks[task], task.result()
            asked[kind] |= hashes
            odd[kind] += len(found)
            for one in found[: max(0, _TOLD - told)]:
                print(readable(kind, *one), flush=True)
            told += len(found)
    total = _table(asked, odd)
    print(f"seed {given.seed}, {time.monotonic() - started:.0f} s, {given.processes} processes")
    if total < given.cases:
        print(f"These are {total} different questions; expected {given.cases} at least.")
    sys.exit(bool(any(odd.values()) or total < given.cases))


def _table(asked: dict[str, set], odd: dict[str, int]) -> int:
    """Print how many questions each checker was asked; their sum."""
    row = "{:10} {:>9} {:>16}".format
    print(row("checker", "questions", "different words"))
    counted = {
        checker: (sum(len(asked[kind]) for kind in kinds), sum(odd[kind] for kind in kinds))
        for checker, kinds in CHECKERS.items()
    }
    for checker, numbers in counted.items():
        print(row(checker, *numbers))
    total = sum(count for count, _ in counted.values())
    print(row("all", total, sum(odd.values())), flush=True)
    return total


if __name__ == "__main__":
    main()
