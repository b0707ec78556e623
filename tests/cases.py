"""Read tests/cases.json, the typed texts and expected results that all test runners share.

Python, Node and the browser tests read the same file. It holds each layout, spelling, header, unit
and notation of NumPy, MATLAB, LaTeX, spreadsheets and people once. A case that fails has the reason
under `fails`; one that must be refused has a part of the message under `refused`.

| list | a case |
|:--|:--|
| `entries` | the quantity and unit of a field, and the `value`, or null if it is rejected |
| `formulas` | the `value` at x = 0.7 and q_1 = 0.4 |
| `numbers` | the `value` of a formula without symbols, or null |
| `symbols` | the `names` in a formula, or null |
| `decimals` | the `round_off` of a formula by its typed decimals, at x = 3 |
| `matrices` | the `rows` of numbers, and the `units` of their last typed places |
| `vectors` | the joint `values` of each answer for joints of these `kinds`, null if refused |
| `definitions` | the `lengths` that a text defines, in m |
| `units` | the unit of `angles`, `lengths` or `moments` that a text names for all its numbers |
| `tables` | the `rows` as kind of joint (R, P or F), a, alpha, d and theta, in m and degrees, and
  the `options` of reading; if the order of its columns is `guessed`, one reading has these rows |
| `questions` | the fields of the judge's form, the topic (`about`), the `grade` (or "refused"), the
  `cause` ("" for none), and parts of the message that must appear (`said`) or must not (`unsaid`) |
| `pasted` | the rows that the form, the explorer, `Arm.from_table` and `compare_tables` read, which
  agrees with a `reference` of other rows within the typed digits; without rows all of them ask |
| `compared` | a table in m and rad, the `reference` table (or `arm`) beside it, and the verdict's
  `grade`, `causes`, `headline`, `findings` with their places (`where`), other lines (`said`), and
  whether both are the `same_machine` |
| `own` | a table that `Arm.from_table` reads: its `rows` (a, alpha, d, theta), words of
  the `source`, and patterns of all its `warnings` |
| `public` | a published table with its rows in the standard convention, or a Jacobian |

The right numbers come from `helpers`, from tests/corpus or from a calculation by hand, never from
`judge/`.
"""

import json
from pathlib import Path

import pytest

_CASES = json.loads(Path(__file__).with_name("cases.json").read_text(encoding="utf-8"))
ENTRIES, QUESTIONS = _CASES["entries"], _CASES["questions"]
FORMULAS, MATRICES, TABLES = _CASES["formulas"], _CASES["matrices"], _CASES["tables"]
PASTED_TABLES, PUBLIC = _CASES["pasted"], _CASES["public"]
COMPARED_TABLES, OWN_TABLES = _CASES["compared"], _CASES["own"]
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
    """Return the fields that the student fills in, without the expected result."""
    return {key: text for key, text in case.items() if key not in _EXPECTED}


def questions_about(topic: str) -> list[dict]:
    """Return the questions whose topic begins with these words."""
    return [case for case in QUESTIONS if case["about"].startswith(topic)]
