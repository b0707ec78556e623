"""Read tests/cases.json, the typed texts and expected results that all test runners share.

Python, Node and the browser tests read the same file. Each of its `entries` is a text for one
field: the quantity and unit of that field, and the expected value, or null if the text is rejected.
Each of its `formulas` has its value at x = 0.7 and q_1 = 0.4, each of its `matrices` its rows of
numbers. Each of its `tables` has its rows as kind of joint (R, P or F), a, alpha, d and theta, in m
and degrees, and the `options` that say how it is read; where the order of its columns is `guessed`,
one of the readings has these rows. The three hold each layout, spelling, header, unit and notation
of NumPy, MATLAB, LaTeX, spreadsheets and people once. Each of its `questions` fills the fields of
the judge's page. It also has a topic (`about`), the expected `grade` (or "refused"), the expected
`cause` ("" for none), and parts of the message that must appear (`said`) or must not (`unsaid`).
The right numbers come from `helpers`, from tests/corpus or from a calculation by hand, never from
`judge/`. Each of the tables `pasted` is read as its rows by the form, the explorer,
`Arm.from_table` and `compare_tables`, which agrees with a `reference` of other rows within the
typed digits; one without rows is read by none of them without a question. Each case of `public` is
a table or a Jacobian that somebody published, with the rows in the standard convention or what its
verdict says; `refused` is what a refusal quotes instead. A case that fails has the reason under
`fails`.
"""

import json
from pathlib import Path

import pytest

_CASES = json.loads(Path(__file__).with_name("cases.json").read_text(encoding="utf-8"))
ENTRIES, QUESTIONS = _CASES["entries"], _CASES["questions"]
FORMULAS, MATRICES, TABLES = _CASES["formulas"], _CASES["matrices"], _CASES["tables"]
PASTED_TABLES, PUBLIC = _CASES["pasted"], _CASES["public"]
_EXPECTED = ("about", "grade", "cause", "said", "unsaid", "fails")


def expect_failures(cases: list[dict]) -> list:
    """Return the cases as parameters of a test that must fail for those with the field `fails`."""
    return [
        pytest.param(case, marks=pytest.mark.xfail(strict=True, reason=case["fails"]))
        if "fails" in case
        else case
        for case in cases
    ]


def typed_fields(case: dict) -> dict:
    """Return the typed_fields that the student fills in, without the expected result."""
    return {key: text for key, text in case.items() if key not in _EXPECTED}


def questions_about(topic: str) -> list[dict]:
    """Return the questions whose topic begins with these words."""
    return [case for case in QUESTIONS if case["about"].startswith(topic)]
