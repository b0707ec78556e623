"""Define `Arm`, an immutable, hashable table of Denavit-Hartenberg rows.

Rows follow the standard ("distal") convention of Spong, Hutchinson and Vidyasagar, *Robot Modeling
and Control*, section 3.2: ``A = Rot_z(theta) Trans_z(d) Trans_x(a) Rot_x(alpha)``; joint *i* moves
about or along ``z_{i-1}``. Lengths are in metres, angles in radians. Entries are symbols such as
``a_3``, which have values, exact angles such as ``pi/2``, or numbers.
"""

from __future__ import annotations

import math
import os
import warnings
from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass, field, replace
from functools import cached_property
from typing import Any

import numpy as np
from numpy.lib.mixins import NDArrayOperatorsMixin
from numpy.typing import ArrayLike, NDArray

from helpers.base_and_tool import split_pose
from helpers.deprecated import warn_renamed
from helpers.expressions import Entry, check_entry, entry_latex, evaluate_entry, symbol_names
from helpers.inputs import (
    LARGEST,
    ArmError,
    finite_array,
    require_type,
    shorten,
    tuple_of_items,
    warn_caller,
)
from helpers.rows import (
    MANY_TURNS,
    Body,
    Joint,
    NumericRow,
    Row,
    Values,
    change_joint,
    cos_sin,
    fixed,
    prismatic,
    read_rows,
    real_number,
    revolute,
    warn_of_units,
)

__all__ = ["Arm", "ArmError", "Body", "Joint", "Row", "fixed", "prismatic", "revolute"]

Array = NDArray[np.float64]


class JointValues(NDArrayOperatorsMixin, tuple):
    """Joint values that compare and hash as a tuple and compute as an array."""

    __eq__, __ne__, __hash__ = tuple.__eq__, tuple.__ne__, tuple.__hash__

    def __getattr__(self, name: str) -> Any:
        """Return an array's attribute, such as `shape`, `round` or `copy`."""
        if name.startswith("__"):
            raise AttributeError(name)
        return getattr(np.array(self), name)

    def __array_ufunc__(self, ufunc: Any, method: str, *inputs: Any, **options: Any) -> Any:
        arrays = (np.array(x) if isinstance(x, JointValues) else x for x in inputs)
        return getattr(ufunc, method)(*arrays, **options)


@dataclass(frozen=True)
class CircleTask:
    """The circle below the tip that the homework asks an arm to draw from its home.

    Args:
        normal: Base axis at right angles to the circle's plane: "x" or "y".
        seconds: Duration of the circle.
        locked_joint: The joint that stays still, counted from 1 among the joints that move; None
            if all move.
        rates: How the joint rates are computed: "inverse" with J⁻¹, "pseudo" with the
            pseudo-inverse.
    """

    normal: str
    seconds: float
    locked_joint: int | None = None
    rates: str = "inverse"


@dataclass(frozen=True)
class Arm:
    """A serial arm in standard Denavit-Hartenberg form.

    Args:
        name: The arm's name in messages and figures.
        rows: One `Row` for each link, from the base to the tip.
        values: A number for every symbol in the rows and bodies, in m, rad or kg, as in
            ``arm.values["a_3"]``.
        bodies: One `Body` for each row, or none where masses are unknown.
        home: Joint values, shape (dof,), at which the arm is drawn and motions start; zeros by
            default.
        source: Where the numbers come from.
        circle: The circle of the homework, or None. An arm with a joint locked has none.

    Raises:
        ArmError: An entry is no number or formula, a symbol has no value, or a count does not fit.

    Example:
        >>> arm = Arm("two links", [revolute(a="a_1"), revolute(a="a_2")], dict(a_1=0.4, a_2=0.3))
        >>> arm
        <Arm two links: 2 rows, RR>
        >>> arm.values["a_2"]
        0.3
    """

    name: str
    rows: Sequence[Row]
    values: Mapping[str, float] = field(default_factory=dict)
    bodies: Sequence[Body] = ()
    home: Sequence[float] = ()
    source: str = ""
    circle: CircleTask | None = None

    def __post_init__(self) -> None:
        require_type(self.name, str, "an arm's name")
        self._set_fields(
            rows=tuple_of_items(self.rows, f"{self.name}: rows", "one Row or more"),
            bodies=tuple_of_items(self.bodies, f"{self.name}: bodies", "one Body for each row"),
            values=Values(self.values, self.name),
        )
        if not self.rows or not all(isinstance(row, Row) for row in self.rows):
            raise ArmError(f"{self.name}: rows are {self.rows!r}; expected one Row or more")
        home = tuple_of_items(
            self.home, f"{self.name}: the values of home", f"{self.dof} joint values"
        )
        home = tuple(real_number(x, f"{self.name}: home") for x in home)
        self._set_fields(home=JointValues(home or (0.0,) * self.dof))
        if not all(isinstance(body, Body) for body in self.bodies):
            raise ArmError(
                f"{self.name}: bodies are {self.bodies!r}; expected one Body for each row"
            )
        if self.bodies and len(self.bodies) != len(self.rows):
            raise ArmError(
                f"{self.name}: {len(self.bodies)} bodies for {len(self.rows)} rows;"
                " expected one each"
            )
        self._check_entries()
        self.joint_vector(self.home)
        if self.circle is not None:
            require_type(self.circle, CircleTask, f"{self.name}: circle")
            if (self.circle.locked_joint or 0) > self.dof:
                raise ArmError(
                    f"{self.name}: the circle locks joint {self.circle.locked_joint};"
                    f" expected one of the {self.dof} joints that move"
                )

    def _set_fields(self, **fields: object) -> None:
        for name, value in fields.items():
            object.__setattr__(self, name, value)

    def _check_entries(self) -> None:
        """Raise ArmError unless all entries have finite values, and masses none below 0."""
        entries = [entry for row in self.rows for entry in row.entries]
        entries += [entry for body in self.bodies for entry in (body.mass, *body.com)]
        used = {name for entry in entries for name in symbol_names(entry)}
        if variables := sorted(used & set(self.variables)):
            raise ArmError(
                f"{self.name}: {variables[0]} is the variable of a joint; leave it out,"
                " for a joint's variable is added to its row by itself"
            )
        if missing := sorted(used - set(self.values)):
            raise ArmError(
                f"{self.name}: no value for {', '.join(missing)};"
                f" give values={{{missing[0]!r}: ...}}"
            )
        for name, value in self.values.items():
            if not math.isfinite(value):
                raise ArmError(f"{self.name}: {name} is {value}; expected a finite number")
        for entry in entries:
            try:
                fits = abs(self.number(entry)) <= LARGEST
            except ArmError:
                fits = False
            if not fits:
                raise ArmError(
                    f"{self.name}: {entry} divides by zero or is too large; give it other values"
                )
        for number, body in enumerate(self.bodies, 1):
            if self.number(body.mass) < 0:
                raise ArmError(
                    f"{self.name}: the mass of link {number} is {body.mass}; expected 0 kg or more"
                )

    # Properties

    @cached_property
    def joints(self) -> tuple[int, ...]:
        """The rows that move, counted from 1."""
        return tuple(i for i, row in enumerate(self.rows, 1) if row.joint.kind != "fixed")

    @property
    def locked(self) -> dict[int, float]:
        """The value (rad or m) of each locked joint, by the joint's number."""
        locked_at = {i: row.joint.at for i, row in enumerate(self.rows, 1)}
        return {i: self.number(at) for i, at in locked_at.items() if at is not None}

    @property
    def dof(self) -> int:
        """The number of joints that move."""
        return len(self.joints)

    @property
    def variables(self) -> tuple[str, ...]:
        """The joint variables ``q_1``, ``q_2``, ..., numbered by row."""
        return tuple(f"q_{i}" for i in self.joints)

    @property
    def turning(self) -> NDArray[np.bool_]:
        """True for each revolute joint, shape (dof,).

        The remaining joints are prismatic.
        """
        return np.array([self.rows[i - 1].joint.kind == "revolute" for i in self.joints], bool)

    @property
    def limits(self) -> tuple[Array, Array]:
        """The lower and the upper joint limits, each of shape (dof,), in rad or m.

        Unknown limits are infinite.
        """
        return self._joint_array("lower"), self._joint_array("upper")

    @property
    def speed_limits(self) -> Array:
        """The largest joint speeds, shape (dof,), in rad/s or m/s.

        They are infinite where unknown.
        """
        return self._joint_array("speed")

    @property
    def effort_limits(self) -> Array:
        """The largest torques or forces, shape (dof,), in N m or N.

        They are infinite where unknown.
        """
        return self._joint_array("effort")

    def _joint_array(self, name: str) -> Array:
        return np.array([getattr(self.rows[i - 1].joint, name) for i in self.joints])

    @classmethod
    def from_table(
        cls,
        source: object,
        *,
        columns: str | Sequence[str] | None = None,
        lengths: str | None = None,
        angles: str | None = None,
        convention: str | None = None,
        values: Mapping[str, float] | None = None,
        name: str = "my table",
    ) -> Arm:
        """Read a table as rows or as text.

        Rows are in metres and radians, in the standard convention. A row's joint has its variable
        in theta (revolute) or in d (prismatic): None, or a symbol without a value, alone or with an
        offset, as ``"q1 - pi/2"``. A row without one is fixed. Symbols with a value stay symbols.

        In a text, options that are not given are guessed, and the arm's `source` says how the table
        was read. A warning says where a guess may be wrong: columns without headers, unless they
        are a, alpha, d and a joint variable; angles such as 1.57 that are taken as right angles; a
        table that may follow Craig's convention.

        A warning also names joints that have other numbers in the table than here: the arm numbers
        a joint by its row, and fixed rows count.

        Args:
            source: Lists, an array or a SymPy matrix, shape (rows, 4); or LaTeX, Markdown, MATLAB,
                CSV or Python as text.
            columns: Order of the columns; "theta d a alpha" by default for rows.
            lengths: Unit of lengths in a text: "m", "cm" or "mm".
            angles: Unit of angles in a text: "rad" or "deg".
            convention: Convention of a text: "standard", or "craig" (modified), whose rows hold
                a_{i-1} and alpha_{i-1}.
            values: Numbers for symbols other than those of the joints.
            name: The arm's name.

        Returns:
            The arm, without limits and masses.

        Raises:
            ArmError: `source` is no table, or holds a symbol without a value.

        Example:
            >>> arm = Arm.from_table([["q1", 0.3, 0, "pi/2"], [None, 0, 0.4, 0], [0, "q3", 0, 0]])
            >>> arm
            <Arm my table: 3 rows, RRP>
            >>> arm.rows[0].entries
            (0, 'pi/2', 0.3, 0)
        """
        require_type(name, str, "an arm's name")
        if not isinstance(source, str):
            for option, given, unit in (
                ("lengths", lengths, "m"),
                ("angles", angles, "rad"),
                ("convention", convention, "standard"),
            ):
                if given not in (None, unit):
                    raise ArmError(
                        f"{option} is {shorten(given)}; expected {unit!r}, for rows are in metres"
                        " and radians in the standard convention"
                        " (a text takes other units; helpers.conventions.standard_from_modified"
                        " converts Craig's)"
                    )
            numbers = Values(values or {}, name)
            return cls(name, read_rows(source, columns or "theta d a alpha", numbers), numbers)

        # Imported here because this module imports `Arm`, and because it starts the judge.
        from helpers.checks.tables import read_table

        table = read_table(
            source,
            columns=columns,
            lengths=lengths,
            angles=angles,
            convention=convention,
            values=values,
        )
        if table.has_guessed_order:
            warn_caller(
                "the table has no column headers, so a guess reads it as:"
                f" {table.reading}; say columns='theta d a alpha' or your order, and"
                " convention='standard' or 'craig'"
            )
        for warning in table.warnings:
            warn_caller(f"{name}: {warning}")
        return cls(name, table.rows, source=table.reading)

    @classmethod
    def from_urdf(
        cls,
        source: str | os.PathLike[str],
        base: str | None = None,
        tip: str | None = None,
        **tolerances: float,
    ) -> Arm:
        """Read a robot description (URDF), as `helpers.urdf.from_urdf` does.

        Args:
            source: The file's path, or its text.
            base: Name of the link where the chain begins.
            tip: Name of the link where it ends.
            tolerances: `tolerance` and `angle_tolerance`.
        """
        # Imported here because this module imports `Arm`.
        from helpers.urdf import from_urdf

        return from_urdf(source, base, tip, **tolerances)

    # Changed copies

    def with_values(self, **values: float) -> Arm:
        """Return the arm with other values for some of its symbols.

        Args:
            values: New values by symbol, in m, rad or kg.

        Raises:
            ArmError: The arm has no such symbol.

        Example:
            >>> from helpers.robots import PANDA
            >>> PANDA.with_values(a_3=0.088).values["a_3"]
            0.088
        """
        unknown = sorted(set(values) - set(self.values))
        if unknown:
            known = ", ".join(self.values) or "none"
            raise ArmError(f"{self.name} has no symbol {', '.join(unknown)}; it has {known}")
        return replace(self, values={**self.values, **values})

    def with_row(self, number: int, **changes: Any) -> Arm:
        """Return the arm with one row changed.

        Args:
            number: Number of the row, counted from 1.
            changes: New entries `a`, `alpha`, `d` and `theta`, new `limits` (lower, upper), `speed`
                and `effort` of the joint, or a new `mass` of the row's link.

        Raises:
            ArmError: The arm has no such row, the row has no such entry, or it is fixed and has no
                limits.

        Example:
            >>> from helpers.robots import PANDA
            >>> PANDA.with_row(4, a=0, alpha="-pi/2").rows[3].entries
            (0, '-pi/2', 0, 0)
        """
        row_numbers = tuple(range(1, len(self.rows) + 1))
        row = self._require_row(number, row_numbers, "number is {}; expected one of its rows,")
        mass = ("mass",) if self.bodies else ()
        known = ("a", "alpha", "d", "theta", "limits", "speed", "effort", *mass)
        if unknown := sorted(set(changes) - set(known)):
            raise ArmError(f"{self.name}: a row has no {unknown[0]}; expected {', '.join(known)}")
        of_joint = [name for name in ("limits", "speed", "effort") if name in changes]
        if of_joint and number not in self.joints:
            listing = ", ".join(map(str, self.joints))
            raise ArmError(
                f"{self.name}: row {number} is fixed and has no {of_joint[0]}; expected one of the"
                f" rows with joints, {listing}"
            )
        warn_of_units(*(changes.get(name, 0) for name in ("a", "alpha", "d", "theta")))
        entries = {name: changes.get(name, old) for name, old in _entries_by_name(row).items()}
        rows, bodies = [*self.rows], [*self.bodies]
        rows[number - 1] = Row(**entries, joint=change_joint(row.joint, changes))
        if "mass" in changes:
            bodies[number - 1] = replace(bodies[number - 1], mass=changes["mass"])
        return replace(self, rows=rows, bodies=bodies)

    def with_bodies(self, bodies: Iterable[Body], name: str | None = None) -> Arm:
        """Return the arm with other bodies.

        Args:
            bodies: One `Body` for each row, or none for an arm without masses.
            name: A new name; the old one by default.

        Example:
            >>> from helpers.robots import PANDA
            >>> PANDA.with_bodies([], name="Panda without masses").bodies
            ()
        """
        bodies = tuple_of_items(bodies, f"{self.name}: bodies", "one Body for each row")
        return replace(self, name=self.name if name is None else name, bodies=bodies)

    def with_base(self, pose: ArrayLike) -> Arm:
        """Return the arm on a base: the pose of its frame 0 in the world.

        The base becomes a fixed row before the others, unless it only turns about z and shifts
        along z. Joints are numbered by their rows, so joint 1 is then joint 2.

        Args:
            pose: A transform (4, 4), or (x, y, z, roll, pitch, yaw) in m and rad, where
                R = Rot_z(yaw) Rot_y(pitch) Rot_x(roll).

        Raises:
            ArmError: `pose` is neither.

        Example:
            >>> from helpers.robots import ELBOW
            >>> ELBOW.with_base((0, 0, 0.8, 0, 0, "pi/2")).rows[0].entries
            (0, 'pi/2', 'd_1 + 0.8', 'pi/2')
            >>> ELBOW.with_base((0, 0, 2.5, "pi", 0, 0)).variables
            ('q_2', 'q_3', 'q_4')
        """
        a, alpha, d, theta, last_d, last_theta = split_pose(
            pose, f"{self.name}: the pose of the base"
        )
        if a == 0 and alpha == 0:
            first, last_d, last_theta = [], _add_entries(d, last_d), _add_entries(theta, last_theta)
        else:
            first = [fixed(a, alpha, d, theta)]
        row = self.rows[0]
        moved = replace(
            row, d=_add_entries(row.d, last_d), theta=_add_entries(row.theta, last_theta)
        )
        bodies = [Body(0, (0, 0, 0))] * len(first) if self.bodies else []
        return replace(self, rows=(*first, moved, *self.rows[1:]), bodies=(*bodies, *self.bodies))

    def with_tool(self, pose: ArrayLike) -> Arm:
        """Return the arm with a tool: the pose of the tool's tip in the arm's last frame.

        The tool becomes one or two fixed rows behind the others, without mass.

        Args:
            pose: A transform (4, 4), or (x, y, z, roll, pitch, yaw) in m and rad, where
                R = Rot_z(yaw) Rot_y(pitch) Rot_x(roll).

        Raises:
            ArmError: `pose` is neither.

        Example:
            >>> from helpers.robots import ELBOW
            >>> ELBOW.with_tool((0, 0, 0.1, 0, 0, 0)).rows[-1].entries
            (0, 0, 0.1, 0)
        """
        a, alpha, d, theta, last_d, last_theta = split_pose(
            pose, f"{self.name}: the pose of the tool"
        )
        if a == 0 and alpha == 0:
            tool = [fixed(0, 0, _add_entries(d, last_d), _add_entries(theta, last_theta))]
        else:
            tool = [fixed(a, alpha, d, theta)]
            if (last_d, last_theta) != (0, 0):
                tool.append(fixed(0, 0, last_d, last_theta))
        bodies = [Body(0, (0, 0, 0))] * len(tool) if self.bodies else []
        return replace(self, rows=(*self.rows, *tool), bodies=(*self.bodies, *bodies))

    def lock(self, joint: int, at: Entry = 0) -> Arm:
        """Return the arm with one joint locked at a value.

        Its row becomes a fixed row.

        Args:
            joint: Number of the joint, which is that of its row; see `variables`.
            at: Value at which it is locked, in rad or m; a number or a formula.

        Returns:
            The arm, with one joint fewer; `home` loses that joint's value.

        Example:
            >>> from helpers.robots import PANDA
            >>> PANDA.lock(3).variables
            ('q_1', 'q_2', 'q_4', 'q_5', 'q_6', 'q_7')
        """
        row = self._require_row(
            joint, self.joints, "joint {} cannot be locked; its free joints are"
        )
        at = check_entry(at, "at")
        evaluate_entry(at, self.values)  # raises ArmError if a symbol has no value
        column = "theta" if row.joint.kind == "revolute" else "d"
        entries = {**_entries_by_name(row), column: _add_entries(getattr(row, column), at)}
        locked = Row(**entries, joint=Joint("fixed", at=at))
        keep = [x for i, x in zip(self.joints, self.home, strict=True) if i != joint]
        rows = (*self.rows[: joint - 1], locked, *self.rows[joint:])
        return replace(self, rows=rows, home=tuple(keep), circle=None)

    def _require_row(self, number: object, allowed: Sequence[int], message: str) -> Row:
        """Return a row by its number, counted from 1.

        Raises ArmError if the row is not allowed.
        """
        if isinstance(number, int | np.integer) and number in allowed and number is not True:
            return self.rows[int(number) - 1]
        listing = ", ".join(map(str, allowed))
        raise ArmError(f"{self.name}: {message.format(shorten(number))} {listing}")

    def insert_locked(self, q: ArrayLike) -> Array:
        """Insert the values of the locked joints.

        Args:
            q: Joint values of this arm, shape (..., dof).

        Returns:
            Joint values of the arm whose joints this one locks, shape (..., dof + locked).

        Example:
            >>> from helpers.robots import PANDA
            >>> PANDA.lock(3, at=0.5).insert_locked([1, 2, 4, 5, 6, 7])
            array([1. , 2. , 0.5, 4. , 5. , 6. , 7. ])
        """
        q = self.joint_vector(q)
        numbers = sorted([*self.joints, *self.locked])
        free = np.empty((*q.shape[:-1], len(numbers)))
        free[..., [numbers.index(i) for i in self.joints]] = q
        for i, at in self.locked.items():
            free[..., numbers.index(i)] = at
        return free

    def remove_locked(self, q: ArrayLike) -> Array:
        """Leave out the values of the locked joints.

        This is the inverse of `insert_locked`.

        Args:
            q: Joint values of the arm whose joints this one locks, shape (..., dof + locked).

        Returns:
            Joint values of this arm, shape (..., dof).

        Example:
            >>> from helpers.robots import PANDA
            >>> PANDA.lock(3).remove_locked([1, 2, 3, 4, 5, 6, 7])
            array([1., 2., 4., 5., 6., 7.])
        """
        numbers = sorted([*self.joints, *self.locked])
        listing = ", ".join(map(str, numbers))
        expected = f"(..., {len(numbers)}), one value for each of joints {listing}"
        free = finite_array(q, f"{self.name}: q", expected, (len(numbers),), many=True)
        return free[..., [numbers.index(i) for i in self.joints]]

    @property
    def to_free(self) -> Callable[[ArrayLike], Array]:
        """The old name of `insert_locked`."""
        warn_renamed("Arm.to_free", "Arm.insert_locked")
        return self.insert_locked

    @property
    def from_free(self) -> Callable[[ArrayLike], Array]:
        """The old name of `remove_locked`."""
        warn_renamed("Arm.from_free", "Arm.remove_locked")
        return self.remove_locked

    # Numbers to compute with

    def joint_vector(self, q: ArrayLike, name: str = "q", many: bool = True) -> Array:
        """Convert joint values to an array and check its shape.

        Args:
            q: Joint values, shape (..., dof), or (dof,) unless `many`.
            name: What messages call the argument.
            many: Whether a batch of joint vectors is allowed.

        Raises:
            ArmError: q has another length, or holds NaN or infinity.
        """
        shape = (
            f"numbers (..., {self.dof})" if many else f"one configuration, numbers ({self.dof},)"
        )
        expected = f"{shape}, one value for each of {', '.join(self.variables)}"
        values = finite_array(q, f"{self.name}: {name}", expected, (self.dof,), many)
        if values.size and np.abs(values).max() > MANY_TURNS:
            self._warn_of_degrees_in(values, name)
        return values

    def _warn_of_degrees_in(self, q: Array, name: str) -> None:
        """Warn if the large joint angles are all multiples of 0.5, and hence probably degrees.

        An iteration that diverges passes large angles too, but not round ones.
        """
        angles = np.abs(q[..., self.turning])
        large = angles[angles > MANY_TURNS]
        if large.size and (2 * large == np.round(2 * large)).all():
            warnings.warn(
                f"{self.name}: {name} has an angle of {angles.max():g} rad, more than four turns;"
                " for degrees write np.radians(...)",
                stacklevel=4,
            )

    @cached_property
    def numeric(self) -> tuple[NumericRow, ...]:
        """The rows in numbers."""
        rows = []
        for row in self.rows:
            a, alpha, d, theta = map(self.number, row.entries)
            rows.append(NumericRow(row.joint.kind, a, d, *cos_sin(alpha), theta, *cos_sin(theta)))
        return tuple(rows)

    @cached_property
    def programs(self) -> dict:
        """The programs that `helpers.program` has recorded for this arm."""
        return {}

    def number(self, value: Entry) -> float:
        """Compute the number that an entry of this arm's rows or bodies stands for."""
        return evaluate_entry(value, self.values)

    # Text

    def __repr__(self) -> str:
        letters = "".join(self.rows[i - 1].joint.kind[0].upper() for i in self.joints)
        return f"<Arm {self.name}: {len(self.rows)} rows, {letters or 'no joint'}>"

    def _repr_markdown_(self) -> str:
        header = "| $i$ | $a_i$ | $\\alpha_i$ | $d_i$ | $\\theta_i$ |\n|:-:|:-:|:-:|:-:|:-:|\n"
        lines = []
        for i, row in enumerate(self.rows, 1):
            a, alpha, d, theta = map(entry_latex, row.entries)
            if row.joint.kind == "revolute":
                theta = _with_variable(i, row.theta)
            if row.joint.kind == "prismatic":
                d = _with_variable(i, row.d)
            lines.append(f"| {i} | ${a}$ | ${alpha}$ | ${d}$ | ${theta}$ |")
        used = {name for row in self.rows for e in row.entries for name in symbol_names(e)}
        values = ", ".join(
            f"${entry_latex(k)} = {v:g}$" for k, v in self.values.items() if k in used
        )
        caption = f"{self.name}: {values} (m)" if values else self.name
        return header + "\n".join(lines) + f"\n\n{caption}"


def require_joints(arm: object) -> None:
    """Raise ArmError unless the argument is an arm with one joint or more."""
    require_type(arm, Arm, "arm")
    if isinstance(arm, Arm) and not arm.dof:
        raise ArmError(f"{arm.name} has no joints; expected an arm with one joint or more")


def _entries_by_name(row: Row) -> dict[str, Entry]:
    return dict(zip(("a", "alpha", "d", "theta"), row.entries, strict=True))


def _add_entries(first: Entry, second: Entry) -> Entry:
    if first == 0:
        return second
    return first if second == 0 else f"{first} + {second}"


def _with_variable(i: int, offset: Entry) -> str:
    """Write a joint's variable plus its offset in LaTeX."""
    text = entry_latex(offset)
    if offset == 0:
        return f"q_{{{i}}}"
    return f"q_{{{i}}} - {text[1:]}" if text.startswith("-") else f"q_{{{i}}} + {text}"
