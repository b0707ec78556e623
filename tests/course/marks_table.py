"""Print the marks of usual and of random mistakes, as asked and rounded.

`python -m tests.course.marks_table 50` takes 50 sheets of each arm.
"""

import sys
from collections import defaultdict

import numpy as np

from course.marking import MISTAKE_SHARE, mark_part
from course.sheets import draw_sheet
from helpers.robots import ELBOW, PANDA, STANFORD, UR10E

MEASURED = ("numbers", "rotation", "jacobian", "torques")
ARMS = (ELBOW, STANFORD, PANDA.lock(3), UR10E)


def list_measured_parts(own):
    """List the parts of a sheet whose answers are numbers."""
    return [part for part in own.parts.values() if part.kind in MEASURED]


def as_text(numbers, digits):
    """Write numbers as text with so many decimals."""
    return np.vectorize(lambda x: f"{x:.{digits}f}")(numbers).tolist()


def mark_text(own, part, numbers, digits):
    """Mark numbers written with so many decimals."""
    return mark_part(own, part.name, as_text(numbers, digits))


def compute_visible_share(part, wrong, digits):
    """Return the share of numbers that rounding still tells from the right ones."""
    return float(np.mean(np.round(wrong, digits) != np.round(part.value, digits)))


def main(seeds):
    """Print one line for each kind of mistake: count, marks with asked and fewer digits."""
    rows, raised, credits_by_name = defaultdict(list), 0, defaultdict(set)
    for arm in ARMS:
        for seed in range(seeds):
            own, rng = draw_sheet(arm, f"table {seed}"), np.random.default_rng(seed)
            for part in list_measured_parts(own):
                cases = [("none: it is right", part.value)]
                cases += [(m.name.split(":")[0], m.values) for m in part.mistakes]
                for size in (0.003, 0.01, 0.03, 0.1):
                    wrong = part.value * (1 + size * rng.choice([-1, 1], np.shape(part.value)))
                    cases.append((f"random, {100 * size:g} %", wrong))
                for name, numbers in cases:
                    marks = [mark_text(own, part, numbers, n).credit for n in (part.digits, 2, 1)]
                    visible_shares = [compute_visible_share(part, numbers, n) for n in (2, 1)]
                    rows[name].append([*marks, *visible_shares])
                    if name[:6] not in ("none: ", "random"):
                        credits_by_name[name].add(marks[0])
                        raised += max(marks[1:]) > marks[0]
    print("  answers  as asked  2 digits  1 digit  seen at 2  seen at 1  mistake")
    for name, values in sorted(rows.items()):
        mean = "  ".join(f"{x:8.3f}" for x in np.mean(values, axis=0))
        print(f"{len(values):9}  {mean}  {name}")
    print(f"rounded mistakes that earn more than as asked: {raised}")
    odd = {
        name: sorted(x) for name, x in credits_by_name.items() if x not in ({MISTAKE_SHARE}, {0.0})
    }
    print(f"mistakes that do not cost the same everywhere: {odd}")


if __name__ == "__main__":
    main(int(sys.argv[1]) if len(sys.argv) > 1 else 2)
