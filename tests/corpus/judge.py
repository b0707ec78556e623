"""Put a case of the corpus to its checker, and say how it went."""

import json
from functools import cache
from pathlib import Path

import numpy as np

from helpers import checks, inverse, robots
from helpers.arm import Arm
from helpers.motion import circle
from helpers.rows import Body, Joint, Row
from tests.corpus.machine import Machine
from tests.machines import same_machine

HERE = Path(__file__).parent
_KINDS = {"R": "revolute", "P": "prismatic", "F": "fixed"}


def load(topic, folder=HERE):
    return json.loads((Path(folder) / f"{topic}.json").read_text(encoding="utf-8"))


@cache
def known(name):
    return robots.PANDA.lock(3) if name == "PANDA.lock(3)" else getattr(robots, name)


def arm(entry):
    """The arm of a case: one of the catalogue, or its rows."""
    if entry.get("known") and (not entry.get("bodies") or entry["known"] == "PANDA"):
        return known(entry["known"])
    rows = [
        Row(a, alpha, d, theta, Joint(_KINDS[kind])) for kind, a, alpha, d, theta in entry["rows"]
    ]
    bodies = [Body(m, tuple(c)) for m, *c in entry.get("bodies", ())]
    return Arm("random", rows, bodies=bodies)


def report(case, arms):
    """What the checker says of a case."""
    topic = case["topic"]
    if topic == "branches":
        return checks.compare_branches(
            case["typed"], _found(case), angles=case.get("angles", "rad")
        )
    if topic == "trace":
        its, path = arm(arms[case["arm"]]), circle(**case["path"])
        return checks.compare_trace(case["typed"], its, path, angles=case.get("angles", "rad"))
    its = arm(arms[case["arm"]])
    if topic == "jacobian":
        how = {key: case[key] for key in ("frame", "angular_first") if key in case}
        return checks.compare_jacobian(case["typed"], its, case["q"], **how)
    if topic == "table":
        return checks.compare_tables(case["typed"], its, lengths="m", angles="rad")
    if topic == "torques":
        return checks.compare_torques(case["typed"], its, case["q"], case["wrench"])
    return checks.compare_pose(case["typed"], its, case["T"], angles=case.get("angles", "rad"))


def _found(case):
    """The branches that the closed form of the case's arm gives."""
    its = known(case["arm"])
    if case["arm"] == "ELBOW":
        its = its.with_values(**case["values"])
    solver = {
        "ELBOW": inverse.elbow,
        "STANFORD": inverse.stanford,
        "UR10E": inverse.ur,
        "UR10E_HOMEWORK": inverse.ur,
    }[case["arm"]]
    return solver(its, case["target"])


def outcome(case, arms, found):
    """How a verdict on a case is to be counted.

    Right work: its grade, or "false alarm". Mistakes: "named", "other" (another is named),
    "nothing" (wrong, no cause), "accepted"; "same arm" where an independent test of the motion says
    that nothing changed. Noise without a cause: "nothing" is right, "other" is not.
    """
    if not case.get("cause") and case["kind"] != "noise":
        return "false alarm" if found.grade == "wrong" else found.grade
    if found.grade != "wrong":
        return "same arm" if case["topic"] == "table" and _same(case, arms, "mine") else "accepted"
    if not case.get("cause"):
        return "other" if len(found.causes) == 1 else "nothing"
    wanted = {_set(case["cause"])}
    if "alone" in case and _same(case, arms, "alone"):
        wanted.add(_set(case["cause"].split(" + ")[0]))
    named = {_set(name) for name in found.causes}
    return "named" if wanted & named else "other" if found.causes else "nothing"


def _same(case, arms, which):
    """Whether other rows are the same arm: by the map of the joints that the checker offers, tried
    with the corpus's own kinematics, or where it has none by the motion.
    """
    rows, right = case[which], arms[case["arm"]]["rows"]
    mine, theirs = Machine(rows), Machine(right)
    said = checks.compare_tables(arm(dict(rows=rows)), arm(dict(rows=right)))
    if found := said.figures.get("joint_map"):
        return _moves_alike(mine, theirs, found, -1 if said.figures["upside down"] else 1)
    return said.agrees and same_machine(arm(dict(rows=rows)), arm(dict(rows=right)))


def _moves_alike(mine, theirs, joints, up):
    """Whether the tips are always the same step apart along z_0, joints carried over by a map."""
    signs, shifts = np.array(joints).T
    off = []
    for q in np.random.default_rng(0).uniform(-1, 1, (4, mine.dof)):
        here, there = mine.tip(q)[:3, 3], theirs.tip(signs * q + shifts)[:3, 3]
        off.append(there - here * [1, up, up])
    return np.ptp(off, axis=0).max() < 2e-3 and np.abs(np.array(off)[:, :2]).max() < 2e-3


def _set(name):
    return frozenset(name.split(" + "))
