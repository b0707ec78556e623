"""Which mistakes explain an answer, the simplest and likeliest first.

Each hypothesis is what an answer would be with one mistake, or two. It gains an entry where it
explains a wrong one and loses one where it spoils a right one; it is named if it explains all, at
least an entry for each mistake, or gains at least three and most of what is wrong.
"""

from collections.abc import Sequence
from dataclasses import dataclass, field
from typing import Any, TypeGuard

import numpy as np
from numpy.typing import NDArray

from helpers.reading.sentences import listed, say

Array = NDArray[Any]

SHARE = 0.6  # of the wrong entries that a single mistake must gain
PAIR_SHARE = 0.85
ODD = 0.7  # what an entry that stays unexplained weighs against a second mistake


@dataclass(frozen=True)
class Cause:
    """One mistake or two: their keys in the file of sentences, with the fields of each."""

    keys: tuple[str, ...]
    fields: tuple[dict, ...] = field(default=())

    @property
    def name(self) -> str:
        """How reports and the corpus call it, as ``J.frame:3 + J.millimetres``."""
        return " + ".join(_name(k, f) for k, f in zip(self.keys, self.fields, strict=True))

    @property
    def words(self) -> str:
        """What it says, without a full stop."""
        said = [say(k, **f) for k, f in zip(self.keys, self.fields, strict=True)]
        return said[0] if len(said) == 1 else say("and also", first=said[0], second=lower(said[1]))

    def __add__(self, other: "Cause") -> "Cause":
        return Cause(self.keys + other.keys, self.fields + other.fields)


def cause(key: str, **fields: object) -> Cause:
    """A single mistake."""
    return Cause((key,), (fields,))


class Pairs(Sequence[Cause]):
    """Thousands of pairs of causes, each put together only when it is asked for."""

    def __init__(self, both: Sequence[tuple[Cause, Cause]]) -> None:
        self.both = both
        self.edits = np.full(len(both), 2)

    def __len__(self) -> int:
        return len(self.both)

    def __getitem__(self, k: Any) -> Any:
        first, second = self.both[k]
        return first + second


def _name(key: str, fields: dict) -> str:
    if "_of" in fields:
        return fields["_of"]
    return ":".join([key, *(str(v) for k, v in fields.items() if not k.startswith("_"))])


def lower(sentence: str) -> str:
    """A sentence to stand inside another; a name such as N mm, q_1 or A_i keeps its capital."""
    keeps = sentence[1:2].isupper() or sentence[1:2] == "_"
    return sentence if keeps else sentence[0].lower() + sentence[1:]


@dataclass(frozen=True)
class Found:
    """Causes that explain an answer, best first, the entries that the best leaves unexplained, and
    what each entry is off by from what the best gives.
    """

    causes: tuple[Cause, ...]
    odd: NDArray[np.bool_]
    rest: Array


def explain(
    mine: Array,
    right: Array,
    band: Array,
    causes: Sequence[Cause],
    made: Array,
    odd: float = ODD,
) -> Found | None:
    """The causes whose answers `made`, shape (causes, *mine.shape), explain mine within the band;
    None where none does.
    """
    axes = tuple(range(1, made.ndim))
    wrong = np.abs(mine - right) > band
    fits = np.abs(mine - made) <= band
    left = (~fits).sum(axes)
    gained = wrong.sum() - left  # what it explains of the wrong ones, less what it spoils
    edits = causes.edits if isinstance(causes, Pairs) else np.array([len(c.keys) for c in causes])
    least = np.where(
        edits > 1, np.maximum(4, PAIR_SHARE * wrong.sum()), np.maximum(3, SHARE * wrong.sum())
    )
    named = np.flatnonzero(((left == 0) & (wrong.sum() >= edits)) | (gained >= least))
    if not named.size:
        return None
    cost = edits + odd * left
    best = named[cost[named] == cost[named].min()]
    return Found(tuple(causes[int(k)] for k in best), ~fits[best[0]], mine - made[best[0]])


def complete(found: Found | None) -> TypeGuard[Found]:
    """Whether something is found that leaves nothing unexplained."""
    return found is not None and not found.odd.any()


def several(found: Sequence[Cause], most: int = 3) -> str:
    """What the causes say: single ones that explain equally well one after another, of pairs the
    first.
    """
    words = list(dict.fromkeys(c.words for c in found))[: most if len(found[0].keys) == 1 else 1]
    return (
        words[0]
        if len(words) == 1
        else say("or", first=words[0], others=listed([lower(w) for w in words[1:]], "or"))
    )


def better(*all_found: Found | None, odd: float = ODD) -> Found | None:
    """The one with the least cost: each mistake costs 1, each entry that stays unexplained 0.7."""
    there = [f for f in all_found if f]
    return min(there, key=lambda f: len(f.causes[0].keys) + odd * int(f.odd.sum()), default=None)
