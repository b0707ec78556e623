"""What an answer sheet holds: every matrix and vector of an arm's homework, in symbols and at its
home pose in numbers.
"""

import re
from dataclasses import dataclass
from functools import cached_property
from itertools import pairwise

import numpy as np
import sympy as sp
from numpy.typing import NDArray

from helpers import kinematics, statics, symbolic
from helpers.arm import Arm
from helpers.inputs import ArmError, must_be

Array = NDArray[np.float64]

# Names that a program on the sheet, or one of its languages, uses for something else.
_TAKEN = frozenset(
    (
        "np", "sp", "pi", "break", "case", "catch", "classdef", "continue", "else",
        "elseif", "end", "for", "function", "global", "if", "otherwise", "parfor",
        "persistent", "return", "spmd", "switch", "try", "while", "print", "disp", "det_J",
        "G", "P", "J", "g", "cos", "sin", "sqrt", "q",
    )
)  # fmt: skip
_OURS = re.compile(r"[cs]_[\dmp]+|[AToz]_\d+|[mq]_\d+|[xyz]_c\d+")
_NAME = re.compile(r"[A-Za-z][A-Za-z0-9_]{0,62}")


@dataclass(frozen=True, eq=False)
class Item:
    """One answer.

    Attributes:
        name: what programs call it, as ``T_03``, ``J`` or ``det_J``.
        value: its entries in symbols; a vector is one column, a number one entry.
        home: the same at the arm's home pose, in numbers.
    """

    name: str
    value: sp.ImmutableMatrix
    home: Array

    @property
    def is_matrix(self) -> bool:
        """Whether it has rows and columns."""
        return self.value.cols > 1

    @property
    def is_number(self) -> bool:
        """Whether it has one entry."""
        return self.value.shape == (1, 1)


class Sheet:
    """The answers of an arm. Numbers are taken at its home pose.

    Raises:
        ArmError: no Arm, or one whose letters have names that a program cannot use, or needs for
            something else.
    """

    def __init__(self, arm: Arm) -> None:
        must_be(arm, Arm, "arm")
        for name in arm.values:
            if name in _TAKEN or _OURS.fullmatch(name) or not _NAME.fullmatch(name):
                raise ArmError(
                    f"{arm.name} has a letter called {name}, which a program on its sheet cannot"
                    " use, or needs for something else; expected another name, as a_2 or l_pen"
                )
        self.arm = arm
        self.home = np.array(arm.home)
        self._short: dict[str, sp.ImmutableMatrix] = {}

    # The answers

    @cached_property
    def links(self) -> list[Item]:
        """A_1 .. A_n, each 4x4."""
        frames = kinematics.link_frames(self.arm, self.home)
        steps = [np.linalg.inv(a) @ b for a, b in pairwise(frames)]
        found = symbolic.link_transforms(self.arm)
        return [
            Item(f"A_{i}", A, at) for i, (A, at) in enumerate(zip(found, steps, strict=True), 1)
        ]

    @cached_property
    def frames(self) -> list[Item]:
        """T_01 .. T_0n, each 4x4."""
        at_home = kinematics.link_frames(self.arm, self.home)
        pairs = list(zip(symbolic.link_frames(self.arm), at_home, strict=True))
        return [Item(f"T_0{i}", T, at) for i, (T, at) in enumerate(pairs[1:], 1)]

    @cached_property
    def origins(self) -> list[Item]:
        """o_0 .. o_n, each 3x1."""
        return self._columns("o", 3)

    @cached_property
    def axes(self) -> list[Item]:
        """z_0 .. z_n, each 3x1."""
        return self._columns("z", 2)

    def _columns(self, letter: str, column: int) -> list[Item]:
        base = Item("T_00", sp.ImmutableMatrix(sp.eye(4)), np.eye(4))
        frames = enumerate([base, *self.frames])
        return [Item(f"{letter}_{i}", T.value[:3, column], T.home[:3, [column]]) for i, T in frames]

    @cached_property
    def jacobian(self) -> Item:
        """J, 6 x dof."""
        return Item("J", symbolic.jacobian(self.arm), kinematics.jacobian(self.arm, self.home))

    @cached_property
    def determinant(self) -> Item | None:
        """det J of a six-joint arm, or of the first three rows of J for three joints; else None."""
        dof = self.arm.dof
        if dof not in (3, 6):
            return None
        value = sp.ImmutableMatrix([[symbolic.determinant(self.arm)]])
        return Item("det_J", value, np.array([[np.linalg.det(self.jacobian.home[:dof])]]))

    @cached_property
    def energy(self) -> Item | None:
        """P, the potential energy (J), where the arm has masses."""
        if not self.arm.bodies:
            return None
        value = sp.ImmutableMatrix([[self._named(symbolic.potential_energy(self.arm))]])
        return Item("P", value, statics.potential_energy(self.arm, self.home).reshape(1, 1))

    @cached_property
    def torques(self) -> Item | None:
        """g(q) = dP/dq, dof x 1 (N m, or N where a joint slides), where the arm has masses;
        programs call it G.
        """
        if not self.arm.bodies:
            return None
        value = self._named(symbolic.gravity_torque(self.arm))
        return Item("G", value, statics.gravity_torque(self.arm, self.home)[:, None])

    @cached_property
    def items(self) -> list[Item]:
        """All answers, in the order of the homework."""
        single = [self.jacobian, self.determinant, self.energy, self.torques]
        several = [*self.links, *self.frames, *self.origins, *self.axes]
        return [*several, *(item for item in single if item is not None)]

    # What their letters mean

    @cached_property
    def values(self) -> dict[str, float]:
        """The numbers of all letters but the joint variables: lengths, angles, masses, centres of
        mass and g.
        """
        lengths = {name: value for name, value in self.arm.values.items() if value}
        if not self.arm.bodies:
            return lengths
        bodies = symbolic.body_numbers(self.arm)
        # Twelve digits free a centre of mass from rounding: 0.02933 rather than
        # 0.029330000000000002.
        return lengths | {self._centre(s).name: float(f"{v:.12g}") for s, v in bodies.items()}

    def _named(self, expression):
        """With x_c1 for the coordinate x_1 of a centre of mass, for z_1 is an axis here."""
        bodies = symbolic.body_numbers(self.arm)
        return expression.xreplace({symbol: self._centre(symbol) for symbol in bodies})

    @staticmethod
    def _centre(symbol: sp.Symbol) -> sp.Symbol:
        return sp.Symbol(re.sub(r"^([xyz])_", r"\1_c", symbol.name))

    @cached_property
    def short_names(self) -> dict[sp.Expr, sp.Symbol]:
        """The letters that stand for cosines and sines: c_23 for cos(q_2 + q_3)."""
        functions = {f for item in self.items for f in item.value.atoms(sp.cos, sp.sin)}
        pairs = {f: symbolic.short(f) for f in functions}
        names = [name for name in pairs.values() if isinstance(name, sp.Symbol)]
        return {f: n for f, n in pairs.items() if isinstance(n, sp.Symbol) and names.count(n) == 1}

    def shortened(self, item: Item) -> sp.ImmutableMatrix:
        """An answer with c_23 for cos(q_2 + q_3), its terms gathered: lengths by the angles, or
        angles by the length.
        """
        if item.name not in self._short:
            self._short[item.name] = self._short_form(item)
        return self._short[item.name]

    def _short_form(self, item: Item) -> sp.ImmutableMatrix:
        short = item.value.xreplace(self.short_names)
        if item.name == "det_J":
            return short
        turning = frozenset(self.short_names.values())
        return short.applyfunc(lambda entry: _gathered(entry, turning, item.name in ("P", "G")))

    def used(self, item: Item) -> tuple[list[str], list[str], list[tuple[sp.Symbol, sp.Expr]]]:
        """What an answer is written with: joint variables, letters that have values, and cosines
        and sines in short.
        """
        free = {symbol.name for symbol in item.value.free_symbols}
        functions = item.value.atoms(sp.cos, sp.sin)
        short = [(n, f) for f, n in self.short_names.items() if f in functions]
        return (
            [name for name in self.arm.variables if name in free],
            [name for name in self.values if name in free],
            sorted(short, key=lambda pair: (sp.default_sort_key(pair[1].args[0]), pair[0].name)),
        )


def _gathered(entry: sp.Expr, turning: frozenset[sp.Symbol], by_angles: bool) -> sp.Expr:
    """A sum of products, gathered by what they have in common: their cosines and sines, or else
    their lengths.

    What turns out to be multiplied by the same is put together: (d_6 + l_pen) c_1.
    """
    sums: dict[sp.Expr, sp.Expr] = {}
    for term in sp.Add.make_args(sp.expand(entry)):
        lengths, angles = term.as_independent(*turning)
        key, part = (angles, lengths) if by_angles else (lengths, angles)
        number, key = key.as_coeff_Mul()
        sums[key] = sums.get(key, sp.S.Zero) + number * part
    shared: dict[sp.Expr, sp.Expr] = {}
    for key, total in sums.items():
        total = sp.gcd_terms(total)
        shared[total] = shared.get(total, sp.S.Zero) + key
    return sp.Add(*(sp.Mul(key, total) for total, key in shared.items()))
