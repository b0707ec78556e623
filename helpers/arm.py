"""An arm is a value: an immutable, hashable table of Denavit-Hartenberg rows.

Rows follow the standard ("distal") convention of Spong, Hutchinson and Vidyasagar, *Robot Modeling and
Control*, section 3.2: ``A = Rot_z(theta) Trans_z(d) Trans_x(a) Rot_x(alpha)``, joint *i* moving about or
along ``z_{i-1}``. Lengths are in metres, angles in radians. Entries are symbols to read (``a_3``) with
values to run, and exact angles (``pi/2``).
"""

import math
from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from functools import cached_property
from typing import Literal, NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from helpers.expressions import Entry, entry, evaluate, latex, names
from helpers.inputs import ArmError, listed, must_be, numbers, one_of, shown

__all__ = ["Arm", "ArmError", "Body", "Joint", "Row", "fixed", "prismatic", "revolute"]

Kind = Literal["revolute", "prismatic", "fixed"]
_KINDS = ("revolute", "prismatic", "fixed")


@dataclass(frozen=True)
class Joint:
    """What moves a row: its kind, range (rad or m), top speed (rad/s or m/s) and top effort (N m or N)."""

    kind: Kind = "revolute"
    lower: float = -math.inf
    upper: float = math.inf
    speed: float = math.inf
    effort: float = math.inf

    def __post_init__(self) -> None:
        one_of(self.kind, "joint kind", _KINDS)
        for name in ("lower", "upper", "speed", "effort"):
            object.__setattr__(self, name, _number(getattr(self, name), f"joint {name}"))
        if not self.lower <= self.upper:
            raise ArmError(
                f"joint limits are ({self.lower:g}, {self.upper:g}); expected lower <= upper"
            )
        if not (self.speed > 0 and self.effort > 0):
            raise ArmError(
                f"joint speed and effort are {self.speed:g}, {self.effort:g}; expected both > 0"
            )


@dataclass(frozen=True)
class Row:
    """One row of the table; the joint variable is added to `theta` (revolute) or to `d` (prismatic)."""

    a: Entry = 0
    alpha: Entry = 0
    d: Entry = 0
    theta: Entry = 0
    joint: Joint = field(default_factory=Joint)

    def __post_init__(self) -> None:
        if not isinstance(self.joint, Joint):
            raise ArmError(
                f"joint is {self.joint!r}; expected a Joint, as revolute(), prismatic() or fixed() make"
            )
        for name in ("a", "alpha", "d", "theta"):
            object.__setattr__(self, name, entry(getattr(self, name), name))


def revolute(
    a=0, alpha=0, d=0, theta=0, *, limits=(-math.inf, math.inf), speed=math.inf, effort=math.inf
) -> Row:
    """A row whose joint turns by q: the row's angle is q + `theta`. Limits in rad, rad/s, N m."""
    return Row(a, alpha, d, theta, _joint("revolute", limits, speed, effort))


def prismatic(
    a=0, alpha=0, d=0, theta=0, *, limits=(-math.inf, math.inf), speed=math.inf, effort=math.inf
) -> Row:
    """A row whose joint slides by q: the row's offset is q + `d`. Limits in m, m/s, N."""
    return Row(a, alpha, d, theta, _joint("prismatic", limits, speed, effort))


def _joint(kind: Kind, limits: tuple[float, float], speed: float, effort: float) -> Joint:
    wanted = "two numbers, lower and upper"
    if len(listed(limits, "joint limits", wanted)) != 2:
        raise ArmError(f"joint limits are {shown(limits)}; expected {wanted}")
    return Joint(kind, *limits, speed, effort)


def fixed(a=0, alpha=0, d=0, theta=0) -> Row:
    """A row that does not move: a tool, a bracket, or a locked joint."""
    return Row(a, alpha, d, theta, Joint("fixed"))


@dataclass(frozen=True)
class Body:
    """The link that moves with a row: its mass (kg) and its centre of mass (m) in that row's own frame."""

    mass: Entry
    com: tuple[Entry, Entry, Entry]

    def __post_init__(self) -> None:
        wanted = "three coordinates (x, y, z)"
        if len(listed(self.com, "the coordinates of the centre of mass", wanted)) != 3:
            raise ArmError(f"centre of mass is {self.com!r}; expected {wanted}")
        object.__setattr__(self, "mass", entry(self.mass, "mass"))
        object.__setattr__(self, "com", tuple(entry(c, "centre of mass") for c in self.com))


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


@dataclass(frozen=True)
class Arm:
    """A serial arm in standard Denavit-Hartenberg form.

    Args:
        name: what to call it in messages and figures.
        rows: one `Row` per link, base to tip.
        values: a number for every symbol in the rows and bodies (m, rad, kg).
        bodies: one `Body` per row, or none where masses are unknown.
        home: a joint vector of shape (dof,) to draw and start from; zeros unless given.
        source: where the numbers come from.

    Raises:
        ArmError: an entry is no number or formula, a symbol has no value, or a count does not fit.
    """

    name: str
    rows: tuple[Row, ...]
    values: tuple[tuple[str, float], ...] = ()
    bodies: tuple[Body, ...] = ()
    home: tuple[float, ...] = ()
    source: str = ""

    def __post_init__(self) -> None:
        must_be(self.name, str, "an arm's name")
        rows = listed(self.rows, f"{self.name}: rows", "one Row or more")
        bodies = listed(self.bodies, f"{self.name}: bodies", "one Body for each row")
        self._put(rows=rows, bodies=bodies)
        if not self.rows or not all(isinstance(row, Row) for row in self.rows):
            raise ArmError(f"{self.name}: rows are {self.rows!r}; expected one Row or more")
        values = _pairs(self.values, f"{self.name}: values")
        self._put(values=tuple((k, _number(v, f"{self.name}: {k}")) for k, v in values))
        home = listed(self.home, f"{self.name}: the values of home", f"{self.dof} joint values")
        home = tuple(_number(x, f"{self.name}: home") for x in home)
        self._put(home=home or (0.0,) * self.dof)
        self._check()

    def _put(self, **fields: object) -> None:
        for name, value in fields.items():
            object.__setattr__(self, name, value)

    def _check(self) -> None:
        self._check_bodies()
        self._check_symbols()
        for formula in self._entries():
            self._check_finite(formula)
        self.joint_vector(self.home)

    def _check_bodies(self) -> None:
        if not all(isinstance(body, Body) for body in self.bodies):
            raise ArmError(
                f"{self.name}: bodies are {self.bodies!r}; expected one Body for each row"
            )
        if self.bodies and len(self.bodies) != len(self.rows):
            raise ArmError(
                f"{self.name}: {len(self.bodies)} bodies for {len(self.rows)} rows; expected one each"
            )

    def _check_symbols(self) -> None:
        needed = {name for formula in self._entries() for name in names(formula)}
        if taken := sorted(needed & set(self.variables)):
            raise ArmError(
                f"{self.name}: {taken[0]} is the variable of a joint; call the symbol something else"
            )
        if missing := sorted(needed - {name for name, _ in self.values}):
            raise ArmError(
                f"{self.name}: no value for {', '.join(missing)}; give values={{{missing[0]!r}: ...}}"
            )
        for name, value in self.values:
            if not math.isfinite(value):
                raise ArmError(f"{self.name}: {name} is {value}; expected a finite number")

    def _check_finite(self, formula: Entry) -> None:
        try:
            self.number(formula)
        except ArmError:
            raise ArmError(
                f"{self.name}: {formula} divides by zero or is too large; give it other values"
            ) from None

    def _entries(self) -> list[Entry]:
        table = [e for row in self.rows for e in (row.a, row.alpha, row.d, row.theta)]
        return table + [e for body in self.bodies for e in (body.mass, *body.com)]

    # What it is

    @cached_property
    def joints(self) -> tuple[int, ...]:
        """The numbers, counted from 1, of the rows that move."""
        return tuple(i for i, row in enumerate(self.rows, 1) if row.joint.kind != "fixed")

    @property
    def dof(self) -> int:
        """How many joints move."""
        return len(self.joints)

    @property
    def variables(self) -> tuple[str, ...]:
        """The joint variables, named by row, as ``('q_1', 'q_2', 'q_4', ...)`` where joint 3 is locked."""
        return tuple(f"q_{i}" for i in self.joints)

    @property
    def turning(self) -> NDArray[np.bool_]:
        """Which of the joints turn, shape (dof,); the others slide."""
        return np.array([self.rows[i - 1].joint.kind == "revolute" for i in self.joints], bool)

    @property
    def limits(self) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
        """Lower and upper joint limits, each of shape (dof,), in rad or m; infinite where unknown."""
        return self._joint_array("lower"), self._joint_array("upper")

    @property
    def speed_limits(self) -> NDArray[np.float64]:
        """Top joint speeds, shape (dof,), in rad/s or m/s; infinite where unknown."""
        return self._joint_array("speed")

    @property
    def effort_limits(self) -> NDArray[np.float64]:
        """Top joint torques or forces, shape (dof,), in N m or N; infinite where unknown."""
        return self._joint_array("effort")

    def _joint_array(self, name: str) -> NDArray[np.float64]:
        return np.array([getattr(self.rows[i - 1].joint, name) for i in self.joints])

    # The same arm, changed

    def with_values(self, **values: float) -> "Arm":
        """The same arm with other numbers, as in ``PANDA.with_values(a_3=0.088)``."""
        known = dict(self.values)
        unknown = sorted(set(values) - set(known))
        if unknown:
            raise ArmError(
                f"{self.name} has no symbol {', '.join(unknown)}; it has {', '.join(known) or 'none'}"
            )
        return replace(self, values={**known, **values})

    def lock(self, joint: int, at: Entry = 0) -> "Arm":
        """The same arm with one joint, counted from 1, held `at` a value (rad or m): one variable fewer."""
        if isinstance(joint, bool) or not isinstance(joint, int) or joint not in self.joints:
            free = ", ".join(map(str, self.joints))
            raise ArmError(
                f"{self.name}: joint {joint!r} cannot be locked; its free joints are {free}"
            )
        row = self.rows[joint - 1]
        value = evaluate(entry(at, "the locked value"), dict(self.values))
        if not row.joint.lower <= value <= row.joint.upper:
            raise ArmError(
                f"{self.name}: joint {joint} locked at {value:g}; its limits are"
                f" {row.joint.lower:g} to {row.joint.upper:g}"
            )
        moved = "theta" if row.joint.kind == "revolute" else "d"
        locked = replace(row, **{moved: _sum(getattr(row, moved), at)}, joint=Joint("fixed"))
        keep = [x for i, x in zip(self.joints, self.home, strict=True) if i != joint]
        rows = (*self.rows[: joint - 1], locked, *self.rows[joint:])
        return replace(self, rows=rows, home=tuple(keep))

    # Ready to compute with

    def joint_vector(self, q: ArrayLike, what: str = "q", many: bool = True) -> NDArray[np.float64]:
        """`q` as floats of shape (..., dof), or (dof,) unless `many`; `what` is its name in messages.

        Raises ArmError for another length, NaN or infinity.
        """
        shape = f"(..., {self.dof})" if many else f"one pose, ({self.dof},)"
        wanted = f"{shape}, one value for each of {', '.join(self.variables)}"
        return numbers(q, f"{self.name}: {what}", wanted, (self.dof,), many)

    @cached_property
    def numeric(self) -> tuple[NumericRow, ...]:
        """The rows with their values put in, for the numeric view."""
        return tuple(self._numeric(row) for row in self.rows)

    def _numeric(self, row: Row) -> NumericRow:
        a, alpha, d, theta = (self.number(e) for e in (row.a, row.alpha, row.d, row.theta))
        return NumericRow(row.joint.kind, a, d, *cos_sin(alpha), theta, *cos_sin(theta))

    @cached_property
    def programs(self) -> dict:
        """What `helpers.kinematics` has recorded of this arm."""
        return {}

    def number(self, value: Entry) -> float:
        """The number that an entry of this arm's tables stands for."""
        return evaluate(value, self._values)

    @cached_property
    def _values(self) -> Mapping[str, float]:
        return dict(self.values)

    # To read

    def __repr__(self) -> str:
        letters = "".join(self.rows[i - 1].joint.kind[0].upper() for i in self.joints)
        return f"<Arm {self.name}: {len(self.rows)} rows, {letters or 'no joint'}>"

    def _repr_markdown_(self) -> str:
        head = "| $i$ | $a_i$ | $\\alpha_i$ | $d_i$ | $\\theta_i$ |\n|:-:|:-:|:-:|:-:|:-:|\n"
        lines = [_markdown(i, row) for i, row in enumerate(self.rows, 1)]
        used = {
            n for row in self.rows for e in (row.a, row.alpha, row.d, row.theta) for n in names(e)
        }
        values = ", ".join(f"${latex(k)} = {v:g}$" for k, v in self.values if k in used)
        return (
            head
            + "\n".join(lines)
            + (f"\n\n{self.name}: {values} (m)" if values else f"\n\n{self.name}")
        )


def _pairs(values: object, what: str) -> tuple[tuple[str, object], ...]:
    """The items of a mapping, or of pairs, from names to numbers."""
    wanted = "a number for each symbol, as in {'a_3': 0.0825}"
    try:
        pairs = tuple(dict(values).items())
    except (TypeError, ValueError):
        raise ArmError(f"{what} are {shown(values)}; expected {wanted}") from None
    if not all(isinstance(name, str) for name, _ in pairs):
        raise ArmError(f"{what} are {shown(values)}; expected {wanted}")
    return pairs


def _number(value: object, what: str) -> float:
    try:
        return float(value)
    except (TypeError, ValueError):
        raise ArmError(f"{what} is {value!r}; expected a number") from None


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


def _sum(offset: Entry, at: Entry) -> Entry:
    if offset == 0:
        return at
    return offset if at == 0 else f"{offset} + {at}"


def _markdown(i: int, row: Row) -> str:
    d, theta = latex(row.d), latex(row.theta)
    if row.joint.kind == "revolute":
        theta = _with_variable(i, row.theta)
    if row.joint.kind == "prismatic":
        d = _with_variable(i, row.d)
    return f"| {i} | ${latex(row.a)}$ | ${latex(row.alpha)}$ | ${d}$ | ${theta}$ |"


def _with_variable(i: int, offset: Entry) -> str:
    text = latex(offset)
    if offset == 0:
        return f"q_{{{i}}}"
    return f"q_{{{i}}} - {text[1:]}" if text.startswith("-") else f"q_{{{i}}} + {text}"
