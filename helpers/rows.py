"""What a table is made of: rows and their joints, the bodies that they carry, the numbers of its
symbols."""

import math
import warnings
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace
from numbers import Real
from typing import Any, Literal, NamedTuple

from helpers.expressions import Entry, entry
from helpers.inputs import LARGEST, ArmError, floats, listed, one_of, shown

Kind = Literal["revolute", "prismatic", "fixed"]
KINDS = ("revolute", "prismatic", "fixed")


@dataclass(frozen=True)
class Joint:
    """What moves a row: its kind, range (rad or m), top speed (rad/s or m/s) and top effort (N m or
    N).

    A joint that was locked is fixed and remembers in `at` the value (rad or m) at which it is held.
    """

    kind: Kind = "revolute"
    lower: float = -math.inf
    upper: float = math.inf
    speed: float = math.inf
    effort: float = math.inf
    at: Entry | None = None

    def __post_init__(self) -> None:
        one_of(self.kind, "joint kind", KINDS)
        for name in ("lower", "upper", "speed", "effort"):
            object.__setattr__(self, name, real(getattr(self, name), f"joint {name}"))
        if not self.lower <= self.upper:
            raise ArmError(
                f"joint limits are ({self.lower:g}, {self.upper:g}); expected lower <= upper"
            )
        if not (self.speed > 0 and self.effort > 0):
            raise ArmError(
                f"joint speed and effort are {self.speed:g}, {self.effort:g}; expected both > 0"
            )
        if self.at is not None:
            if self.kind != "fixed":
                raise ArmError(f"joint at is {self.at!r}; expected None, for it is {self.kind}")
            object.__setattr__(self, "at", entry(self.at, "joint at"))


@dataclass(frozen=True)
class Row:
    """One row of the table; the joint variable is added to `theta` (revolute) or to `d`
    (prismatic)."""

    a: Entry = 0
    alpha: Entry = 0
    d: Entry = 0
    theta: Entry = 0
    joint: Joint = field(default_factory=Joint)

    def __post_init__(self) -> None:
        if not isinstance(self.joint, Joint):
            raise ArmError(
                f"joint is {self.joint!r}; expected a Joint,"
                " as revolute(), prismatic() or fixed() make"
            )
        for name in ("a", "alpha", "d", "theta"):
            object.__setattr__(self, name, entry(getattr(self, name), name))

    @property
    def entries(self) -> tuple[Entry, Entry, Entry, Entry]:
        """The four entries in the order a, alpha, d, theta."""
        return self.a, self.alpha, self.d, self.theta


def revolute(
    a: Entry = 0,
    alpha: Entry = 0,
    d: Entry = 0,
    theta: Entry = 0,
    *,
    limits: Sequence[float] = (-math.inf, math.inf),
    speed: float = math.inf,
    effort: float = math.inf,
) -> Row:
    """A row whose joint turns by q: the row's angle is q + `theta`. Limits in rad, rad/s, N m.

    Warns of an angle beyond a whole turn, which may be meant in degrees.
    """
    warn_of_degrees(alpha, theta)
    return Row(a, alpha, d, theta, _joint("revolute", limits, speed, effort))


def prismatic(
    a: Entry = 0,
    alpha: Entry = 0,
    d: Entry = 0,
    theta: Entry = 0,
    *,
    limits: Sequence[float] = (-math.inf, math.inf),
    speed: float = math.inf,
    effort: float = math.inf,
) -> Row:
    """A row whose joint slides by q: the row's offset is q + `d`. Limits in m, m/s, N.

    Warns of an angle beyond a whole turn, which may be meant in degrees.
    """
    warn_of_degrees(alpha, theta)
    return Row(a, alpha, d, theta, _joint("prismatic", limits, speed, effort))


def _joint(kind: Kind, limits: Sequence[float], speed: float, effort: float) -> Joint:
    return changed(Joint(kind), {"limits": limits, "speed": speed, "effort": effort})


def changed(joint: Joint, changes: Mapping[str, Any]) -> Joint:
    """The joint with those of `limits`, `speed` and `effort` that are among the changes."""
    fields = {name: changes[name] for name in ("speed", "effort") if name in changes}
    if "limits" in changes:
        wanted = "two numbers, lower and upper"
        if len(listed(changes["limits"], "joint limits", wanted)) != 2:
            raise ArmError(f"joint limits are {shown(changes['limits'])}; expected {wanted}")
        fields["lower"], fields["upper"] = changes["limits"]
    return replace(joint, **fields)


def fixed(a: Entry = 0, alpha: Entry = 0, d: Entry = 0, theta: Entry = 0) -> Row:
    """A row that does not move: a tool, a bracket, or a locked joint.

    Warns of an angle beyond a whole turn, which may be meant in degrees.
    """
    warn_of_degrees(alpha, theta)
    return Row(a, alpha, d, theta, Joint("fixed"))


def warn_of_degrees(*angles: Entry) -> None:
    """Warn whoever called the caller of a number for an angle that is more than a whole turn."""
    for angle in angles:
        if isinstance(angle, Real) and 2 * math.pi < abs(angle) <= LARGEST:
            warnings.warn(
                f"an angle is {angle:g}, in radians; for degrees write '{angle:g} deg'",
                stacklevel=3,
            )


@dataclass(frozen=True)
class Body:
    """The link that moves with a row: mass (kg) and centre of mass (m) in that row's own frame."""

    mass: Entry
    com: Sequence[Entry]

    def __post_init__(self) -> None:
        wanted = "three coordinates (x, y, z)"
        if len(listed(self.com, "the coordinates of the centre of mass", wanted)) != 3:
            raise ArmError(f"centre of mass is {self.com!r}; expected {wanted}")
        object.__setattr__(self, "mass", entry(self.mass, "mass"))
        object.__setattr__(self, "com", tuple(entry(c, "centre of mass") for c in self.com))


class Values(Mapping[str, float]):
    """The numbers of an arm's symbols (m, rad, kg), read as a dict is read, and never changed."""

    __slots__ = ("_numbers",)

    def __init__(self, numbers: Mapping[str, float], owner: str) -> None:
        wanted = "a number for each symbol, as in {'a_3': 0.0825}"
        try:
            given = dict[Any, Any](numbers)
        except (TypeError, ValueError):
            raise ArmError(f"{owner}: values are {shown(numbers)}; expected {wanted}") from None
        if not all(isinstance(name, str) for name in given):
            raise ArmError(f"{owner}: values are {shown(numbers)}; expected {wanted}")
        self._numbers = {str(k): real(v, f"{owner}: {k}") for k, v in given.items()}

    def __getitem__(self, name: str) -> float:
        return self._numbers[name]

    def __iter__(self) -> Iterator[str]:
        return iter(self._numbers)

    def __len__(self) -> int:
        return len(self._numbers)

    def __hash__(self) -> int:
        return hash(frozenset(self._numbers.items()))

    def __repr__(self) -> str:
        return repr(self._numbers)


class NumericRow(NamedTuple):
    """A row with its values put in; multiples of a right angle have exact sines and cosines."""

    kind: Kind
    a: float
    d: float
    cos_alpha: float
    sin_alpha: float
    theta: float
    cos_theta: float
    sin_theta: float


def real(value: object, what: str) -> float:
    """A real number, infinity and NaN among them."""
    found = floats(value, what, "a number")
    if found.shape:
        raise ArmError(f"{what} is {shown(value)}; expected a number")
    return float(found)


def cos_sin(angle: float) -> tuple[float, float]:
    """Cosine and sine, exact at multiples of a right angle so that structural zeros stay zero."""
    turns = quarter_turns(angle)
    if turns is None:
        return math.cos(angle), math.sin(angle)
    return ((1.0, 0.0), (0.0, 1.0), (-1.0, 0.0), (0.0, -1.0))[turns % 4]


def quarter_turns(angle: float) -> int | None:
    """How many right angles `angle` (rad) is, or None where it is no multiple of one."""
    turns = angle / (math.pi / 2)
    return round(turns) if abs(turns - round(turns)) < 1e-12 else None
