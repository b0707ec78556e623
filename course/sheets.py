"""Homework with numbers of its own: what is drawn, how it is asked, and the key to it.

A seed draws plain numbers; an arm and those numbers make a text and its key, so that exactly the
numbers that the text prints are judged. A sheet keeps what was drawn.
"""

import hashlib
from collections.abc import Mapping
from dataclasses import dataclass, replace
from functools import cached_property

import numpy as np

from course.topics import (
    BY_NAME,
    Numbers,
    Part,
    Rng,
    draw_numbers,
    find_missing_property,
    make_question,
)
from helpers.arm import Arm, Body
from helpers.inputs import ArmError, require_choice, require_type, tuple_of_items, whole_number

__all__ = ["TOPICS", "Part", "Question", "Sheet", "sheet", "variant"]

TOPICS = tuple(BY_NAME)
# The pieces of a part that count by themselves, by its kind.
_COUNTS = {
    "numbers": "each number counts",
    "rotation": "each column counts",
    "jacobian": "each column counts by halves, linear and angular",
    "column": "the linear and the angular half count",
    "torques": "each number counts",
    "table": "they count as a whole",
    "branches": "each row counts",
    "pose": "they count as a whole",
}


@dataclass(frozen=True, repr=False)
class Question:
    """One topic of the homework with numbers of its own: what was drawn, the text and the key."""

    topic: str
    arm: Arm
    numbers: Numbers
    text: str
    parts: tuple[Part, ...]

    @property
    def markdown(self) -> str:
        """The question and the names to answer by."""
        title = self.topic[0].upper() + self.topic[1:]
        names = [f"- `{p.name}`: {p.what}; {_asked(p)}" for p in self.parts]
        return "\n".join([f"## {title}", "", self.text, "", *names])

    def __repr__(self) -> str:
        return f"<Question on {self.topic}: {self.arm.name}>"

    def _repr_markdown_(self) -> str:
        table = "" if self.topic == "DH table" else f"\n\n{self.arm._repr_markdown_()}"
        return f"{self.markdown}{table}"


@dataclass(frozen=True)
class Sheet:
    """All questions of one student about one arm, whose lengths are the student's own."""

    arm: Arm
    drawn: Mapping[str, Numbers]

    @cached_property
    def questions(self) -> tuple[Question, ...]:
        """The questions, in the order of the topics."""
        return tuple(question(topic, self.arm, given) for topic, given in self.drawn.items())

    @property
    def parts(self) -> dict[str, Part]:
        """Every part of the sheet by its name."""
        return {part.name: part for question in self.questions for part in question.parts}


def sheet(arm: Arm, seed: int | str, topics: tuple[str, ...] | None = None) -> Sheet:
    """The sheet that a seed draws: a word or a number; the same seed draws the same sheet.

    `topics` are those that suit the arm unless given. Raises ArmError for an unknown topic, for one
    that does not suit the arm, and for an arm of which no pose can be found away from singular ones
    at which every slip shows.
    """
    require_type(arm, Arm, "arm")
    if topics is None:
        topics = suiting(arm)
    for topic in tuple_of_items(topics, "topics", f"some of {', '.join(TOPICS)}"):
        if lacking := find_missing_property(require_choice(topic, "topic", TOPICS), arm):
            raise ArmError(f"{arm.name} does not suit {topic}; it needs {lacking}")
    own = _with_other_lengths(arm, seed)
    return Sheet(
        own, {topic: draw_numbers(topic, own, _generator(seed, topic)) for topic in topics}
    )


def variant(topic: str, arm: Arm, seed: int | str) -> Question:
    """A topic's question about an arm with other lengths, as a seed draws them."""
    return sheet(arm, seed, (topic,)).questions[0]


def question(topic: str, arm: Arm, numbers: Numbers) -> Question:
    """The question and its key from an arm and the numbers that were drawn."""
    return Question(topic, arm, numbers, *make_question(topic, arm, numbers))


def _asked(part: Part) -> str:
    """How many decimals are asked, and what of an answer counts."""
    if part.kind in ("column", "table"):
        return _COUNTS[part.kind]
    return f"{part.digits} decimals; {_COUNTS[part.kind]}"


def suiting(arm: Arm) -> tuple[str, ...]:
    """The topics that can be asked about an arm."""
    return tuple(topic for topic in TOPICS if not find_missing_property(topic, arm))


def _generator(seed: int | str, label: str) -> Rng:
    """A generator of its own for each label, from the bytes of the seed."""
    if not isinstance(seed, str):
        seed = str(whole_number(seed, "seed"))
    digest = hashlib.sha256(f"{label}\n{seed}".encode()).digest()
    return np.random.default_rng(list(digest))


def _with_other_lengths(arm: Arm, seed: int | str) -> Arm:
    """The arm with every value within a tenth of its own, to three decimals."""
    factors = _generator(seed, "lengths").uniform(0.9, 1.1, len(arm.values))
    pairs = zip(arm.values.items(), factors, strict=True)
    new = {name: round(value * float(factor), 3) for (name, value), factor in pairs}
    return with_lengths(replace(arm, name=f"{arm.name}, lengths of your own"), new)


def with_lengths(arm: Arm, values: Mapping[str, float]) -> Arm:
    """An arm with other values, and bodies of just the six decimals that a sheet prints."""
    arm = arm.with_values(**values)
    bodies = [[round(arm.number(x), 6) + 0.0 for x in (b.mass, *b.com)] for b in arm.bodies]
    return arm.with_bodies([Body(mass, com) for mass, *com in bodies])
