"""Define the verdict that every comparison returns, and its findings."""

import json
import re
from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Any

from helpers.checks.marked_text import MarkedText, make_marked_text
from helpers.checks.student_arm import JointMap

RIGHT, RIGHT_BY_MAP, WRONG = "right", "right by map", "wrong"
_MARKS = {RIGHT: "✔", RIGHT_BY_MAP: "✔", "so far": "◐", "rounded": "≈", WRONG: "✘"}


@dataclass(frozen=True)
class Finding:
    """An observation on an answer.

    Attributes:
        what: its kind: "cause" for an explanation of the whole answer; for a wrong part, "shape",
            "column", "row", "entry", "joint", "answer" or "step"; "found" and "missing" branches or
            rows; or the catalogue's key of a mistake in one place, such as "table.sign:a:3" or
            "trace.jump".
        where: the position, such as "joint 3", "row 2, alpha" or "answer 1"; empty for the
            whole answer.
        mine, expected: typed value and right value, if the sentence quotes them; None if that
            would give the solution away.
        words: the sentence.
    """

    what: str
    where: str
    mine: Any
    expected: Any
    words: str

    def __str__(self) -> str:
        return self.words


@dataclass(frozen=True)
class NumberRead:
    """A number of a pasted text and how it was used.

    Attributes:
        text: the number as typed, without its unit.
        owner: "entry" of the answer, "label" (a joint's number, a row's name, an index, a time),
            "header" of a column, "given" by the question itself, or "context" of any other kind.
        value: of an entry, with the unit or power of ten that stands beside it.
        row, column: the entry's position, counted from 0; a column of a table is one of
            a, alpha, d, theta in this order.
        line: the line of a number that is no entry, counted from 0.
        reason: why such a number was set aside.
    """

    text: str
    owner: str = "entry"
    value: float | None = None
    row: int | None = None
    column: int | None = None
    line: int | None = None
    reason: str = ""


@dataclass(frozen=True, repr=False)
class Verdict:
    """Result of a comparison, shown as text in a terminal and as Markdown in a notebook.

    Attributes:
        topic: "table", "Jacobian", "torques", "trace", "branches" or "pose".
        grade: "right", "so far", "rounded" or "wrong"; of a table also "right by map", if it
            describes the arm and its joints count otherwise than the reference's.
        headline: the result in one sentence, with the cause if one was found.
        findings: the cause first, then where it shows.
        causes: the catalogue's keys of the named causes, the likeliest first, two joined by " + ".
        taken: sentences on how the answer was read.
        advice: arguments to set if the answer was meant for another question.
        notes: remarks that are not mistakes.
        figures: measured numbers, by name, such as worst or position_error.
        read: the numbers of the answer with their owners, the entries first, row by row.
        mark: the grade whose mark is shown, if it differs.
        joint_map: how the joints of a table that is "right by map" count; else None.
        marked_text: the answer with its numbers marked, if it was a text; else None.
    """

    topic: str
    arm: str
    grade: str
    headline: str
    findings: tuple[Finding, ...] = ()
    causes: tuple[str, ...] = ()
    taken: tuple[str, ...] = ()
    advice: tuple[str, ...] = ()
    notes: tuple[str, ...] = ()
    figures: Mapping[str, Any] = field(default_factory=dict, compare=False)
    read: tuple[NumberRead, ...] = field(default=(), compare=False)
    mark: str = ""
    joint_map: JointMap | None = field(default=None, compare=False)
    marked_text: MarkedText | None = field(default=None, compare=False)

    @property
    def agrees(self) -> bool:
        """Return whether the answer is right and has enough digits to show it."""
        return self.grade in (RIGHT, RIGHT_BY_MAP)

    @property
    def lines(self) -> list[str]:
        """The sentences below the headline, without sentences that it repeats."""
        notes = [f"Note: {note}" for note in self.notes]
        symptoms = [f.words for f in self.findings if f.what != "cause"]
        symptoms = [words for words in symptoms if words[1:] not in self.headline]
        return [*symptoms, *(f"Taken as {t}" for t in self.taken), *notes, *self.advice]

    def __str__(self) -> str:
        moved = [self.joint_map.message] if self.joint_map else []
        return "\n".join([self.headline, *(f"- {line}" for line in [*moved, *self.lines])])

    __repr__ = __str__

    def _repr_markdown_(self) -> str:
        headline = f"{_MARKS[self.mark or self.grade]} **{self.headline}**"
        text = "\n".join([headline, "", *(f"- {line}" for line in self.lines)])
        joint_map = [self.joint_map.format_markdown()] if self.joint_map else []
        sentences = map(_typeset_joints, [text, *joint_map])
        return "\n\n".join([*sentences, *self._format_marks()])

    def _format_marks(self) -> list[str]:
        """Return the marked text as HTML if it explains more than the sentences do."""
        marked = self.marked_text
        if marked is None or (self.agrees and not marked.has_notable_marks):
            return []
        return list(filter(None, [marked.format_html()]))


def make_verdict(
    answer: Mapping[str, Any], joint_map: JointMap | None = None, **figures: Any
) -> Verdict:
    """Return the judge's answer as a verdict, with figures that Python computed."""
    return Verdict(
        answer["topic"],
        answer["arm"],
        answer["grade"],
        answer["headline"],
        tuple(map(_make_finding, answer["findings"])),
        tuple(answer["causes"]),
        tuple(answer["taken"]),
        tuple(map(format_advice, answer.get("advice", ()))),
        tuple(answer["notes"]),
        {name: _as_tuple(x) for name, x in answer.get("figures", {}).items()} | figures,
        tuple(NumberRead(**number) for number in answer.get("read", ())),
        answer.get("mark", ""),
        joint_map,
        make_marked_text(answer["marked"]) if "marked" in answer else None,
    )


def format_advice(advice: Mapping[str, Any]) -> str:
    """Return a piece of the judge's advice as a sentence that names Python's arguments."""
    field, value = advice["field"], advice["value"]
    if field == "ownJoints":
        return "The arm in your joints is report.joint_map.arm"
    words = {
        "arm": f"compare with robots.find_arm({json.dumps(value)})",
        "locked": f"compare with arm.lock({value})",
        "values": f"say values={{{json.dumps(value)}: ...}}",
        "which": f"say answer_number={value}",
        "angularFirst": f"say angular_first={bool(value)}",
    }
    setting = words.get(field, f"say {field}={json.dumps(value)}")
    return f"If that is what you mean, {setting}"


def _typeset_joints(markdown: str) -> str:
    """Return Markdown with q_1 as a formula, except in code, which quotes the student's text."""
    parts = re.split(r"(`[^`]*`)", markdown)
    return "".join(
        part if part.startswith("`") else re.sub(r"(?<![\w$])(-?q_)(\d+)\b", r"$\1{\2}$", part)
        for part in parts
    )


def _make_finding(finding: Mapping[str, Any]) -> Finding:
    mine, expected = (_as_tuple(finding.get(key)) for key in ("mine", "expected"))
    return Finding(finding["what"], finding["where"], mine, expected, finding["words"])


def _as_tuple(value: Any) -> Any:
    return tuple(value) if isinstance(value, list) else value
