"""Count damaged right answers that the judge calls right: ``python -m tests.measure.damage``.

A damage changes a right answer of tests/cases.json or tests/works in one place. A damaged answer
may be refused, wrong, or right so far; it may be called right only where its numbers are still
right.
"""

import argparse
import json
import random
import re
from collections import Counter
from collections.abc import Callable, Iterable, Iterator
from functools import cache
from pathlib import Path
from typing import NamedTuple

from helpers.checks import Verdict
from helpers.inputs import ArmError

CALLED_RIGHT = ("right", "right by map", "rounded")
LOOKALIKES = dict(zip("0123456789", "OlZEhSbTBg", strict=True))
# A unit in brackets or after "in". Other units may belong to other lengths in the prose.
STATED_UNIT = re.compile(r"(?:\bin |[(\[])(mm|cm|m|deg|degrees|rad|radians)(?![\w^*/])")
COMMENTED_ALTERNATIVE = re.compile(r"(#|%|//).* or 0\.4321")
OTHER_UNITS = {
    "mm": "cm", "cm": "mm", "m": "mm",
    "deg": "rad", "degrees": "radians", "rad": "deg", "radians": "degrees",
}  # fmt: skip


class Answer(NamedTuple):
    """A right answer, and how to judge a text in its place."""

    name: str
    text: str
    judge: Callable[[str], Verdict]


class Damage(NamedTuple):
    """A damaged answer, and what was damaged."""

    answer: Answer
    kind: str
    damaged: str
    text: str


def list_answers(works: bool = True) -> list[Answer]:
    """Return the right answers of the stored questions, and of the stored works if asked."""
    from tests.cases import QUESTIONS, typed_fields
    from tests.test_judge import judge_in_python

    def judge_question(fields: dict) -> Callable[[str], Verdict]:
        return lambda text: judge_in_python({**fields, "answer": text})

    answers = [
        Answer(case["about"], case["answer"], judge_question(typed_fields(case)))
        for case in QUESTIONS
        if case["grade"] == "right" and case["answer"] and "fails" not in case
    ]
    return answers + (_list_works() if works else [])


def _list_works() -> list[Answer]:
    from tests.measure.works import judge_work

    def judge_text(work: dict) -> Callable[[str], Verdict]:
        return lambda text: judge_work({**work, "text": text})

    files = sorted((Path(__file__).parents[1] / "works").glob("[ab]*.jsonl"))
    works = [json.loads(line) for file in files for line in file.open(encoding="utf-8")]
    return [
        Answer(work["id"], work["text"], judge_text(work))
        for work in works
        if work["truth"] == "right"
    ]


def judge(answer: Answer, text: str) -> Verdict | None:
    """Return the verdict on a text, or None if it is refused."""
    try:
        return answer.judge(text)
    except ArmError:
        return None


@cache
def find_entries(answer: Answer) -> list[tuple[int, int]]:
    """Return the spans of the numbers that the judge takes for the answer's entries."""
    verdict = judge(answer, answer.text)
    if verdict is None or verdict.grade not in CALLED_RIGHT or verdict.marked_text is None:
        return []
    spans, at = [], 0
    for piece in verdict.marked_text.pieces:
        if piece.kind == "entry":
            spans.append((at, at + len(piece.text)))
        at += len(piece.text)
    return spans


def _replace(text: str, span: tuple[int, int], new: str) -> str:
    return text[: span[0]] + new + text[span[1] :]


def _line_around(text: str, at: int) -> tuple[int, int]:
    end = text.find("\n", at)
    return text.rfind("\n", 0, at) + 1, len(text) if end < 0 else end


def _digit_to_letter(text, span, rng):
    digits = [k for k in range(*span) if text[k] in LOOKALIKES]
    if not digits:
        return None
    at = rng.choice(digits)
    return text[slice(*span)], _replace(text, (at, at + 1), LOOKALIKES[text[at]])


def _number_out(text, span, rng):
    return text[slice(*span)], _replace(text, span, "")


def _number_doubled(text, span, rng):
    number = text[slice(*span)]
    return number, _replace(text, span, f"{number} {number}")


def _line_out(text, span, rng):
    start, end = _line_around(text, span[0])
    return text[start:end], text[:start] + text[end + 1 :]


def _line_doubled(text, span, rng):
    start, end = _line_around(text, span[0])
    line = text[start:end]
    return line, _replace(text, (start, end), f"{line}\n{line}")


def _alternative_behind(text, span, rng):
    _, end = _line_around(text, span[0])
    return "or 0.4321", f"{text[:end]} or 0.4321{text[end:]}"


def _unit_changed(text, span, rng):
    units = list(STATED_UNIT.finditer(text))
    if not units:
        return None
    unit = rng.choice(units)
    return unit[0], _replace(text, unit.span(1), OTHER_UNITS[unit[1]])


KINDS = {
    "letter for a digit": _digit_to_letter,
    "number out": _number_out,
    "number doubled": _number_doubled,
    "line out": _line_out,
    "line doubled": _line_doubled,
    "alternative behind": _alternative_behind,
    "unit changed": _unit_changed,
}


def draw_damages(
    answers: list[Answer], seed: int, share: float, kinds: Iterable[str] = KINDS
) -> Iterator[Damage]:
    """Damage a share of the answers in each of the kinds.

    A draw depends on its own answer only, so that further answers do not change it.
    """
    for answer in answers:
        for kind in kinds:
            rng = random.Random(f"{seed} {kind} {answer.text}")
            if rng.random() >= share or not (entries := find_entries(answer)):
                continue
            changed = KINDS[kind](answer.text, rng.choice(entries), rng)
            if changed and changed[1] != answer.text:
                yield Damage(answer, kind, *changed)


def explain_right(damage: Damage) -> str:
    """Return why the numbers of a damaged answer are still right, or "" if they may be wrong."""
    numbers = re.findall(r"\d+", damage.damaged)
    if damage.kind == "line doubled" and len(numbers) > 1:
        return "the same answer, solution or definition twice"
    if damage.kind == "number out" and not any(map(int, numbers)):
        return "an empty cell is a zero"
    if damage.kind == "alternative behind" and COMMENTED_ALTERNATIVE.search(damage.text):
        return "a comment is no part of the answer"
    return ""


def main() -> None:
    """Read the command line, print counts and the damaged answers that are called right."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--seed", type=int, nargs="+", default=[1])
    parser.add_argument("--share", type=float, default=1, help="share of the answers, 0 to 1")
    parser.add_argument("--show", action="store_true", help="print each one that is called right")
    options = parser.parse_args()
    answers = list_answers()
    counts: Counter[tuple[str, str]] = Counter()
    for damage in (d for seed in options.seed for d in draw_damages(answers, seed, options.share)):
        verdict = judge(damage.answer, damage.text)
        grade = verdict.grade if verdict else "refused"
        if grade in CALLED_RIGHT:
            grade = "still right" if explain_right(damage) else "called right"
        counts[damage.kind, grade] += 1
        if options.show and grade == "called right":
            print(f"--- {damage.kind}: {damage.damaged!r} in {damage.answer.name}")
            print(f"{damage.text}\n=> {str(verdict)[:400]}\n")
    grades = sorted({grade for _, grade in counts})
    print("| damage | " + " | ".join(grades) + " |\n|:--" + "|--:" * len(grades) + "|")
    for kind in KINDS:
        print(f"| {kind} | " + " | ".join(str(counts[kind, grade]) for grade in grades) + " |")


if __name__ == "__main__":
    main()
