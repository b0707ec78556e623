"""Define rows, joints, bodies and the values of symbols, of which an arm consists."""

import math
import re
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace
from numbers import Real
from typing import Any, Literal, NamedTuple

import numpy as np
from numpy.typing import NDArray

from helpers.expressions import Entry, check_entry, symbol_names
from helpers.inputs import (
    LARGEST,
    ArmError,
    finite_array,
    float_array,
    require_choice,
    shorten,
    tuple_of_items,
    warn_caller,
)

Kind = Literal["revolute", "prismatic", "fixed"]
KINDS = ("revolute", "prismatic", "fixed")

# Joint angles (rad) above this give a warning: four turns are far beyond any maker's range, and
# below 30, the smallest angle that is common in degrees.
MANY_TURNS = 8 * math.pi
_LONG = 10.0  # m: lengths from here on give a warning; the judge reads such lengths as mm


@dataclass(frozen=True)
class Joint:
    """The joint of a row.

    Args:
        kind: "revolute", "prismatic" or "fixed".
        lower: Lower limit, in rad or m.
        upper: Upper limit, in rad or m.
        speed: Largest speed, in rad/s or m/s.
        effort: Largest torque or force, in N m or N.
        at: Value, in rad or m, at which a joint was locked; the kind is then "fixed".
    """

    kind: Kind = "revolute"
    lower: float = -math.inf
    upper: float = math.inf
    speed: float = math.inf
    effort: float = math.inf
    at: Entry | None = None

    def __post_init__(self) -> None:
        require_choice(self.kind, "joint kind", KINDS)
        for name in ("lower", "upper", "speed", "effort"):
            object.__setattr__(self, name, real_number(getattr(self, name), f"joint {name}"))
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
            object.__setattr__(self, "at", check_entry(self.at, "joint at"))


@dataclass(frozen=True)
class Row:
    """A row of a Denavit-Hartenberg table.

    Args:
        a: Length along x, in m.
        alpha: Angle about x, in rad.
        d: Length along z, in m; a prismatic joint's variable is added to it.
        theta: Angle about z, in rad; a revolute joint's variable is added to it.
        joint: The joint that moves the row.
    """

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
            object.__setattr__(self, name, check_entry(getattr(self, name), name))

    @property
    def entries(self) -> tuple[Entry, Entry, Entry, Entry]:
        """The four entries, in the order a, alpha, d, theta."""
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
    """Return a row whose joint turns: the angle about z is q + `theta`.

    An angle above 2 pi, given as a number, gives a warning, since it may be meant in degrees; so
    does a length of 10 m or more.

    Args:
        a: Length along x, in m; a number, or a formula such as ``"a_3"``.
        alpha: Angle about x, in rad; a number, or a formula such as ``"-pi/2"``.
        d: Length along z, in m.
        theta: Angle that is added to q, in rad.
        limits: Lower and upper limit of q, in rad.
        speed: Largest joint speed, in rad/s.
        effort: Largest joint torque, in N m.

    Example:
        >>> revolute(a="a_3", alpha="-pi/2", limits=(-2.9, 2.9)).entries
        ('a_3', '-pi/2', 0, 0)
    """
    warn_of_units(a, alpha, d, theta)
    return Row(a, alpha, d, theta, _make_joint("revolute", limits, speed, effort))


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
    """Return a row whose joint slides: the length along z is q + `d`.

    An angle above 2 pi, given as a number, gives a warning, since it may be meant in degrees; so
    does a length of 10 m or more.

    Args:
        a: Length along x, in m; a number, or a formula such as ``"a_3"``.
        alpha: Angle about x, in rad; a number, or a formula such as ``"-pi/2"``.
        d: Length that is added to q, in m.
        theta: Angle about z, in rad.
        limits: Lower and upper limit of q, in m.
        speed: Largest joint speed, in m/s.
        effort: Largest joint force, in N.

    Example:
        >>> prismatic(alpha="pi/2", limits=(0.1, 1.0)).joint.upper
        1.0
    """
    warn_of_units(a, alpha, d, theta)
    return Row(a, alpha, d, theta, _make_joint("prismatic", limits, speed, effort))


def _make_joint(kind: Kind, limits: Sequence[float], speed: float, effort: float) -> Joint:
    return change_joint(Joint(kind), {"limits": limits, "speed": speed, "effort": effort})


def change_joint(joint: Joint, changes: Mapping[str, Any]) -> Joint:
    """Return the joint with new `limits`, `speed` and `effort`, those that `changes` has."""
    fields = {name: changes[name] for name in ("speed", "effort") if name in changes}
    if "limits" in changes:
        expected = "two numbers, lower and upper"
        if len(tuple_of_items(changes["limits"], "joint limits", expected)) != 2:
            raise ArmError(f"joint limits are {shorten(changes['limits'])}; expected {expected}")
        fields["lower"], fields["upper"] = changes["limits"]
    changed = replace(joint, **fields)
    if "limits" in changes:
        _warn_of_limits(changed)
    return changed


def _warn_of_limits(joint: Joint) -> None:
    """Warn of limits that look like degrees or millimetres."""
    ends = [abs(x) for x in (joint.lower, joint.upper) if math.isfinite(x)]
    limits = f"limits are ({joint.lower:g}, {joint.upper:g})"
    if joint.kind == "revolute" and max(ends, default=0) > MANY_TURNS:
        warn_caller(f"{limits} in radians, more than four turns; for degrees write np.radians(...)")
    if joint.kind == "prismatic" and max(ends, default=0) >= _LONG:
        warn_caller(f"{limits} in metres; for millimetres divide by 1000")


def fixed(a: Entry = 0, alpha: Entry = 0, d: Entry = 0, theta: Entry = 0) -> Row:
    """Return a row that does not move, such as a tool, a bracket or a locked joint.

    An angle above 2 pi, given as a number, gives a warning, since it may be meant in degrees; so
    does a length of 10 m or more.

    Args:
        a: Length along x, in m; a number, or a formula such as ``"l_tool"``.
        alpha: Angle about x, in rad.
        d: Length along z, in m.
        theta: Angle about z, in rad.

    Example:
        >>> fixed(d=0.1).joint.kind
        'fixed'
    """
    warn_of_units(a, alpha, d, theta)
    return Row(a, alpha, d, theta, Joint("fixed"))


def read_rows(table: Any, columns: str | Sequence[str], values: Mapping[str, float]) -> list[Row]:
    """Convert a table in metres and radians to rows.

    Args:
        table: Lists, an array or a SymPy matrix, shape (rows, 4).
        columns: Order of the columns.
        values: Numbers of symbols; any other symbol in theta or d is the variable of a joint.

    Raises:
        ArmError: `table` is no such table, or no row has a joint.
    """
    wanted = "a, alpha, d and theta in your order"
    typed = re.findall(r"\w+", columns) if isinstance(columns, str) else columns
    words = tuple(map(str, tuple_of_items(typed, "columns", wanted)))
    if sorted(words) != ["a", "alpha", "d", "theta"]:
        raise ArmError(f"columns are {shorten(columns)}; expected {wanted}")
    expected = f"rows of four entries ({' '.join(words)}), or a text"
    rows = []
    for number, row in enumerate(_list_items(table, "the table's rows", expected), 1):
        entries = _list_items(row, f"the entries of row {number}", expected)
        if len(entries) != 4:
            raise ArmError(f"row {number} is {shorten(row)}; expected {expected}")
        rows.append(_read_row(dict(zip(words, entries, strict=True)), number, values))
    if all(made.joint.kind == "fixed" for made in rows):
        raise ArmError(
            "no row has a joint; expected its variable, None or a symbol such as 'q1', in theta"
            " (revolute) or d (prismatic)"
        )
    return rows


def _list_items(value: Any, name: str, expected: str) -> tuple:
    # tolist() converts numbers of NumPy to Python's, and a SymPy matrix to rows.
    items = value.tolist() if hasattr(value, "tolist") else value
    return tuple_of_items(items, name, expected)


def _read_row(typed: dict[str, Any], number: int, values: Mapping[str, float]) -> Row:
    """Convert one row's entries, by column, to a row of the joint whose variable they hold."""
    entries: dict[str, Entry] = {}
    moves: list[tuple[str, str]] = []  # column and name (or "") of a joint's variable
    for column, entry in typed.items():
        where = f"row {number}: {column}"
        formula = 0 if entry is None else check_entry(entry, where)
        unknown = sorted(symbol_names(formula, where) - set(values))
        if entry is not None and not unknown:
            entries[column] = formula
        elif column in ("theta", "d"):
            moves.append((column, unknown[0] if unknown else ""))
            entries[column] = _split_offset(str(formula), unknown[0], where) if unknown else 0
        else:
            raise ArmError(
                f"{where} is {shorten(entry)}; expected a number, or a formula of symbols in values"
                " (say columns='a alpha d theta', or your order, if the columns have another)"
            )
    if len(moves) > 1:
        raise ArmError(
            f"row {number}: theta is {shorten(typed['theta'])} and d is {shorten(typed['d'])};"
            " expected one joint variable, and a value for every other symbol, as in"
            " values={'d_1': 0.3}"
        )
    row = entries["a"], entries["alpha"], entries["d"], entries["theta"]
    if not moves:
        return fixed(*row)
    [(column, variable)] = moves
    digits = re.search(r"\d+$", variable)
    if digits and int(digits[0]) != number:
        warn_caller(f"your {variable} is q_{number} here, since joints are numbered by their rows")
    return revolute(*row) if column == "theta" else prismatic(*row)


def _split_offset(formula: str, variable: str, where: str) -> Entry:
    """Return what is added to the joint's variable in a formula such as "q1 - pi/2"."""
    if formula == variable:
        return 0
    if match := re.fullmatch(rf"{variable}\s*([+-])\s*(.+)", formula):
        return match[2] if match[1] == "+" else f"-{match[2]}"
    if match := re.fullmatch(rf"(.+?)\s*\+\s*{variable}", formula):
        return match[1]
    raise ArmError(
        f"{where} is {formula!r}; expected the joint's variable {variable} alone or with an offset,"
        f" such as '{variable} - pi/2', and a value for every other symbol"
    )


def warn_of_units(a: Entry, alpha: Entry, d: Entry, theta: Entry) -> None:
    """Warn of numbers that look like degrees (angles above 2 pi) or millimetres."""
    for angle in (alpha, theta):
        if isinstance(angle, Real) and 2 * math.pi < abs(angle) <= LARGEST:
            degrees = f"for degrees write np.radians({angle:g})"
            warn_caller(f"an angle is {angle:g}, in radians; {degrees}")
    for length in (a, d):
        if isinstance(length, Real) and _LONG <= abs(length) <= LARGEST:
            warn_caller(f"a length is {length:g} m; for millimetres write {length:g} / 1000")


@dataclass(frozen=True)
class Body:
    """The link that moves with a row.

    Args:
        mass: Mass, in kg; a number or a formula.
        com: Centre of mass in the row's own frame, three coordinates in m.
        inertia: Inertia tensor about the centre of mass in the axes of the row's own frame, shape
            (3, 3), in kg m^2; 0 by default, as for a point mass.
    """

    mass: Entry
    com: Sequence[Entry]
    inertia: Sequence[Sequence[float]] = ((0.0,) * 3,) * 3

    def __post_init__(self) -> None:
        expected = "three coordinates (x, y, z)"
        if len(tuple_of_items(self.com, "the coordinates of the centre of mass", expected)) != 3:
            raise ArmError(f"centre of mass is {self.com!r}; expected {expected}")
        object.__setattr__(self, "mass", check_entry(self.mass, "mass"))
        object.__setattr__(self, "com", tuple(check_entry(c, "centre of mass") for c in self.com))
        tensor = check_tensors(self.inertia, (3, 3), "inertia")
        object.__setattr__(self, "inertia", tuple(tuple(row) for row in tensor.tolist()))


def check_tensors(value: object, shape: tuple[int, ...], name: str) -> NDArray[np.float64]:
    """Convert `value` to symmetric tensors (..., 3, 3)."""
    tensors = finite_array(value, name, f"symmetric tensors {shape} in kg m^2", shape)
    if not np.allclose(tensors, np.swapaxes(tensors, -1, -2), rtol=0, atol=1e-12):
        raise ArmError(f"{name}: a tensor is not symmetric; expected xy = yx, xz = zx and yz = zy")
    return tensors


class Values(Mapping[str, float]):
    """An immutable mapping from an arm's symbols to their values, in m, rad and kg."""

    __slots__ = ("_numbers",)

    def __init__(self, numbers: Mapping[str, float], owner: str) -> None:
        expected = "a number for each symbol, as in {'a_3': 0.0825}"
        try:
            values = dict[Any, Any](numbers)
        except (TypeError, ValueError):
            raise ArmError(f"{owner}: values are {shorten(numbers)}; expected {expected}") from None
        if not all(isinstance(name, str) for name in values):
            raise ArmError(f"{owner}: values are {shorten(numbers)}; expected {expected}")
        self._numbers = {str(k): real_number(v, f"{owner}: {k}") for k, v in values.items()}

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
    """A row in numbers.

    Multiples of a right angle have exact sines and cosines.
    """

    kind: Kind
    a: float
    d: float
    cos_alpha: float
    sin_alpha: float
    theta: float
    cos_theta: float
    sin_theta: float


def real_number(value: object, name: str) -> float:
    """Convert `value` to a float, which may be infinite or NaN."""
    array = float_array(value, name, "a number")
    if array.shape:
        raise ArmError(f"{name} is {shorten(value)}; expected a number")
    return float(array)


def cos_sin(angle: float) -> tuple[float, float]:
    """Compute a cosine and a sine that are exact at multiples of a right angle.

    So the zeros of an arm's matrices are exactly 0.
    """
    turns = quarter_turns(angle)
    if turns is None:
        return math.cos(angle), math.sin(angle)
    return ((1.0, 0.0), (0.0, 1.0), (-1.0, 0.0), (0.0, -1.0))[turns % 4]


def angle_entry(angle: float) -> Entry:
    """Return an angle as a formula where it is a multiple of a right angle, so that it is exact."""
    turns = quarter_turns(float(angle))
    return float(angle) if turns is None else RIGHT_ANGLES[turns]


RIGHT_ANGLES: dict[int, Entry] = {0: 0, 1: "pi/2", 2: "pi", -1: "-pi/2", -2: "-pi"}


def rotation_from_angles(angles: Iterable[float]) -> NDArray[np.float64]:
    """Compute Rot_z(yaw) Rot_y(pitch) Rot_x(roll) for (roll, pitch, yaw) in rad."""
    (cr, sr), (cp, sp), (cy, sy) = (cos_sin(float(angle)) for angle in angles)
    return np.array([
        [cy * cp, cy * sp * sr - sy * cr, cy * sp * cr + sy * sr],
        [sy * cp, sy * sp * sr + cy * cr, sy * sp * cr - cy * sr],
        [-sp, cp * sr, cp * cr],
    ])  # fmt: skip


def quarter_turns(angle: float) -> int | None:
    """Return how many right angles an angle (rad) is, or None where it is no multiple of one."""
    turns = angle / (math.pi / 2)
    # 1e-12 is 1000 times the round-off of an angle such as 3 * pi / 2.
    return round(turns) if abs(turns - round(turns)) < 1e-12 else None
