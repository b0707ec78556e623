"""Test that the first part of a right answer is right so far, with any filler for the rest.

Unfinished torques, angles and tables are questions of cases.json ("first ...").
"""

import numpy as np
import pytest

from helpers import checks, motion, robots
from helpers.arm import Arm, ArmError, prismatic
from tests.corpus.arms import KNOWN

Q = np.array([0.4, -0.3, 0.5, -0.9, -0.6, 0.8, 0.2])
JACOBIAN = KNOWN["PANDA"].jacobian(Q)
REST = ("?", "-", "...", "", None)


def write(rows, decimals=4):
    return [" ".join(f"{x:.{decimals}f}" for x in row) for row in rows]


def fill(lines, count, width, rest):
    """Return the first lines, and other lines with `rest` for each number if it is not None."""
    end = [] if rest is None else [" ".join([rest] * width)] * (len(lines) - count)
    return "\n".join([*lines[:count], *end])


def grade_jacobian(text):
    try:
        return checks.compare_jacobian(text, robots.PANDA, Q).grade
    except ArmError:
        return "refused"


@pytest.mark.parametrize("rest", REST)
@pytest.mark.parametrize("count", [2, 3, 4, 5])
def test_first_rows_of_jacobian_are_right_so_far(count, rest):
    assert grade_jacobian(fill(write(JACOBIAN), count, 7, rest)) == "so far"
    wrong = JACOBIAN.copy()
    wrong[1, 2] += 0.1
    assert grade_jacobian(fill(write(wrong), count, 7, rest)) in ("wrong", "refused")


@pytest.mark.parametrize("rest", ["?", "...", "todo", None])
@pytest.mark.parametrize("count", [1, 3, 6])
def test_first_columns_of_jacobian_are_right_so_far(count, rest):
    end = "" if rest is None else f" {rest}" * (7 - count)
    text = "\n".join(line + end for line in write(JACOBIAN[:, :count]))
    verdict = checks.compare_jacobian(text, robots.PANDA, Q)
    assert verdict.headline == f"The Jacobian of Panda is right so far: {count} of 7 columns."
    assert verdict.findings[0].words.endswith("column 7.")
    wrong = JACOBIAN.copy()
    wrong[1, 0] += 0.1
    lines = write(wrong[:, :count])
    assert grade_jacobian("\n".join(line + end for line in lines)) in ("wrong", "refused")


def test_columns_behind_a_gap_are_not_right_so_far():
    lines = write(JACOBIAN[:, [0, 2]])
    assert grade_jacobian("\n".join(lines)) != "so far"
    gap = [line.replace(" ", " ? ", 1) + " ? ? ? ?" for line in lines]
    assert grade_jacobian("\n".join(gap)) == "refused"
    dashes = [f"{line} - - - - -" for line in write(JACOBIAN[:, :2])]  # minus signs as dashes
    assert grade_jacobian("\n".join(dashes)) == "refused"


@pytest.mark.parametrize("rest", REST)
def test_first_rows_of_trace_are_right_so_far(rest):
    circle = motion.circle((0.3, 0.0, 0.3), 0.1, "xz", 5.0, 12)
    sledge = Arm("sledge", [prismatic(alpha=np.pi / 2, theta=np.pi / 2), prismatic()])
    lines = write(circle.positions[:, [2, 0]])
    verdict = checks.compare_trace(fill(lines, 7, 2, rest), sledge, circle)
    assert verdict.headline == "sledge draws the path so far: 7 of 13 rows."
    wrong = fill([*lines[:3], "0.5 0.5", *lines[4:]], 7, 2, rest)
    assert checks.compare_trace(wrong, sledge, circle).causes == ("trace.shape",)


def test_line_of_dashes_before_a_word_takes_no_time():
    """A pattern with nested repetitions would need 2**60 steps."""
    text = "0.0 -97.5297 -54.7816\n" + 60 * "-" + " end"
    with pytest.raises(ArmError):
        checks.compare_torques(text, robots.UR10E, [0.3, -1.1, 1.4, -0.8, 0.9, 0.2])
