"""Compute the answers of a sheet, in symbols, and in numbers at the arm's home configuration."""

import re
from dataclasses import dataclass
from functools import cached_property
from itertools import pairwise

import numpy as np
import sympy as sp
from numpy.typing import NDArray

from helpers import kinematics, statics, symbolic
from helpers.arm import Arm
from helpers.formulas import abbreviate, short_names
from helpers.inputs import ArmError, require_type
from helpers.polynomials import is_long
from helpers.stepwise import StepwiseFormulas, stepwise_formulas

Array = NDArray[np.float64]

# Names that have a meaning in a program of the sheet or in a programming language.
_RESERVED = frozenset(
    (
        "np", "sp", "pi", "break", "case", "catch", "classdef", "continue", "else",
        "elseif", "end", "for", "function", "global", "if", "otherwise", "parfor",
        "persistent", "return", "spmd", "switch", "try", "while", "print", "disp", "det_J",
        "G", "P", "J", "g", "cos", "sin", "sqrt", "q", "Matrix", "symbols", "Rational",
    )
)  # fmt: skip
_SHEET_NAMES = re.compile(r"[cs]_[\dmp]+|[AToz]_\d+|[mq]_\d+|[xyz]_c\d+|[xyzop]_\d+[xyz]")
_NAME = re.compile(r"[A-Za-z][A-Za-z0-9_]{0,62}")


@dataclass(frozen=True, eq=False)
class Answer:
    """An answer of a sheet.

    Attributes:
        name: its name in programs, such as ``T_03``, ``J`` or ``det_J``.
        value: its entries in short symbols; a vector has one column, a number one entry.
        home_values: its entries at the arm's home configuration, in numbers.
        definitions: formulas of its short symbols, such as cos(q_2 + q_3) for c_23, each before
            the definitions that use it.
    """

    name: str
    value: sp.ImmutableMatrix
    home_values: Array
    definitions: dict[sp.Symbol, sp.Expr]

    @property
    def is_number(self) -> bool:
        """Return whether the answer has one entry."""
        return self.value.shape == (1, 1)


class AnswerSheet:
    """All answers for an arm, with numbers at its home configuration.

    Formulas that would be too long (`helpers.polynomials.is_long`) are written in named steps,
    without the determinant.

    Raises:
        ArmError: `arm` is not an Arm or has no joints, or one of its symbols has a name that a
            program on the sheet cannot use.
    """

    def __init__(self, arm: Arm) -> None:
        require_type(arm, Arm, "arm")
        if not arm.dof:
            raise ArmError(f"{arm.name} has no joints; a sheet needs an arm that moves")
        for name in arm.values:
            if name in _RESERVED or _SHEET_NAMES.fullmatch(name) or not _NAME.fullmatch(name):
                raise ArmError(
                    f"{arm.name} has a letter called {name}, which a program on its sheet cannot"
                    " use, or needs for something else; expected another name, as a_2 or l_pen"
                )
        self.arm = arm
        self.home_values = compute_home_values(arm)

    # Answers

    @cached_property
    def link_matrices(self) -> list[Answer]:
        """A_1 .. A_n, each 4x4."""
        matrices = enumerate(symbolic.link_transforms(self.arm), 1)
        return [self._make_answer(f"A_{i}", A) for i, A in matrices]

    @cached_property
    def frames(self) -> list[Answer]:
        """T_01 .. T_0n, each 4x4."""
        return [self._make_answer(f"T_0{i}", T) for i, T in enumerate(self._frame_matrices)][1:]

    @cached_property
    def origins(self) -> list[Answer]:
        """o_0 .. o_n, each 3x1."""
        return [self._make_answer(f"o_{i}", T[:3, 3]) for i, T in enumerate(self._frame_matrices)]

    @cached_property
    def axes(self) -> list[Answer]:
        """z_0 .. z_n, each 3x1."""
        return [self._make_answer(f"z_{i}", T[:3, 2]) for i, T in enumerate(self._frame_matrices)]

    @cached_property
    def _frame_matrices(self) -> list[sp.ImmutableMatrix]:
        return self.steps.frames if self.steps else symbolic.link_frames(self.arm)

    @cached_property
    def steps(self) -> StepwiseFormulas | None:
        """Formulas in named steps, or None if the written-out formulas are short enough."""
        return stepwise_formulas(self.arm) if is_long(self.arm) else None

    @cached_property
    def jacobian(self) -> Answer:
        """J, 6 x dof."""
        J = self.steps.jacobian if self.steps else symbolic.jacobian(self.arm)
        return self._make_answer("J", J)

    @cached_property
    def determinant(self) -> Answer | None:
        """det J for six joints, or the determinant of the first three rows of J for three joints.

        It is None for other numbers of joints, and for formulas in named steps.
        """
        if "det_J" not in self.home_values or self.steps:
            return None
        return self._make_answer("det_J", sp.ImmutableMatrix([[symbolic.determinant(self.arm)]]))

    @cached_property
    def energy_and_torques(self) -> list[Answer]:
        """Potential energy P (J) and torques g(q) = dP/dq, dof x 1, of an arm with masses.

        The torques are in N m, or in N for a joint that slides. Programs call them G.
        """
        if not self.arm.bodies:
            return []
        if self.steps:
            energy, torque = self.steps.energy, self.steps.torque
        else:
            energy = symbolic.potential_energy(self.arm)
            torque = symbolic.gravity_torque(self.arm)
        return [
            self._make_answer("P", sp.ImmutableMatrix([[energy]])),
            self._make_answer("G", torque),
        ]

    @cached_property
    def answers(self) -> list[Answer]:
        """All answers, in the order of the homework."""
        determinant = [self.determinant] if self.determinant else []
        kinematics = [*self.link_matrices, *self.frames, *self.origins, *self.axes, self.jacobian]
        return [*kinematics, *determinant, *self.energy_and_torques]

    def _make_answer(self, name: str, value: sp.ImmutableMatrix) -> Answer:
        """Return an answer with abbreviated symbols.

        Decimal fractions become decimals. Coordinates of a centre of mass are called x_c1, since
        z_1 is an axis on the sheet.
        """
        value = self._use_decimals(value)
        steps = self._find_steps(value)
        names = {
            f: n for formula in (value, *steps.values()) for f, n in short_names(formula).items()
        }
        pairs = [(symbol, function) for function, symbol in names.items()]
        definitions = dict(sorted(pairs, key=lambda pair: (str(pair[1].args), str(pair[0]))))
        definitions |= {step: abbreviate(formula) for step, formula in steps.items()}
        return Answer(name, abbreviate(value), self.home_values[name], definitions)

    def _use_decimals(self, formula):
        """Replace fractions by decimals, and z_1 of a centre of mass by z_c1."""
        fractions = (number for number in formula.atoms(sp.Rational) if number.q > 1)
        decimals = {number: sp.Float(number) for number in fractions if 10**9 % number.q == 0}
        return formula.xreplace({**self._centre_symbols, **decimals})

    def _find_steps(self, value: sp.ImmutableMatrix) -> dict[sp.Symbol, sp.Expr]:
        """Return the named steps that a value needs, in their order."""
        needed, steps = value.free_symbols, {}
        for name, formula in reversed(self._decimal_steps.items()):
            if name in needed:
                needed = needed | formula.free_symbols
                steps[name] = formula
        return dict(reversed(steps.items()))

    @cached_property
    def _decimal_steps(self) -> dict[sp.Symbol, sp.Expr]:
        definitions = self.steps.definitions if self.steps else {}
        return {name: self._use_decimals(formula) for name, formula in definitions.items()}

    # Meaning of the symbols

    @cached_property
    def symbol_values(self) -> dict[str, float]:
        """Values of lengths, angles, masses, centres of mass and g by symbol."""
        lengths = {name: value for name, value in self.arm.values.items() if value}
        if not self.arm.bodies:
            return lengths
        bodies = symbolic.body_numbers(self.arm)
        # Twelve digits remove round-off from centres of mass: 0.02933, not
        # 0.029330000000000002.
        return lengths | {
            self._centre_symbols.get(symbol, symbol).name: float(f"{value:.12g}")
            for symbol, value in bodies.items()
        }

    @cached_property
    def _centre_symbols(self) -> dict[sp.Symbol, sp.Symbol]:
        bodies = symbolic.body_numbers(self.arm)
        return {s: sp.Symbol(s.name.replace("_", "_c")) for s in bodies if s.name[0] in "xyz"}


def compute_home_values(arm: Arm) -> dict[str, Array]:
    """Return the numbers of all answers at the home configuration, by name."""
    q = np.array(arm.home)
    frames, J = kinematics.link_frames(arm, q), kinematics.jacobian(arm, q)
    values = {f"A_{i}": np.linalg.inv(a) @ b for i, (a, b) in enumerate(pairwise(frames), 1)}
    for i, T in enumerate(frames):
        values |= {f"T_0{i}": T, f"o_{i}": T[:3, [3]], f"z_{i}": T[:3, [2]]}
    values["J"] = J
    if arm.dof in (3, 6):
        values["det_J"] = np.array([[np.linalg.det(J[: arm.dof])]])
    if arm.bodies:
        values["P"] = statics.potential_energy(arm, q).reshape(1, 1)
        values["G"] = statics.gravity_torque(arm, q)[:, None]
    return values
