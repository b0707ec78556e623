"""Test that a comma is read as the student meant it, or that the judge asks which.

The law draws right answers of many arms and topics, writes them with decimal commas or as whole
numbers between commas, and lays them out in rows, columns and lists. Angles are in degrees.
"""

import contextlib
import random
from collections import Counter

import numpy as np
import pytest

from helpers.arm import Arm, fixed, revolute
from helpers.checks import (
    compare_branches,
    compare_jacobian,
    compare_pose,
    compare_tables,
    compare_torques,
)
from helpers.inputs import ArmError
from helpers.inverse import solutions
from helpers.kinematics import forward_kinematics, jacobian
from tests.node import needs_node

pytestmark = needs_node

HALF = np.pi / 2
LINK = revolute(2, 0, 0)
# Links of equal whole lengths, so that all branches of a whole angle are whole.
ELBOW = [revolute(0, HALF, 1), LINK, LINK]
WRIST = [revolute(0, HALF, 0), revolute(0, -HALF, 0), revolute(0, 0, 1)]
ARMS = {
    "one joint": [LINK],
    "two joints": [LINK, LINK],
    "planar": [LINK, LINK, LINK],
    "elbow": ELBOW,
    "fixed rows": ELBOW + [fixed(0, 0, 0)] * 3,
    "six joints": ELBOW + WRIST,
}
TOPICS = {
    "pose": list(ARMS),
    "branches": ["two joints", "planar", "elbow", "fixed rows"],
    "torques": list(ARMS),
    "jacobian": list(ARMS),
    "table": ["one joint", "two joints", "planar", "elbow", "six joints"],
}
QUESTION = "and I cannot tell which"
DRAWS = 40  # for each topic


def draw_answer(rng, topic, is_whole):
    """Return right numbers, a row for each answer, and the function that judges a text of them."""
    name = rng.choice(TOPICS[topic])
    arm = Arm(name, ARMS[name])
    least = rng.choice([11, -170])
    degrees = np.array([rng.randint(least, 170) for _ in range(arm.dof)])
    q = np.radians(degrees if is_whole else degrees + rng.uniform(0.1, 0.9))
    T = forward_kinematics(arm, q)
    target = T if name in ("planar", "six joints") else T[:3, 3]
    if topic == "pose":
        return np.degrees([q]), lambda text: compare_pose(text, arm, target, angles="deg")
    if topic == "branches":
        found = solutions(arm, target)
        answers = np.degrees(found.q[found.valid])
        return answers, lambda text: compare_branches(text, found, angles="deg")
    if topic == "torques":
        configurations = np.array([q + 0.1 * k for k in range(rng.randint(1, 3))])
        force = [rng.choice([-5, -20, 50]), 7, 0, 0, 0, 0]
        torques = np.array([-jacobian(arm, each).T @ force for each in configurations])
        ask = compare_torques
        return torques, lambda text: ask(text, arm, configurations, force, tolerance=0.51)
    if topic == "jacobian":
        q = np.radians([rng.choice([0, 90, 180, -90]) for _ in q]) if is_whole else q
        return jacobian(arm, q), lambda text: compare_jacobian(text, arm, q)
    size = 100 if is_whole else rng.uniform(80, 130)
    table = [[size * row.a, np.degrees(row.alpha), size * row.d, 0] for row in arm.rows]
    scaled = [revolute(row.a * size / 1e3, row.alpha, row.d * size / 1e3) for row in arm.rows]
    return np.array(table, float), lambda text: compare_tables(text, Arm(name, scaled))


def write_cells(rng, rows, is_whole):
    """Return the typed cells and a separator."""
    if is_whole:
        return [[f"{round(x)}" for x in row] for row in rows], rng.choice([",", ",", ", "])
    places = rng.randint(1, 3)
    cells = [[f"{x + 0.0:.{places}f}".replace(".", ",") for x in row] for row in rows]
    return cells, rng.choice([" ", "  ", "; ", ";", "\t", " | ", ", "])


def lay_out(rng, topic, cells, separator):
    """Return a text: rows or columns, with counts, a name or brackets."""
    if topic == "table":
        rows = [[*row[:3], f"q{k}"] for k, row in enumerate(cells, 1)]
        headers = ["a [mm]", "alpha [deg]", "d [mm]", "theta [deg]"]
        return "\n".join(separator.join(row) for row in [headers, *rows])
    styles = ["plain", "counted", "name", "brackets", "list", "semicolons"]
    style = rng.choice([s for s in styles if s != "semicolons" or ";" not in separator])
    is_column = len(cells) != len(cells[0]) and topic != "jacobian" and rng.random() < 0.5
    if is_column and style != "name":
        cells = list(zip(*cells, strict=True))
    if style == "counted" and len(cells) > 1:
        cells = [[f"{k}", *row] for k, row in enumerate(cells, 1)]
    lines = [separator.join(row) for row in cells]
    if style == "semicolons":
        return f"[{'; '.join(lines)}]"
    if style in ("brackets", "list"):
        lines = [f"[{line}]" for line in lines]
    names = {"jacobian": "J", "torques": "tau"}
    name = f"{names.get(topic, 'q')} = " if style == "name" else ""
    return f"[{', '.join(lines)}]" if style == "list" else name + "\n".join(lines)


@pytest.mark.parametrize("topic", TOPICS)
@pytest.mark.parametrize("is_whole", [True, False], ids=["separators", "decimals"])
def test_comma_is_read_as_meant_or_asked_about(topic, is_whole):
    rng = random.Random(f"{topic} {is_whole}")
    counts, wrong = Counter(), []
    for _ in range(DRAWS):
        rows, judge = draw_answer(rng, topic, is_whole)
        if is_whole and topic != "torques" and abs(rows - rows.round()).max() > 1e-6:
            continue
        text = lay_out(rng, topic, *write_cells(rng, rows, is_whole))
        try:
            grade = judge(text).grade
        except ArmError as error:
            grade = "asked" if QUESTION in str(error) else "refused"
        counts[grade] += 1
        if grade in ("wrong", "refused"):
            wrong.append((grade, text))
    assert not [text for grade, text in wrong if grade == "wrong"]
    assert counts["refused"] <= 1, wrong
    if not is_whole:
        assert not counts["asked"]


@pytest.mark.parametrize("topic", TOPICS)
@pytest.mark.parametrize("is_whole", [True, False], ids=["separators", "decimals"])
def test_wrong_answer_is_right_in_no_reading_of_commas(topic, is_whole):
    rng = random.Random(f"wrong {topic} {is_whole}")
    for _ in range(DRAWS):
        rows, judge = draw_answer(rng, topic, is_whole)
        if is_whole and topic != "torques" and abs(rows - rows.round()).max() > 1e-6:
            continue
        wrong = np.array(rows)
        wrong[rng.randrange(len(rows)), rng.randrange(3) % rows.shape[1]] += rng.choice([7, -9, 23])
        text = lay_out(rng, topic, *write_cells(rng, wrong, is_whole))
        with contextlib.suppress(ArmError):  # the judge may ask
            assert judge(text).grade == "wrong", text
