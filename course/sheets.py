"""Draw homework with individual numbers, write its questions, and compute its answer key.

A seed draws plain numbers. An arm and those numbers make a text and its key, so that exactly the
printed numbers are judged. A sheet keeps what was drawn.
"""

import hashlib
from collections.abc import Iterable, Mapping
from dataclasses import dataclass, replace
from functools import cached_property

import numpy as np

from course.topics import (
    TOPIC_BY_NAME,
    Numbers,
    Part,
    Rng,
    draw_numbers,
    find_missing_property,
    write_question,
)
from helpers.arm import Arm, Body
from helpers.inputs import ArmError, require_choice, require_type, tuple_of_items, whole_number

TOPICS = tuple(TOPIC_BY_NAME)
# How the text of a question names the pieces that are marked separately, by kind of part.
_MARKED_PIECES = {
    "rotation": "each column counts",
    "jacobian": "each column counts by halves, linear and angular",
    "column": "the linear and the angular half count",
    "branches": "each row counts",
} | dict.fromkeys(("table", "pose"), "they count as a whole")


@dataclass(frozen=True, repr=False)
class Question:
    """A topic of the homework with its drawn numbers, its text and its answer key."""

    topic: str
    arm: Arm
    numbers: Numbers
    text: str
    parts: tuple[Part, ...]

    @property
    def markdown(self) -> str:
        """The question and the names of its answers."""
        title = self.topic[0].upper() + self.topic[1:]
        names = [f"- `{p.name}`: {p.description}; {_describe_marking(p)}" for p in self.parts]
        return "\n".join([f"## {title}", "", self.text, "", *names])

    def __repr__(self) -> str:
        return f"<Question on {self.topic}: {self.arm.name}>"

    def _repr_markdown_(self) -> str:
        table = "" if self.topic == "DH table" else f"\n\n{self.arm._repr_markdown_()}"
        return f"{self.markdown}{table}"


@dataclass(frozen=True)
class Exercise:
    """An arm, before lengths are drawn, and the topics of its questions."""

    arm: Arm
    topics: tuple[str, ...]


@dataclass(frozen=True)
class Section:
    """The questions of a student about an arm with the student's lengths.

    `suffix` ends the names of its parts: "" for a sheet's first arm, "_2" for the second.
    """

    arm: Arm
    drawn: Mapping[str, Numbers]
    suffix: str = ""

    @cached_property
    def questions(self) -> tuple[Question, ...]:
        """The questions, in the order of the topics."""
        questions = [make_question(topic, self.arm, x) for topic, x in self.drawn.items()]
        return tuple(
            replace(q, parts=tuple(replace(p, name=p.name + self.suffix) for p in q.parts))
            for q in questions
        )


@dataclass(frozen=True)
class Sheet:
    """All questions of a student, in a section for each arm."""

    sections: tuple[Section, ...]

    @property
    def questions(self) -> tuple[Question, ...]:
        """The questions of all sections."""
        return tuple(question for section in self.sections for question in section.questions)

    @property
    def parts(self) -> dict[str, Part]:
        """Every part of the sheet by its name."""
        return {part.name: part for question in self.questions for part in question.parts}


def draw_sheet(arm: Arm, seed: int | str, topics: tuple[str, ...] | None = None) -> Sheet:
    """Draw a sheet about an arm from a seed.

    The same seed draws the same sheet.

    Args:
        arm: Arm whose lengths are changed.
        seed: Any text or whole number.
        topics: Topics to ask, those that suit the arm unless given.

    Raises ArmError for an unknown topic, for one that does not suit the arm, and if no
    configuration is found that is away from singular ones and at which every mistake shows.
    """
    require_type(arm, Arm, "arm")
    if topics is None:
        topics = list_suitable_topics(arm)
    for topic in tuple_of_items(topics, "topics", f"some of {', '.join(TOPICS)}"):
        if lacking := find_missing_property(require_choice(topic, "topic", TOPICS), arm):
            raise ArmError(f"{arm.name} does not suit {topic}; it needs {lacking}")
    own_arm = _draw_lengths(arm, seed)
    drawn = {topic: draw_numbers(topic, own_arm, _make_generator(seed, topic)) for topic in topics}
    return Sheet((Section(own_arm, drawn),))


def draw_question(topic: str, arm: Arm, seed: int | str) -> Question:
    """Draw a topic's question about an arm with drawn lengths."""
    return draw_sheet(arm, seed, (topic,)).questions[0]


def make_question(topic: str, arm: Arm, numbers: Numbers) -> Question:
    """Make the question and its key from an arm and drawn numbers."""
    return Question(topic, arm, numbers, *write_question(topic, arm, numbers))


def _describe_marking(part: Part) -> str:
    """Describe how many decimals are asked, and which pieces of an answer earn credit."""
    pieces = _MARKED_PIECES.get(part.kind, "each number counts")
    return pieces if part.kind in ("column", "table") else f"{part.digits} decimals; {pieces}"


def make_suffix(index: int) -> str:
    """Return the suffix of the names of parts about the sheet's arm with this index."""
    return f"_{index + 1}" if index else ""


def list_part_names(exercises: Iterable[Exercise]) -> list[str]:
    """List the names of all parts of some exercises."""
    return [
        name + make_suffix(index)
        for index, exercise in enumerate(exercises)
        for topic in exercise.topics
        for name in TOPIC_BY_NAME[topic].parts
    ]


def list_suitable_topics(arm: Arm) -> tuple[str, ...]:
    """List the topics that can be asked about an arm."""
    return tuple(topic for topic in TOPICS if not find_missing_property(topic, arm))


def _make_generator(seed: int | str, label: str) -> Rng:
    """Make a random generator from the bytes of a seed and a label."""
    if not isinstance(seed, str):
        seed = str(whole_number(seed, "seed"))
    digest = hashlib.sha256(f"{label}\n{seed}".encode()).digest()
    return np.random.default_rng(list(digest))


def _draw_lengths(arm: Arm, seed: int | str) -> Arm:
    """Change every value of an arm by up to a tenth, to three decimals."""
    factors = _make_generator(seed, "lengths").uniform(0.9, 1.1, len(arm.values))
    pairs = zip(arm.values.items(), factors, strict=True)
    new = {name: round(value * float(factor), 3) for (name, value), factor in pairs}
    return change_lengths(replace(arm, name=f"{arm.name}, lengths of your own"), new)


def change_lengths(arm: Arm, values: Mapping[str, float]) -> Arm:
    """Return an arm with new values, and with bodies rounded to the six decimals of a sheet."""
    arm = arm.with_values(**values)
    bodies = [[round(arm.number(x), 6) + 0.0 for x in (b.mass, *b.com)] for b in arm.bodies]
    return arm.with_bodies([Body(mass, com) for mass, *com in bodies])
