"""Count how the judge grades works that people wrote without having seen it.

    python -m tests.measure.works FILE.jsonl ... [--kind jacobian] [--show refused]

Each line of a file is a work: its kind, arm, question and text, whether it is right, and else its
slips by name. A table is "right by map" if its slips only choose other zeros or directions of the
joints. `causes_of_slips.json` holds for each slip the causes that name it ("so far" where asking
for more is the right answer).
"""

import argparse
import json
from collections import Counter
from collections.abc import Mapping
from pathlib import Path

import numpy as np

from helpers import checks, inverse, motion, robots
from helpers.inputs import ArmError

CAUSES_OF_SLIP = json.loads(Path(__file__).with_name("causes_of_slips.json").read_text("utf-8"))
RIGHT = ("right", "so far", "refused", "called wrong")
WRONG = ("named", "located", "so far", "passed", "false cause", "refused")
_CLOSED = {"UR10E": inverse.ur, "STANF": inverse.stanford, "ELBOW": inverse.elbow}
# Causes that locate an error without naming a mistake.
_SYMPTOMS = {
    *("trace.leans", "trace.spins", "trace.jump", "table.missing"),
}
_solution_cache: dict[str, object] = {}


def find_arm(name: str) -> robots.Arm:
    """Return the arm of a name such as ``PANDA.lock(3)``."""
    base, _, locked = name.partition(".lock(")
    arm = getattr(robots, base)
    return arm.lock(int(locked[:-1])) if locked else arm


def judge_work(work: Mapping) -> checks.Verdict:
    """Return the judge's verdict on a work; raise ArmError if the judge refuses it."""
    arm, text, options = find_arm(work["arm"]), work["text"], work["says"]
    match work["kind"]:
        case "jacobian":
            return checks.compare_jacobian(text, arm, work["q"], **options)
        case "torques":
            return checks.compare_torques(text, arm, work["q"], work["wrench"], **options)
        case "table":
            return checks.compare_tables(text, arm, **options)
        case "pose":
            return checks.compare_pose(text, arm, work["target"], **options)
        case "branches":
            key = json.dumps([work["arm"], work["target"]])
            if key not in _solution_cache:
                _solution_cache[key] = _CLOSED[work["arm"][:5]](arm, np.array(work["target"]))
            return checks.compare_branches(text, _solution_cache[key], **options)
        case "trace":
            path = dict(work["path"])
            start = path.pop("start")
            return checks.compare_trace(
                text, arm, motion.circle_below(arm, start, **path), **options
            )
    raise ValueError(work["kind"])


def compare_with_truth(work: Mapping) -> tuple[str, str]:
    """Compare the judge's verdict with the truth; return the outcome and the headline."""
    try:
        report = judge_work(work)
    except ArmError as refusal:
        return "refused", str(refusal)
    summary = f"{report.grade}: {report.headline} {list(report.causes)}"
    if work["truth"] != "wrong":
        if report.grade == work["truth"]:
            return "right", summary
        outcomes = {"rounded": "so far", "wrong": "called wrong"}
        return outcomes.get(report.grade, report.grade), summary
    names = {name for slip in work["slips"] for name in CAUSES_OF_SLIP.get(slip, ())}
    if report.grade == "so far":
        return ("named" if "so far" in names else "so far"), summary
    if report.grade != "wrong":
        return "passed", summary
    causes = [_mistakes_in(cause, names) for cause in report.causes]
    if not any(causes):
        return "located", summary
    # Causes are alternatives. A cause is false if it includes a mistake that was not made.
    return (
        "named" if any(mistakes and mistakes <= names for mistakes in causes) else "false cause"
    ), summary


def _mistakes_in(cause: str, names: set[str]) -> set[str]:
    """Return the mistakes that a cause names, without symptoms that only locate an error."""
    keys = {key.partition(":")[0] for key in cause.split(" + ")}
    return keys - (_SYMPTOMS - names)


def main() -> None:
    """Read the command line and print a table of verdicts for each truth."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("files", nargs="+", type=Path)
    parser.add_argument("--kind")
    parser.add_argument("--show", help="print the works with this verdict", action="append")
    options = parser.parse_args()
    works = [json.loads(line) for file in options.files for line in file.open(encoding="utf-8")]
    counts: Counter[tuple[str, str, str]] = Counter()
    for work in works:
        if options.kind in (None, work["kind"]):
            outcome, summary = compare_with_truth(work)
            counts[work["kind"], work["truth"], outcome] += 1
            if options.show and f"{work['truth']} {outcome}" in options.show:
                print(f"--- {work['id']} {work['kind']} {work['arm']} {work['slips']} {outcome}")
                print(f"{work['text'][:1500]}\n=> {summary}\n")
    for truth, verdicts in (("right", RIGHT), ("right by map", RIGHT), ("wrong", WRONG)):
        print(f"| {truth} | " + " | ".join(verdicts) + " |\n|:--" + "|--:" * len(verdicts) + "|")
        for kind in [*dict.fromkeys(work["kind"] for work in works), "all"]:
            selected = {key: n for key, n in counts.items() if kind in (key[0], "all")}
            row = [
                sum(n for (_, *key), n in selected.items() if key == [truth, name])
                for name in verdicts
            ]
            if any(row):
                print(f"| {kind} | " + " | ".join(map(str, row)) + " |")
        print()


if __name__ == "__main__":
    main()
