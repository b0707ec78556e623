"""An arm is a value: an immutable, hashable table of Denavit-Hartenberg rows.

Rows follow the standard ("distal") convention of Spong, Hutchinson and Vidyasagar, *Robot Modeling
and Control*, section 3.2: ``A = Rot_z(theta) Trans_z(d) Trans_x(a) Rot_x(alpha)``, joint *i* moving
about or along ``z_{i-1}``. Lengths are in metres, angles in radians. Entries are symbols to read
(``a_3``) with values to run, and exact angles (``pi/2``).
"""

import math
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, field, replace
from functools import cached_property
from typing import Any

import numpy as np
from numpy.lib.mixins import NDArrayOperatorsMixin
from numpy.typing import ArrayLike, NDArray

from helpers.expressions import Entry, entry, evaluate, latex, names
from helpers.inputs import LARGEST, ArmError, listed, must_be, numbers, shown
from helpers.rows import (
    Body,
    Joint,
    NumericRow,
    Row,
    Values,
    changed,
    cos_sin,
    fixed,
    prismatic,
    real,
    revolute,
    warn_of_degrees,
)

__all__ = ["Arm", "ArmError", "Body", "Joint", "Row", "fixed", "prismatic", "revolute"]

Array = NDArray[np.float64]


class JointValues(NDArrayOperatorsMixin, tuple):
    """Joint values that are compared and hashed as a tuple and computed with as an array."""

    __eq__, __ne__, __hash__ = tuple.__eq__, tuple.__ne__, tuple.__hash__

    def __array_ufunc__(self, ufunc: Any, method: str, *inputs: Any, **options: Any) -> Any:
        arrays = (np.array(x) if isinstance(x, JointValues) else x for x in inputs)
        return getattr(ufunc, method)(*arrays, **options)


@dataclass(frozen=True)
class Arm:
    """A serial arm in standard Denavit-Hartenberg form.

    Args:
        name: what to call it in messages and figures.
        rows: one `Row` per link, base to tip.
        values: a number for every symbol in the rows and bodies (m, rad, kg), read as a dict is:
            ``arm.values["a_3"]``.
        bodies: one `Body` per row, or none where masses are unknown.
        home: a joint vector of shape (dof,) to draw and start from; zeros unless given.
        source: where the numbers come from.

    Raises:
        ArmError: an entry is no number or formula, a symbol has no value, or a count does not fit.
    """

    name: str
    rows: Sequence[Row]
    values: Mapping[str, float] = field(default_factory=dict)
    bodies: Sequence[Body] = ()
    home: Sequence[float] = ()
    source: str = ""

    def __post_init__(self) -> None:
        must_be(self.name, str, "an arm's name")
        self._put(
            rows=listed(self.rows, f"{self.name}: rows", "one Row or more"),
            bodies=listed(self.bodies, f"{self.name}: bodies", "one Body for each row"),
            values=Values(self.values, self.name),
        )
        if not self.rows or not all(isinstance(row, Row) for row in self.rows):
            raise ArmError(f"{self.name}: rows are {self.rows!r}; expected one Row or more")
        home = listed(self.home, f"{self.name}: the values of home", f"{self.dof} joint values")
        home = tuple(real(x, f"{self.name}: home") for x in home)
        self._put(home=JointValues(home or (0.0,) * self.dof))
        self._check_bodies()
        self._check_symbols()
        for formula in self._entries():
            self._check_finite(formula)
        self._check_masses()
        self.joint_vector(self.home)

    def _put(self, **fields: object) -> None:
        for name, value in fields.items():
            object.__setattr__(self, name, value)

    def _check_bodies(self) -> None:
        if not all(isinstance(body, Body) for body in self.bodies):
            raise ArmError(
                f"{self.name}: bodies are {self.bodies!r}; expected one Body for each row"
            )
        if self.bodies and len(self.bodies) != len(self.rows):
            raise ArmError(
                f"{self.name}: {len(self.bodies)} bodies for {len(self.rows)} rows;"
                " expected one each"
            )

    def _check_masses(self) -> None:
        for number, body in enumerate(self.bodies, 1):
            if self.number(body.mass) < 0:
                raise ArmError(
                    f"{self.name}: the mass of link {number} is {body.mass}; expected 0 kg or more"
                )

    def _check_symbols(self) -> None:
        needed = {name for formula in self._entries() for name in names(formula)}
        if taken := sorted(needed & set(self.variables)):
            raise ArmError(
                f"{self.name}: {taken[0]} is the variable of a joint; leave it out,"
                " for a joint's variable is added to its row by itself"
            )
        if missing := sorted(needed - set(self.values)):
            raise ArmError(
                f"{self.name}: no value for {', '.join(missing)};"
                f" give values={{{missing[0]!r}: ...}}"
            )
        for name, value in self.values.items():
            if not math.isfinite(value):
                raise ArmError(f"{self.name}: {name} is {value}; expected a finite number")

    def _check_finite(self, formula: Entry) -> None:
        try:
            fits = abs(self.number(formula)) <= LARGEST
        except ArmError:
            fits = False
        if not fits:
            raise ArmError(
                f"{self.name}: {formula} divides by zero or is too large; give it other values"
            )

    def _entries(self) -> list[Entry]:
        table = [e for row in self.rows for e in row.entries]
        return table + [e for body in self.bodies for e in (body.mass, *body.com)]

    # What it is

    @cached_property
    def joints(self) -> tuple[int, ...]:
        """The numbers, counted from 1, of the rows that move."""
        return tuple(i for i, row in enumerate(self.rows, 1) if row.joint.kind != "fixed")

    @property
    def locked(self) -> dict[int, float]:
        """The joints that `lock` holds, by their numbers, and where (rad or m)."""
        held = {i: row.joint.at for i, row in enumerate(self.rows, 1)}
        return {i: self.number(at) for i, at in held.items() if at is not None}

    @property
    def dof(self) -> int:
        """How many joints move."""
        return len(self.joints)

    @property
    def variables(self) -> tuple[str, ...]:
        """The joint variables, named by row; with joint 3 locked ``q_1``, ``q_2``, ``q_4``, ..."""
        return tuple(f"q_{i}" for i in self.joints)

    @property
    def turning(self) -> NDArray[np.bool_]:
        """Which of the joints turn, shape (dof,); the others slide."""
        return np.array([self.rows[i - 1].joint.kind == "revolute" for i in self.joints], bool)

    @property
    def limits(self) -> tuple[Array, Array]:
        """Lower and upper joint limits, each of shape (dof,), in rad or m; infinite where
        unknown."""
        return self._joint_array("lower"), self._joint_array("upper")

    @property
    def speed_limits(self) -> Array:
        """Top joint speeds, shape (dof,), in rad/s or m/s; infinite where unknown."""
        return self._joint_array("speed")

    @property
    def effort_limits(self) -> Array:
        """Top joint torques or forces, shape (dof,), in N m or N; infinite where unknown."""
        return self._joint_array("effort")

    def _joint_array(self, name: str) -> Array:
        return np.array([getattr(self.rows[i - 1].joint, name) for i in self.joints])

    @classmethod
    def from_table(
        cls,
        source: object,
        *,
        columns: str | None = None,
        lengths: str | None = None,
        angles: str | None = None,
        convention: str | None = None,
        values: Mapping[str, float] | None = None,
        name: str = "my table",
    ) -> "Arm":
        """An arm from a table as people hold it: pasted text, rows, parallel lists, ``Link(...)``
        lines, 4 x 4 matrices.

        Args:
            source: LaTeX, Markdown, MATLAB, CSV or Python text, or lists; the joint's variable may
                stand in theta or d.
            columns: their order, as ``"theta d a alpha"``.
            lengths: "m", "cm" or "mm".
            angles: "rad" or "deg".
            convention: "standard" or "craig" (modified), whose rows hold a_{i-1} and alpha_{i-1}.
            values: numbers for symbols other than the joints'.
            name: what to call the arm.

        What is not given is guessed, and the arm's `source` tells how the table was taken. Raises
        ArmError for what is no table, or holds a symbol without a value.
        """
        from helpers.checks.tables import rows_of  # no other arm needs it

        must_be(name, str, "an arm's name")
        rows, said = rows_of(
            source,
            columns=columns,
            lengths=lengths,
            angles=angles,
            convention=convention,
            values=values,
        )
        return cls(name, rows, source="; ".join(said))

    # The same arm, changed

    def with_values(self, **values: float) -> "Arm":
        """The same arm with other numbers, as in ``PANDA.with_values(a_3=0.088)``."""
        unknown = sorted(set(values) - set(self.values))
        if unknown:
            known = ", ".join(self.values) or "none"
            raise ArmError(f"{self.name} has no symbol {', '.join(unknown)}; it has {known}")
        return replace(self, values={**self.values, **values})

    def with_row(self, number: int, **changes: Any) -> "Arm":
        """The same arm with one row, counted from 1, changed.

        Its entries a, alpha, d and theta, as in ``PANDA.with_row(4, a=0, alpha="-pi/2")``, its
        joint's `limits` (lower, upper), `speed` and `effort`, or the `mass` that it carries. Raises
        ArmError for a row that is not there and for what a row has not.
        """
        every = tuple(range(1, len(self.rows) + 1))
        row = self._row(number, every, "number is {}; expected one of its rows,")
        mass = ("mass",) if self.bodies else ()
        known = ("a", "alpha", "d", "theta", "limits", "speed", "effort", *mass)
        if unknown := sorted(set(changes) - set(known)):
            raise ArmError(f"{self.name}: a row has no {unknown[0]}; expected {', '.join(known)}")
        warn_of_degrees(changes.get("alpha", 0), changes.get("theta", 0))
        entries = {name: changes.get(name, entry) for name, entry in _entries(row).items()}
        rows, bodies = [*self.rows], [*self.bodies]
        rows[number - 1] = Row(**entries, joint=changed(row.joint, changes))
        if "mass" in changes:
            bodies[number - 1] = replace(bodies[number - 1], mass=changes["mass"])
        return replace(self, rows=rows, bodies=bodies)

    def with_bodies(self, bodies: Iterable[Body], name: str | None = None) -> "Arm":
        """The same arm with other masses, one `Body` for each row; none takes them off."""
        bodies = listed(bodies, f"{self.name}: bodies", "one Body for each row")
        return replace(self, name=self.name if name is None else name, bodies=bodies)

    def lock(self, joint: int, at: Entry = 0) -> "Arm":
        """The same arm with a joint, counted from 1, held `at` a value (rad or m): one fewer
        moves."""
        row = self._row(joint, self.joints, "joint {} cannot be locked; its free joints are")
        at = entry(at, "at")
        evaluate(at, self.values)  # says what is wrong with it
        moved = "theta" if row.joint.kind == "revolute" else "d"
        offset = {**_entries(row), moved: _sum(getattr(row, moved), at)}
        locked = Row(**offset, joint=Joint("fixed", at=at))
        keep = [x for i, x in zip(self.joints, self.home, strict=True) if i != joint]
        rows = (*self.rows[: joint - 1], locked, *self.rows[joint:])
        return replace(self, rows=rows, home=tuple(keep))

    def _row(self, number: object, known: Sequence[int], wrong: str) -> Row:
        if isinstance(number, int | np.integer) and number in known and number is not True:
            return self.rows[int(number) - 1]
        listing = ", ".join(map(str, known))
        raise ArmError(f"{self.name}: {wrong.format(shown(number))} {listing}")

    def to_free(self, q: ArrayLike) -> Array:
        """`q`, shape (..., dof), as the arm has it whose joints this one locks.

        The values of the locked joints are put in at their places: shape (..., dof + locked).
        """
        q = self.joint_vector(q)
        both = sorted([*self.joints, *self.locked])
        free = np.empty((*q.shape[:-1], len(both)))
        free[..., [both.index(i) for i in self.joints]] = q
        for i, at in self.locked.items():
            free[..., both.index(i)] = at
        return free

    def from_free(self, q: ArrayLike) -> Array:
        """The values of this arm's joints, shape (..., dof), from those of the arm it was locked
        from.

        The inverse of `to_free`; what `q` says of the locked joints is left out.
        """
        both = sorted([*self.joints, *self.locked])
        wanted = f"(..., {len(both)}), one value for each of joints {', '.join(map(str, both))}"
        free = numbers(q, f"{self.name}: q", wanted, (len(both),), many=True)
        return free[..., [both.index(i) for i in self.joints]]

    # Ready to compute with

    def joint_vector(self, q: ArrayLike, what: str = "q", many: bool = True) -> Array:
        """`q` as floats of shape (..., dof), or (dof,) unless `many`; `what` is its name in
        messages.

        Raises ArmError for another length, NaN or infinity.
        """
        shape = f"numbers (..., {self.dof})" if many else f"one pose, numbers ({self.dof},)"
        wanted = f"{shape}, one value for each of {', '.join(self.variables)}"
        return numbers(q, f"{self.name}: {what}", wanted, (self.dof,), many)

    @cached_property
    def numeric(self) -> tuple[NumericRow, ...]:
        """The rows with their values put in, for the numeric view."""
        return tuple(self._numeric(row) for row in self.rows)

    def _numeric(self, row: Row) -> NumericRow:
        a, alpha, d, theta = map(self.number, row.entries)
        return NumericRow(row.joint.kind, a, d, *cos_sin(alpha), theta, *cos_sin(theta))

    @cached_property
    def programs(self) -> dict:
        """What `helpers.kinematics` has recorded of this arm."""
        return {}

    def number(self, value: Entry) -> float:
        """The number that an entry of this arm's tables stands for."""
        return evaluate(value, self.values)

    # To read

    def __repr__(self) -> str:
        letters = "".join(self.rows[i - 1].joint.kind[0].upper() for i in self.joints)
        return f"<Arm {self.name}: {len(self.rows)} rows, {letters or 'no joint'}>"

    def _repr_markdown_(self) -> str:
        head = "| $i$ | $a_i$ | $\\alpha_i$ | $d_i$ | $\\theta_i$ |\n|:-:|:-:|:-:|:-:|:-:|\n"
        lines = [_markdown(i, row) for i, row in enumerate(self.rows, 1)]
        used = {name for row in self.rows for e in row.entries for name in names(e)}
        values = ", ".join(f"${latex(k)} = {v:g}$" for k, v in self.values.items() if k in used)
        caption = f"{self.name}: {values} (m)" if values else self.name
        return head + "\n".join(lines) + f"\n\n{caption}"


def _entries(row: Row) -> dict[str, Entry]:
    return dict(zip(("a", "alpha", "d", "theta"), row.entries, strict=True))


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
