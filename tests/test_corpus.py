"""The stored corpus: work whose truth is known, typed as people type it, put to the checkers.

Every twentieth case runs here; ``python -m tests.corpus.confusion`` runs them all and writes the
tables of the book's page on how the checkers judge.
"""

import json
import re
from collections import Counter
from itertools import islice

import pytest

from tests.corpus.judge import load, outcome, report
from tests.corpus.make import TOPICS, as_plain_number, corpus

# What a finding may be about, or the catalogue's name of a mistake; and where.
KINDS = {"cause", "shape", "column", "row", "joint", "answer", "missing", "step", "found"}
CAUSE = r"(J|tau|table|ik|pose|trace)\.[a-z].*"
WHERE = (
    r"|((column|joint|answer|step) \d+|row \d+(, (a|alpha|d|theta))?|(linear|angular) rows"
    r"|(front|back|elbow|rod)[^X]*|[xyz]|.*entry.*)"
)


def well_formed(said, topic):
    assert said.topic == {"jacobian": "Jacobian"}.get(topic, topic)
    assert isinstance(said.arm, str)
    for finding in said.findings:
        assert finding.what in KINDS or re.fullmatch(CAUSE, finding.what), finding
        assert re.fullmatch(WHERE, finding.where), finding


def counted(topic, step):
    found = load(topic)
    for case in found["cases"][::step]:
        digits = "rough" if case["digits"] <= 2 else "fine"
        kind = "pair" if " + " in (case.get("cause") or "") else "single"
        said = report(case, found["arms"])
        well_formed(said, topic)
        how = outcome(case, found["arms"], said)
        yield (kind if case.get("cause") else case["kind"], digits, how)


@pytest.mark.parametrize("topic", TOPICS)
def test_what_is_right_passes_and_mistakes_are_named(topic):
    counts = Counter(counted(topic, 4 if topic == "trace" else 20))
    alarms = {c: n for c, n in counts.items() if c[2] in ("false alarm", "accepted")}
    assert not alarms
    for kind, least in (("single", 0.97), ("pair", 0.9)):
        of_kind = {c[2]: n for c, n in counts.items() if c[:2] == (kind, "fine")}
        judged = sum(of_kind.values()) - of_kind.get("same arm", 0)
        assert of_kind.get("named", 0) >= least * judged - 1, of_kind


@pytest.mark.parametrize("topic", TOPICS)
def test_each_mistake_is_named_in_its_first_cases(topic):
    """Two of the first three, for the words of each cause to have been said at all."""
    found = load(topic)
    first = {}
    for case in found["cases"]:
        if case.get("cause") and " + " not in case["cause"]:
            first.setdefault(case["cause"].split(":")[0], []).append(case)
    for name, cases in first.items():
        told = (outcome(c, found["arms"], report(c, found["arms"])) for c in cases)
        shown = list(islice((how for how in told if how != "same arm"), 3))
        assert shown.count("named") >= len(shown) - 1 >= 0, (name, shown)


@pytest.mark.parametrize(("topic", "first"), [("branches", 156), ("pose", 250)])
def test_the_stored_corpus_is_what_its_seed_makes(topic, first):
    """All but most of the arms with six joints, whose branches are searched for, a second each."""
    stored, count = load(topic), TOPICS[topic][1]
    anew = corpus(topic, stored["seed"], first=first)
    assert json.loads(json.dumps(anew["cases"], default=as_plain_number)) == stored["cases"][:first]
    assert len(stored["cases"]) == count
