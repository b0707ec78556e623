"""Print the marks of usual and of random mistakes, as asked and rounded.

`python -m tests.course.marks_table 50` takes 50 sheets of each arm.
"""

import sys
from collections import defaultdict

import numpy as np

from course.marking import MISTAKE_SHARE, mark_part
from course.sheets import sheet
from helpers.robots import ELBOW, PANDA, STANFORD, UR10E

MEASURED = ("numbers", "rotation", "jacobian", "torques")
ARMS = (ELBOW, STANFORD, PANDA.lock(3), UR10E)


def list_measured_parts(mine):
    """List the parts of a sheet whose answers are numbers."""
    return [part for part in mine.parts.values() if part.kind in MEASURED]


def as_text(numbers, digits):
    """Write numbers as text with so many decimals."""
    return np.vectorize(lambda x: f"{x:.{digits}f}")(numbers).tolist()


def mark_text(mine, part, numbers, digits):
    """Mark numbers written with so many decimals."""
    return mark_part(mine, part.name, as_text(numbers, digits))


def format_share(part, wrong, digits):
    """Return the share of numbers that rounding still tells from the right ones."""
    return float(np.mean(np.round(wrong, digits) != np.round(part.value, digits)))


def main(seeds):
    """Print one line for each kind of mistake: count, marks with asked and fewer digits."""
    rows, lucky, same = defaultdict(list), 0, defaultdict(set)
    for arm in ARMS:
        for seed in range(seeds):
            mine, rng = sheet(arm, f"table {seed}"), np.random.default_rng(seed)
            for part in list_measured_parts(mine):
                cases = [("none: it is right", part.value)]
                cases += [(m.name.split(":")[0], m.values) for m in part.mistakes]
                for size in (0.003, 0.01, 0.03, 0.1):
                    wrong = part.value * (1 + size * rng.choice([-1, 1], np.shape(part.value)))
                    cases.append((f"random, {100 * size:g} %", wrong))
                for name, numbers in cases:
                    marks = [mark_text(mine, part, numbers, n).credit for n in (part.digits, 2, 1)]
                    told = [format_share(part, numbers, n) for n in (2, 1)]
                    rows[name].append([*marks, *told])
                    if name[:6] not in ("none: ", "random"):
                        same[name].add(marks[0])
                        lucky += max(marks[1:]) > marks[0]
    print("  answers  as asked  2 digits  1 digit  told at 2  told at 1  mistake")
    for name, values in sorted(rows.items()):
        mean = "  ".join(f"{x:8.3f}" for x in np.mean(values, axis=0))
        print(f"{len(values):9}  {mean}  {name}")
    print(f"rounded mistakes that earn more than as asked: {lucky}")
    odd = {name: sorted(x) for name, x in same.items() if x not in ({MISTAKE_SHARE}, {0.0})}
    print(f"mistakes that do not cost the same everywhere: {odd}")


if __name__ == "__main__":
    main(int(sys.argv[1]) if len(sys.argv) > 1 else 2)
