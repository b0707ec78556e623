"""The honest sample: works written without sight of the judge, and what it says of them.

    python -m tests.honest FILE.jsonl ... [--kind jacobian] [--show refused]

Each line of a file is a work: its kind, arm, question and text, whether it is right, and else its
slips by name. A table is "right by map" if its slips only choose other zeros or directions of the
joints. `honest_slips.json` holds for each slip the causes that name it ("so far" where asking for
more is the right answer).
"""

import argparse
import json
from collections import Counter
from collections.abc import Mapping
from pathlib import Path

import numpy as np

from helpers import checks, inverse, motion, robots
from helpers.inputs import ArmError

NAMES = json.loads(Path(__file__).with_name("honest_slips.json").read_text("utf-8"))
RIGHT = ("right", "so far", "refused", "called wrong")
WRONG = ("named", "located", "so far", "passed", "false cause", "refused")
_CLOSED = {"UR10E": inverse.ur, "STANF": inverse.stanford, "ELBOW": inverse.elbow}
# Causes that locate an error without naming a mistake.
_SYMPTOMS = {
    *("trace.leans", "trace.spins", "trace.jump", "pose.entry", "pose.coordinate"),
    *("table.number", "table.missing"),
}
_solved: dict[str, object] = {}


def arm_of(name: str):
    base, _, locked = name.partition(".lock(")
    arm = getattr(robots, base)
    return arm.lock(int(locked[:-1])) if locked else arm


def report_on(work: Mapping) -> checks.Verdict:
    """The judge's report; raises ArmError where it refuses."""
    arm, text, says = arm_of(work["arm"]), work["text"], work["says"]
    match work["kind"]:
        case "jacobian":
            return checks.compare_jacobian(text, arm, work["q"], **says)
        case "torques":
            return checks.compare_torques(text, arm, work["q"], work["wrench"], **says)
        case "table":
            return checks.compare_tables(text, arm, **says)
        case "pose":
            return checks.compare_pose(text, arm, work["target"], **says)
        case "branches":
            key = json.dumps([work["arm"], work["target"]])
            if key not in _solved:
                _solved[key] = _CLOSED[work["arm"][:5]](arm, np.array(work["target"]))
            return checks.compare_branches(text, _solved[key], **says)
        case "trace":
            path = dict(work["path"])
            start = path.pop("start")
            return checks.compare_trace(text, arm, motion.circle_below(arm, start, **path), **says)
    raise ValueError(work["kind"])


def verdict(work: Mapping) -> tuple[str, str]:
    """Compare the judge's verdict with the truth; return the outcome and the headline."""
    try:
        report = report_on(work)
    except ArmError as refusal:
        return "refused", str(refusal)
    words = f"{report.grade}: {report.headline} {list(report.causes)}"
    if work["truth"] != "wrong":
        if report.grade == work["truth"]:
            return "right", words
        told = {"rounded": "so far", "wrong": "called wrong"}
        return told.get(report.grade, report.grade), words
    names = {name for slip in work["slips"] for name in NAMES.get(slip, ())}
    if report.grade == "so far":
        return ("named" if "so far" in names else "so far"), words
    if report.grade != "wrong":
        return "passed", words
    causes = [_mistakes_in(cause, names) for cause in report.causes]
    if not any(causes):
        return "located", words
    # Causes are alternatives. A cause with a second mistake that was not made is false.
    return ("named" if any(one and one <= names for one in causes) else "false cause"), words


def _mistakes_in(cause: str, names: set[str]) -> set[str]:
    """The mistakes that a cause names, without the symptoms that only say where."""
    keys = {key.partition(":")[0] for key in cause.split(" + ")}
    return keys - (_SYMPTOMS - names)


def main() -> None:
    asked = argparse.ArgumentParser(description=__doc__)
    asked.add_argument("files", nargs="+", type=Path)
    asked.add_argument("--kind")
    asked.add_argument("--show", help="print the works with this verdict", action="append")
    options = asked.parse_args()
    works = [json.loads(line) for file in options.files for line in file.open(encoding="utf-8")]
    counts: Counter[tuple[str, str, str]] = Counter()
    for work in works:
        if options.kind in (None, work["kind"]):
            found, words = verdict(work)
            counts[work["kind"], work["truth"], found] += 1
            if options.show and f"{work['truth']} {found}" in options.show:
                print(f"--- {work['id']} {work['kind']} {work['arm']} {work['slips']} {found}")
                print(f"{work['text'][:1500]}\n=> {words}\n")
    for truth, verdicts in (("right", RIGHT), ("right by map", RIGHT), ("wrong", WRONG)):
        print(f"| {truth} | " + " | ".join(verdicts) + " |\n|:--" + "|--:" * len(verdicts) + "|")
        for kind in [*dict.fromkeys(work["kind"] for work in works), "all"]:
            held = {key: n for key, n in counts.items() if kind in (key[0], "all")}
            row = [
                sum(n for (_, *key), n in held.items() if key == [truth, one]) for one in verdicts
            ]
            if any(row):
                print(f"| {kind} | " + " | ".join(map(str, row)) + " |")
        print()


if __name__ == "__main__":
    main()
