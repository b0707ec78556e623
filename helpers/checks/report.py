"""The one report of all comparisons, and the one kind of finding."""

import json
from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Any

RIGHT, WRONG = "right", "wrong"
_MARKS = {RIGHT: "✔", "so far": "◐", "rounded": "≈", WRONG: "✘"}


@dataclass(frozen=True)
class Finding:
    """One thing that is to be said of an answer.

    Attributes:
        what: its kind: "cause" for what explains the whole; of what is wrong, "shape", "column",
            "row", "joint", "answer" or "step"; "found" and "missing" branches or rows; or the
            catalogue's key of a mistake in one place, such as "J.column sign:2", "table.sign:a:3",
            "trace.jump" or "pose.entry".
        where: the place, such as "joint 3", "row 2, alpha" or "answer 1"; empty where it is the
            whole.
        mine, expected: what was typed and what it should be, where a sentence quotes them; None
            where it would give the solution away.
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
    """A number of a pasted text that was taken as an entry of the answer.

    Attributes:
        text: the number as typed, without its unit.
        value: its value, with the unit or power of ten that stands beside it.
        row, column: the entry's position, counted from 0; a column of a table is one of
            a, alpha, d, theta in this order.
    """

    text: str
    value: float
    row: int
    column: int


@dataclass(frozen=True, repr=False)
class Report:
    """What a comparison found. It reads as text in a terminal and as Markdown in a notebook.

    Attributes:
        topic: "table", "Jacobian", "torques", "trace", "branches" or "pose".
        grade: "right", "so far", "rounded" or "wrong".
        headline: the verdict in one sentence; the cause, where one was found.
        findings: the cause first, then where it shows.
        causes: the catalogue's keys of what was named, the likeliest first, two joined by " + ".
        taken: how the answer was read.
        advice: what to set, as an argument, where the answer is meant otherwise than asked.
        notes: what is no mistake and still worth knowing.
        figures: measured numbers, by name, such as worst or position_error.
        read: the numbers that were taken as entries of the answer, row by row.
        mark: the grade whose mark it is shown with, where that is another: "so far" for a right
            table with other zeros.
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

    @property
    def agrees(self) -> bool:
        """Whether it is right, with digits enough to tell."""
        return self.grade == RIGHT

    @property
    def lines(self) -> list[str]:
        """Everything below the headline, a sentence each; what stands in the headline is not
        repeated.
        """
        notes = [f"Note: {note}" for note in self.notes]
        symptoms = [f.words for f in self.findings if f.what != "cause"]
        symptoms = [words for words in symptoms if words[1:] not in self.headline]
        return [*symptoms, *(f"Taken as {t}" for t in self.taken), *notes, *self.advice]

    def __str__(self) -> str:
        return "\n".join([self.headline, *(f"- {line}" for line in self.lines)])

    __repr__ = __str__

    def _repr_markdown_(self) -> str:
        head = f"{_MARKS[self.mark or self.grade]} **{self.headline}**"
        return "\n".join([head, "", *(f"- {line}" for line in self.lines)])


def report_of(said: Mapping[str, Any], **figures: Any) -> Report:
    """The report that the judge's answer is, with figures of Python's own."""
    return Report(
        said["topic"],
        said["arm"],
        said["grade"],
        said["headline"],
        tuple(map(_finding, said["findings"])),
        tuple(said["causes"]),
        tuple(said["taken"]),
        tuple(map(advised, said.get("advice", ()))),
        tuple(said["notes"]),
        {name: _held(x) for name, x in said.get("figures", {}).items()} | figures,
        tuple(NumberRead(**number) for number in said.get("read", ())),
        said.get("mark", ""),
    )


def advised(said: Mapping[str, Any]) -> str:
    """A piece of the judge's advice, a field of the question and its value, in Python's words."""
    field, value = said["field"], said["value"]
    if field == "ownJoints":
        return 'The arm in your joints is report.figures["arm"]'
    words = {
        "arm": f"compare with robots.find_arm({json.dumps(value)})",
        "locked": f"compare with arm.lock({value})",
        "values": f"say values={{{json.dumps(value)}: ...}}",
        "angularFirst": f"say angular_first={bool(value)}",
    }
    setting = words.get(field, f"say {field}={json.dumps(value)}")
    return f"If that is what you mean, {setting}"


def _finding(said: Mapping[str, Any]) -> Finding:
    mine, expected = (_held(said.get(key)) for key in ("mine", "expected"))
    return Finding(said["what"], said["where"], mine, expected, said["words"])


def _held(value: Any) -> Any:
    return tuple(value) if isinstance(value, list) else value
