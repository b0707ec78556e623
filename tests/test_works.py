"""Test the judge on 600 stored answers of students: the numbers it reads, its grade and its causes.

`works/read.jsonl` has a line for each work: the numbers that its maker wrote as entries, row by
row, with the unit beside them, and the grade and causes that the judge gives. Where the judge reads
other numbers than the maker's, the line says why ("differs").
"""

import json
from pathlib import Path

import pytest

from helpers.inputs import ArmError
from tests.measure.works import judge_work

FOLDER = Path(__file__).with_name("works")
FILES = ("a", "a-closed", "b", "b-closed")
KINDS = ("table", "jacobian", "torques", "pose", "branches", "trace")
ROUND_OFF = 2e-6  # read.jsonl keeps seven digits of each number


def lines_of(name):
    with (FOLDER / f"{name}.jsonl").open(encoding="utf-8") as lines:
        return [json.loads(line) for line in lines]


EXPECTED = {line["id"]: line for line in lines_of("read")}


def judge(work):
    """Judge a work; return the grade, the causes and the numbers that the judge read."""
    try:
        report = judge_work(work)
    except ArmError:
        return "refused", [], []
    return report.grade, list(report.causes), [n.value for n in report.read if n.owner == "entry"]


def are_equal(numbers, others):
    return len(numbers) == len(others) and all(
        abs(x - y) <= ROUND_OFF * max(1, abs(y)) for x, y in zip(numbers, others, strict=True)
    )


@pytest.mark.parametrize("kind", KINDS)
@pytest.mark.parametrize("name", FILES)
def test_works_are_read_as_written_and_judged_as_before(name, kind):
    changed = []
    for work in lines_of(name):
        if work["kind"] != kind:
            continue
        expected = EXPECTED[work["id"]]
        grade, causes, numbers = judge(work)
        if (grade, causes) != (expected["grade"], expected["causes"]):
            changed.append((work["id"], grade, causes))
        if are_equal(numbers, expected.get("numbers", [])) == ("differs" in expected):
            changed.append((work["id"], "reads", numbers[:12]))
    assert changed == []
