"""How much work a verdict is, in calls and in hypotheses.

These figures depend on no machine, as times do.
50 ms are some 200 000 calls on a machine of 2020.
"""

import sys
from itertools import islice

import numpy as np
import pytest

from helpers import checks
from helpers.checks import jacobian_causes, tables, torques_causes
from helpers.checks.axes import numeric, side
from helpers.checks.digits import of_floats
from helpers.checks.door import numbers
from helpers.robots import PANDA
from helpers.statics import GRAVITY
from tests.corpus.judge import load, report

BENT = [0.4, -0.3, 0.5, 0.9, -0.6, 0.8, 0.2]
# The most calls of any case of the stored corpus, and a quarter more.
MOST = {
    "jacobian": 50_000,
    "table": 150_000,
    "torques": 45_000,
    "branches": 19_000,
    "pose": 45_000,
    "trace": 200_000,
}


def calls(work):
    """The calls of functions, in Python and in C, that `work` makes when it is done again."""
    count = 0

    def seen(frame, event, argument):
        nonlocal count
        count += event in ("call", "c_call")

    work()
    before = sys.getprofile()
    sys.setprofile(seen)
    try:
        work()
    finally:
        sys.setprofile(before)
    return count


def hard(case):
    """Whether a case is among those that are much work: nothing or two mistakes explain it, or the
    order of the columns has to be guessed.
    """
    return case["kind"] in ("noise", "pair", "whole") or "bare" in case["form"]


@pytest.mark.parametrize("topic", MOST)
def test_a_verdict_is_so_much_work_at_most(topic):
    found = load(topic)
    cases = [c for c in found["cases"] if hard(c)] or found["cases"]
    asked = [*cases[-6:], *islice(cases, 0, None, max(1, len(cases) // 8))]
    done = [calls(lambda case=case: report(case, found["arms"])) for case in asked]
    assert max(done) <= MOST[topic], sorted(done)


def test_a_wrong_function_of_the_table_is_judged_once_and_not_for_each_order():
    def wrong(table, q):
        return np.outer(np.arange(1, 7), np.sum(table, axis=1)[: len(q)])

    assert calls(lambda: checks.compare_jacobian(wrong, PANDA, BENT)) <= MOST["jacobian"]


def test_a_run_of_a_thousand_torques_is_little_more_work_than_to_read_it():
    q = np.linspace(-1, 1, 7000).reshape(1000, 7)
    tau = np.arange(7000.0).reshape(1000, 7)
    read = calls(lambda: of_floats(tau))
    assert calls(lambda: checks.compare_torques(tau, PANDA, q)) <= 2 * read + MOST["torques"]


def test_a_long_paste_of_numbers_is_read_at_once():
    """350 numbers; as formulas, each known already, they take 14 000 calls."""
    text = "\n".join(" ".join(f"{i + j / 7:.4f}" for j in range(7)) for i in range(50))
    assert calls(lambda: numbers(text, "yours")) <= 12_000


def test_hypotheses_are_counted():
    """So many are held against an answer: a catalogue that grows by the square shows here."""
    at = (PANDA, np.array(BENT), 0)
    load_ = torques_causes.Load(PANDA, np.array([BENT]), np.ones((1, 6)), np.array(GRAVITY))
    rows = list(numeric(PANDA))
    assert len(jacobian_causes.singles(*at).causes) <= 120
    assert len(jacobian_causes.pairs(*at).causes) <= 4000
    assert len(torques_causes.catalogue(load_, 1)[0]) <= 40
    assert len(torques_causes.catalogue(load_, 2)[0]) <= 320
    assert len(list(tables._tries(rows, PANDA, side(tuple(rows)), False, 1e-6))) <= 160
