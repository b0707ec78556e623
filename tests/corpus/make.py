"""Write the corpus: ``python -m tests.corpus.make [folder] [--seed 16] [--scale 1]``, one JSON file
for each topic.

The cases are plain data: what was typed, the arm by its rows, and which cause an answer hides. No
helper is used.
"""

import argparse
import json
from itertools import islice
from pathlib import Path

import numpy as np

from tests.corpus import answers, jacobians, tables, torques, traces

HERE = Path(__file__).parent
TOPICS = {
    "jacobian": (jacobians.cases, 1000),
    "table": (tables.cases, 800),
    "torques": (torques.cases, 500),
    "branches": (answers.every_branch, 300),
    "pose": (answers.every_pose, 250),
    "trace": (traces.cases, 60),
}
KNOWN = ("PANDA", "UR10E", "UR10E_HOMEWORK", "STANFORD", "ELBOW", "PANDA.lock(3)")


def plain(case, arms):
    """A case as data: its machine as the number of an arm in the list."""
    found = {
        k: v
        for k, v in case.items()
        if k not in ("machine", "rows", "alone", "bodies") and v is not None
    }
    for key, rows in (
        ("arm", case.get("machine")),
        ("mine", case.get("rows")),
        ("alone", case.get("alone")),
    ):
        if key == "arm" and rows is not None:
            known = rows.name if rows.name in KNOWN else None
            entry = dict(known=known, rows=[list(r) for r in rows.rows])
            if case.get("bodies"):
                entry["bodies"] = [list(b) for b in case["bodies"]]
            if entry not in arms:
                arms.append(entry)
            found["arm"] = arms.index(entry)
        elif rows is not None and key != "arm" and case.get("cause"):
            found[key] = [list(r) for r in rows]
    return found


def corpus(topic, seed, scale=1.0, first=None):
    """Arms and cases of one topic, or its first cases only."""
    rule, count = TOPICS[topic]
    arms = []
    rng = np.random.default_rng([seed, list(TOPICS).index(topic)])
    made = islice(rule(rng, max(1, round(count * scale))), first)
    cases = [plain(case, arms) for case in made]
    return dict(seed=seed, topic=topic, arms=arms, cases=cases)


def as_plain_number(x):
    return float(x) if isinstance(x, np.floating) else int(x) if isinstance(x, np.integer) else x


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("folder", nargs="?", default=HERE, type=Path)
    parser.add_argument("--seed", type=int, default=16)
    parser.add_argument("--scale", type=float, default=1.0)
    chosen = parser.parse_args()
    chosen.folder.mkdir(parents=True, exist_ok=True)
    for topic in TOPICS:
        found = corpus(topic, chosen.seed, chosen.scale)
        head = json.dumps({k: v for k, v in found.items() if k != "cases"}, default=as_plain_number)
        lines = ",\n".join(
            json.dumps(case, ensure_ascii=False, default=as_plain_number) for case in found["cases"]
        )
        text = f'{head[:-1]}, "cases": [\n{lines}\n]}}\n'
        (chosen.folder / f"{topic}.json").write_text(text, encoding="utf-8")


if __name__ == "__main__":
    main()
