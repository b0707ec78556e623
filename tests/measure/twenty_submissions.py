"""Measure the credit of a program that submits twenty times and uses only the hints.

`python -m tests.measure.twenty_submissions 5` takes 5 sheets. The program changes signs, zeros and
twists and keeps a change once the hint names no mistake any more. It may read which entry of a
table a hint names; then it changes this entry alone.
"""

import re
import sys
from collections import defaultdict

import numpy as np

from course.making import make_right_answers
from course.marking import mark_part
from course.sheets import draw_sheet
from helpers.robots import ELBOW

TRIES = 20
TOPICS = ("DH table", "forward kinematics", "Jacobian")
TWISTS = ("0", "pi/2", "-pi/2")
NAMED_ENTRY = re.compile(r"\b(alpha|a|d|theta)\b in row (\d)")
NAMED = "mistake gives"  # occurs in every hint that names a mistake


def list_changes(answer, hint, rng):
    """List changed answers in random order: entries, rows, columns and three rows together."""
    texts = np.array(answer).astype(object).reshape(len(answer), -1)
    rows, columns = texts.shape
    pieces = [np.s_[i : i + 1, j : j + 1] for i in range(rows) for j in range(columns)]
    pieces += [np.s_[i, :] for i in range(rows)] + [np.s_[:, j] for j in range(columns)]
    pieces += [np.s_[:3, :], np.s_[3:, :]]
    if hint:
        i, j = int(hint[1]) - 1, ["a", "alpha", "d", "theta"].index(hint[0])
        pieces = [np.s_[i : i + 1, j : j + 1]]
    negate = np.vectorize(lambda x: x.removeprefix("-") if x[:1] == "-" else f"-{x}", [object])
    functions = [negate, lambda x: "0"]
    functions += [lambda _, twist=twist: twist for twist in TWISTS[1:]] * (columns == 4)
    changes = []
    for piece in pieces:
        for function in functions:
            changed = texts.copy()
            changed[piece] = function(changed[piece])
            changes.append(changed.squeeze().tolist())
    return [changes[n] for n in rng.permutation(len(changes))]


def submit_often(own, name, answer, rng, reads):
    """Return the credit of the first submission and of the one that is kept."""
    first = mark_part(own, name, answer)
    entry = NAMED_ENTRY.search(first.hint) if reads else None
    for other in list_changes(answer, entry and entry.groups(), rng)[: TRIES - 1]:
        mark = mark_part(own, name, other)
        if NAMED in first.hint and NAMED not in mark.hint:
            return first.credit, mark.credit
    return first.credit, first.credit


def list_wrong_answers(key, rng):
    """List names, kinds of mistake and wrong answers, as text."""
    as_text = np.vectorize(lambda x: f"{x:.4f}")
    for name in ("p", "R", "J", "xi"):
        right = np.array(key[name])
        off = right * (1 + rng.uniform(0.01, 0.1, right.shape))
        yield name, "numbers off by 1 to 10 %", as_text(off).tolist()
    J = np.array(key["J"])
    for wrong in (np.r_[-J[:3], J[3:]], np.r_[J[:3], 0 * J[3:]], -J):
        yield "J", "signs or zeros of half a Jacobian", as_text(wrong).tolist()
    for row in range(3):
        table = [list(entries) for entries in key["table"]]
        table[row][1] = TWISTS[(TWISTS.index(table[row][1]) + 1) % 3]
        yield "table", "one twist of a table", table
        table = [list(entries) for entries in key["table"]]
        if float(table[row][0]):
            table[row][0] = "0"
            yield "table", "a length of a table is 0", table


def main(seeds):
    """Print the mean credits by kind of mistake."""
    credits, rng = defaultdict(list), np.random.default_rng(0)
    for seed in range(seeds):
        own = draw_sheet(ELBOW, f"twenty {seed}", TOPICS)
        for name, kind, answer in list_wrong_answers(make_right_answers(own), rng):
            blind = submit_often(own, name, answer, rng, reads=False)
            reading = submit_often(own, name, answer, rng, reads=True)
            credits[kind].append([*blind, reading[1]])
    print("answers  first  after 20  after 20, reading  mistake")
    for kind, values in credits.items():
        first, last, reading = np.mean(values, axis=0)
        print(f"{len(values):7}  {first:5.2f}  {last:8.2f}  {reading:17.2f}  {kind}")


if __name__ == "__main__":
    main(int(sys.argv[1]) if len(sys.argv) > 1 else 1)
