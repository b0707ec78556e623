"""What is typed and what comes of it: tests/cases.json, which Python, Node and the browser read.

`entries` are texts in a field: the quantity and unit it is for, and the value, null where it is
refused. `questions` are those of the page, in its own fields: what they are `about`, and the
`grade` (or "refused"), a `cause` among those named ("" for none), and words that are `said`, or
`unsaid`. Their right numbers are those of `helpers`, of tests/corpus or by hand, none of `judge/`.
"""

import json
from pathlib import Path

_HELD = json.loads(Path(__file__).with_name("cases.json").read_text(encoding="utf-8"))
ENTRIES, QUESTIONS = _HELD["entries"], _HELD["questions"]
_OUTCOME = ("about", "grade", "cause", "said", "unsaid")


def fields(case: dict) -> dict:
    """What is typed."""
    return {key: text for key, text in case.items() if key not in _OUTCOME}


def about(what: str) -> list[dict]:
    return [case for case in QUESTIONS if case["about"].startswith(what)]
