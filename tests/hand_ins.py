"""Hand-ins as students type them, right ones and ones with a planted mistake or two, and what the
checkers make of them.

The numbers and the mistakes come from `tests/corpus`, whose few lines of kinematics share nothing
with `judge/`; the truth of a cause from planting or undoing it.
"""

from collections.abc import Callable, Iterator
from dataclasses import dataclass
from functools import partial

import numpy as np

from helpers import checks, inverse
from helpers.inputs import ArmError
from helpers.motion import circle
from tests.corpus import jacobians, tables, torques, traces
from tests.corpus.arms import KNOWN, pose, some_machine
from tests.corpus.machine import Machine
from tests.dressing import around, column, jacobian_text, joints_text, table_text
from tests.mixed import arm_of, heavy

PAIRS, NOISE = 0.2, 0.06  # of the mistaken: two mistakes at once, and entries off by chance
Mistakes = dict[str, np.ndarray]
UNITS = ("table.millimetres", "table.degrees")  # mistakes where metres and radians were said


@dataclass(frozen=True)
class HandIn:
    """What is typed, what is asked of it, and the causes that would be true (None: it is right);
    a pair of mistakes is one name with a plus sign."""

    topic: str
    text: str
    ask: Callable[[str], checks.Report]
    causes: frozenset[str] | None
    dressed: str

    @property
    def kind(self) -> str:
        if not self.causes:
            return "right" if self.causes is None else "noise"
        return "pair" if all(" + " in cause for cause in self.causes) else "single"


def true_causes(planted: str, mistakes: Mistakes, digits: int) -> frozenset[str]:
    """The planted mistake and all that give the same numbers to a few units of the last place."""
    made = mistakes[planted]
    return frozenset(
        key for key, x in mistakes.items()
        if np.shape(x) == np.shape(made) and np.max(np.abs(x - made)) <= 3 * 10.0**-digits
    )  # fmt: skip


def one_of(rng, mistakes: Mistakes, right, digits: int) -> str | None:
    """A mistake that shows in the digits typed."""
    seen = [k for k, x in mistakes.items() if _apart(x, right) > 12 * 10.0**-digits]
    return str(rng.choice(seen)) if seen else None


def _apart(A, B) -> float:
    return float(np.max(np.abs(A - B))) if np.shape(A) == np.shape(B) else np.inf


# One hand-in of each topic; `wrong` asks for a mistake; None where it came to nothing


def of_jacobian(rng, wrong: bool) -> HandIn | None:
    m, digits = some_machine(rng), int(rng.integers(3, 6))
    q = pose(m, rng)
    made, causes, how = m.jacobian(q), None, {}
    if wrong:
        found = _mistaken_jacobian(rng, m, q, digits)
        if found is None:
            return None
        made, causes = found
    elif rng.random() < 0.2:
        k = int(rng.integers(1, len(m.rows) + 1))
        made, how = jacobians.in_frame(m, q, made, k), {"frame": k}
    if not causes and rng.random() < 0.1:
        made, how = np.vstack([made[3:], made[:3]]), {**how, "angular_first": True}
    text, dressed = jacobian_text(rng, made, digits)
    ask = partial(_asked, checks.compare_jacobian, arm=arm_of(m), q=q, **how)
    return HandIn("jacobian", text, ask, causes, dressed)


def _asked(compare: Callable, text: str, **options) -> checks.Report:
    return compare(text, **options)


def jacobian_mistakes(m: Machine, q, rng) -> tuple[Mistakes, dict[str, Callable]]:
    """Those made before the matrix stands, and those of writing it down, which change one."""
    firsts = dict([*jacobians.before(m, q, rng), *jacobians.tables(m, q, rng)])
    return firsts, dict(jacobians.after(m, q, rng))


def _mistaken_jacobian(rng, m: Machine, q, digits: int):
    right = m.jacobian(q)
    firsts, seconds = jacobian_mistakes(m, q, rng)
    singles = firsts | {key: write(right) for key, write in seconds.items()}
    singles |= {f"J.column sign:{i + 1}": right * s for i, s in jacobians.signs(m)}
    draw = rng.random()
    if draw < NOISE:
        off = rng.uniform(0.05, 0.4, right.shape) * (rng.random(right.shape) < 0.25)
        return (right + off, frozenset()) if np.any(off) else None
    if draw < NOISE + PAIRS:
        one, two = str(rng.choice(list(firsts))), str(rng.choice(list(seconds)))
        both = seconds[two](firsts[one])
        plain = both.shape == right.shape and two != "J.transposed"
        told = plain and all(_apart(both, x) > 8e-3 for x in [right, *singles.values()])
        return (both, _true_pairs(both, firsts, seconds, singles)) if told else None
    key = one_of(rng, singles, right, digits)
    return key and (singles[key], true_causes(key, singles, digits))


def _true_pairs(both, firsts: Mistakes, seconds, singles: Mistakes) -> frozenset[str]:
    """All pairs that give the same matrix, one after the other or one for each half of it."""

    def alike(A, rows=slice(None)):
        return A.shape == both.shape and _apart(A[rows], both[rows]) < 1e-9

    pairs = {f"{p} + {s}" for p, A in firsts.items() for s, f in seconds.items() if alike(f(A))}
    v, w = ([k for k, A in singles.items() if alike(A, rows)] for rows in (slice(3), slice(3, 6)))
    return frozenset(pairs | {f"{one} + {two}" for one in v for two in w})


def of_torques(rng, wrong: bool) -> HandIn | None:
    m, digits = some_machine(rng), int(rng.integers(3, 6))
    if m.name == "PANDA.lock(3)":
        return None
    q, links = pose(m, rng), torques.bodies(m, rng)
    F = np.round(rng.uniform(-8, 8, 6) * [1, 1, 1, *[rng.random() < 0.4] * 3], 1)
    F = F if rng.random() < 0.8 else 0 * F
    right = torques.weight(m, links, q) - torques.force(m, F, q)
    made, causes = right, None
    if wrong:
        singles = dict(torques.mistakes(m, links, q, F, rng))
        used = [(mass * (k < m.dof - 1), *c) for k, (mass, *c) in enumerate(links)]
        singles["tau.last link"] = torques.weight(m, used, q) - torques.force(m, F, q)
        pairs = dict(torques.pairs(m, links, q, F, rng)) if rng.random() < PAIRS else {}
        told = {
            k: x for k, x in pairs.items() if all(_apart(x, y) > 8e-3 for y in singles.values())
        }
        mistakes = told or singles
        key = one_of(rng, mistakes, right, digits)
        if key is None:
            return None
        made, causes = mistakes[key], true_causes(key, mistakes, digits)
    text, dressed = column(rng, made, digits, "tau", "N m")
    arm = arm_of(m) if m.name == "PANDA" else heavy(m, links)
    ask = partial(_asked, checks.compare_torques, arm=arm, q=q, wrench=F)
    return HandIn("torques", text, ask, causes, dressed)


def of_table(rng, wrong: bool) -> HandIn | None:
    m = some_machine(rng)
    rows = m.rows if rng.random() < 0.5 else tables.rechosen(m.rows, rng)
    causes, units = None, {}
    if wrong:
        mistakes = tables.mistakes(m, rng)
        key = str(rng.choice(list(mistakes)))
        rows = mistakes[key]
        if tables.same_motion(m, rows):
            return None
        causes = frozenset(k for k, x in mistakes.items() if tables.alike(x, rows))
        if key in UNITS:
            units = {"lengths": "m", "angles": "rad"}
    text, dressed = table_text(rng, rows, unitless=bool(units))
    ask = partial(_asked, checks.compare_tables, reference=arm_of(m), **units)
    return HandIn("table", text, ask, causes, dressed)


SOLVERS = {"ELBOW": inverse.elbow, "UR10E": inverse.ur, "UR10E_HOMEWORK": inverse.ur,
           "STANFORD": inverse.stanford}  # fmt: skip


def of_branches(rng, wrong: bool) -> HandIn | None:
    """Some or all of the answers of a closed form, each tried here."""
    name = str(rng.choice(list(SOLVERS)))
    m = KNOWN[name]
    T = m.tip(pose(m, rng))
    found = SOLVERS[name](arm_of(m), T[:3, 3] if m.dof < 6 else T)
    answers = found.q[found.valid]
    if any(np.abs(_missed(m, q, T)).max() > 1e-6 for q in answers):
        raise AssertionError("the closed form is no source")
    digits, causes = int(rng.integers(3, 6)), None
    answers = answers[rng.permutation(len(answers))][: rng.integers(1, len(answers) + 1)]
    if wrong:
        at = int(rng.integers(len(answers)))
        spoiled = _mistaken_joints(rng, m, answers[at], T, digits)
        if spoiled is None:
            return None
        made, causes = spoiled
        answers = np.array([made if i == at else q for i, q in enumerate(answers)])
    text, options, dressed = joints_text(rng, answers, list(m.turns), digits)
    ask = partial(_asked, checks.compare_branches, found=found, **options)
    return HandIn("branches", text, ask, causes, dressed)


def of_pose(rng, wrong: bool) -> HandIn | None:
    m, digits = some_machine(rng), int(rng.integers(3, 6))
    q = np.array(pose(m, rng))
    T, made, causes = m.tip(q), q, None
    if wrong:
        spoiled = _mistaken_joints(rng, m, q, T, digits)
        if spoiled is None:
            return None
        made, causes = spoiled
    text, options, dressed = joints_text(rng, made[None], list(m.turns), digits)
    ask = partial(_asked, checks.compare_pose, arm=arm_of(m), T=T, **options)
    return HandIn("pose", text, ask, causes, dressed)


def _missed(m: Machine, q, T) -> np.ndarray:
    off = m.tip(q) - T
    return off[:3, 3] if m.dof < 6 else off


def _mistaken_joints(rng, m: Machine, q, T, digits: int):
    """Joint angles spoiled by one slip, and the slips that, undone, take the tip to its target."""
    slips = {key: spoil for key, spoil, _ in _slips(m)}
    key = str(rng.choice(list(slips)))
    made = slips[key](q)
    if np.abs(_missed(m, made, T)).max() < 0.02:
        return None
    near = 20 * 10.0**-digits
    undone = {k: np.abs(_missed(m, undo(made), T)).max() for k, _, undo in _slips(m)}
    return made, frozenset(k for k, off in undone.items() if off < near)


def _slips(m: Machine) -> Iterator[tuple[str, Callable, Callable]]:
    """What spoils joint values, and what undoes it."""
    turns = m.turns

    def only(at, change):
        return lambda q: np.where(at, change(q), q)

    yield "ik.degrees", only(turns, np.degrees), only(turns, np.radians)
    yield "ik.all signs", np.negative, np.negative
    yield "ik.reversed order", lambda q: q[::-1], lambda q: q[::-1]
    if not turns.all():
        yield (
            "ik.slide in millimetres",
            only(~turns, lambda q: 1000 * q),
            only(~turns, lambda q: q / 1000),
        )
    for k in np.flatnonzero(turns):
        one, joint = np.arange(m.dof) == k, f"q_{m.joints[k] + 1}"
        mirror, half = only(one, np.negative), only(one, lambda q: q + np.pi)
        back, over = only(one, lambda q: q - np.pi / 2), only(one, lambda q: q + np.pi / 2)
        supplement, other = only(one, lambda q: np.pi - q), only(one, lambda q: np.pi / 2 - q)
        yield f"ik.sign:{joint}", mirror, mirror
        yield f"ik.half turn:{joint}", half, half
        yield f"ik.offset:{joint}", back, over
        yield f"ik.supplement:{joint}", supplement, supplement
        yield f"ik.other axis:{joint}", other, other


def of_run(rng, wrong: bool) -> HandIn | None:
    found = traces.some_run(rng, wrong)
    if found is None:
        return None
    task, q, cause = found
    m, digits = task.machine, int(rng.integers(3, 6))
    declared = rng.random() < 0.2 and cause != "trace.degrees"
    shown = [m.as_typed(row, digits, declared) for row in q]
    sep = str(rng.choice([",", "\t", "  ", ", "]))
    head = sep.join(f"q{i + 1}" for i in m.joints) + "\n" if rng.random() < 0.3 else ""
    text = head + "\n".join(sep.join(row) for row in shown)
    path = circle(**task.path())
    angles = "deg" if declared else "rad"
    ask = partial(_asked, checks.compare_trace, arm=arm_of(m), path=path, angles=angles)
    causes = None if cause is None else frozenset([cause])
    return HandIn("run", around(rng, text)[0], ask, causes, f"run {digits}")


TOPICS = [of_table] * 6 + [of_jacobian] * 6 + [of_torques] * 4 + [of_branches] * 3 + [of_pose] * 3
TOPICS += [of_run]


def hand_ins(seed: int, count: int) -> Iterator[HandIn]:
    """`count` of them, the same for the same seed."""
    made = n = 0
    while made < count:
        rng = np.random.default_rng([0, seed, n])
        n += 1
        topic = TOPICS[rng.integers(len(TOPICS))]
        if (found := topic(rng, bool(rng.random() < 0.5))) is not None:
            made += 1
            yield found


# What the checkers make of one


def verdict(h: HandIn) -> tuple[str, checks.Report | ArmError]:
    """One word for what happened, and the report or the refusal."""
    try:
        report = h.ask(h.text)
    except ArmError as problem:
        return "refused", problem
    same = report.figures.get("same machine", False)  # other zeros are told, and are no slip here
    if h.causes is None and not same:
        grades = {"wrong": "called wrong", "rounded": "last digit", "so far": "so far"}
        return grades.get(report.grade, "right"), report
    if h.causes is None:
        return "right", report
    if report.grade in ("right", "rounded") and not report.mark:
        return "passed", report
    if report.mark or any(names(cause, true) for cause in report.causes for true in h.causes):
        return "named", report
    told = [f for f in report.findings if f.what == "cause" and "erhaps" not in f.words]
    planted = {part for cause in h.causes for part in cause.split(" + ")}
    half = any({*cause.split(" + ")} <= planted for cause in report.causes)
    if told and report.causes and not half:
        return "false cause", report
    return ("not named" if h.causes else "no cause"), report


# The judge's keys of what is planted here under another, and what it says of it that is true too.
ALSO = {
    "table.twist": ("table.no twist", "table.angle:alpha"),
    "table.no twist": ("table.angle:alpha",),
    "table.sign:alpha": ("table.twist", "table.number and sign"),
    "table.a and d": ("table.a and d in row", "table.too much:a", "table.too much:d"),
}


def names(cause: str, true: str) -> bool:
    """Whether a report's cause is the true one; one of a pair may be told with more."""
    if " + " in true:
        return set(cause.split(" + ")) == set(true.split(" + "))
    if cause.split(" + ")[0] == true:
        return True
    others = next((keys for start, keys in ALSO.items() if true.startswith(start)), ())
    return cause.startswith(others)
