"""Test that every check of the book can fail.

A check that compares a value with itself proves nothing. The test reads the statements of a chapter
in order and replaces each name by the expression that was last assigned to it. Three rules hold for
`check(label, actual, expected)`: the two expanded sides differ; at least one of them depends on the
helpers, since arithmetic within the cell would pass whatever the helpers do; and `book_only` checks
expect a literal, since two derivations agree for any arm.
"""

import ast
from copy import deepcopy
from itertools import count

import nbformat
import pytest

from tools.numbering import list_notebooks

# Checks of chapter 1's UR10e table. With a_2 = 0 two axes coincide, so that other frames would
# also be right.
FREE_FRAMES = {"a, α, d, θ by eye (m, °)", "frames of the homework's table"}

NOTEBOOKS = list_notebooks()
# Labels of checks of algebra or of a report's arithmetic, for which the helpers have no function.
CHECKS_WITHOUT_HELPERS = {
    "the appendix's 40 pi, in mm/s",
    "at rest only dP/dq is left",
    "det B_rpy = cos θ",
    "det B_zyz = -sin θ",
    "Craig's J = differences",
}
HELPED = "helped"  # prefix of symbols that depend on the helpers


class SymbolTable(ast.NodeTransformer):
    """Give each distinct expression a symbol and each name the symbol of its last value."""

    def __init__(self):
        self.names, self.symbols, self.numbers = {}, {}, count()

    def visit_Name(self, node):
        return ast.Name(self.names.get(node.id, node.id))

    def visit_scope(self, node):
        """Keep symbols of names that a comprehension, lambda or function binds in its own scope."""
        bound = [part.target for part in getattr(node, "generators", ())] or [node.args]
        parts = [part for target in bound for part in ast.walk(target)]
        local = {getattr(part, "id", None) or getattr(part, "arg", None) for part in parts}
        outer = self.names
        self.names = {name: symbol for name, symbol in outer.items() if name not in local}
        self.generic_visit(node)
        self.names = outer
        return node

    visit_ListComp = visit_SetComp = visit_GeneratorExp = visit_DictComp = visit_scope
    visit_Lambda = visit_FunctionDef = visit_scope

    def new_symbol(self, *parts):
        """Return an unused symbol, which depends on the helpers if one of its parts does."""
        return f"{HELPED * any(HELPED in part for part in parts)}_{next(self.numbers)}"

    def symbol(self, node):
        """Return the symbol of an expression; equal expressions share one."""
        expanded = self.visit(deepcopy(node))
        text = ast.unparse(expanded)
        if isinstance(expanded, ast.Name):
            return text
        return self.symbols.get(text) or self.symbols.setdefault(text, self.new_symbol(text))

    def bind(self, target, symbol):
        """Assign a symbol to a name, or its items to the names of a tuple."""
        if isinstance(target, ast.Name):
            self.names[target.id] = symbol
        elif isinstance(target, ast.Tuple | ast.List):
            for i, part in enumerate(target.elts):
                self.bind(
                    part, self.symbol(ast.Subscript(ast.Name(symbol, ast.Load()), ast.Constant(i)))
                )
        else:  # x[i] = y, x.a = y, *x
            self.change(target, ast.Name(symbol, ast.Load()))

    def change(self, target, *values):
        """Give each name in a changed target a new symbol."""
        names = [node.id for node in ast.walk(target) if isinstance(node, ast.Name)]
        before = [self.names.get(name, name) for name in names]
        symbol = self.new_symbol(*before, *map(self.symbol, values))
        self.names |= dict.fromkeys(names, symbol)

    def read(self, node):
        """Read a statement and yield its checks: the call, and the symbols of both sides."""
        match node:
            case ast.ImportFrom(module=module, names=names):
                start = HELPED if (module or "").startswith(("helpers", "course")) else ""
                self.names |= {n.asname or n.name: f"{start}_{module}_{n.name}" for n in names}
            case ast.FunctionDef(name=name):
                self.names[name] = self.symbol(node)
                return
            case ast.Call(func=ast.Name(id="check")):
                yield node, *self.sides(node)
            case ast.Call(func=ast.Attribute(value=value, attr="append" | "update" | "extend")):
                self.change(value, *node.args)
            case ast.For(target=target, iter=values):
                self.change(target, values)
        for child in ast.iter_child_nodes(node):
            yield from self.read(child)
        match node:
            case ast.Assign(targets=[ast.Tuple(elts=targets)], value=ast.Tuple(elts=values)):
                for target, symbol in zip(targets, [*map(self.symbol, values)], strict=True):
                    self.bind(target, symbol)
            case ast.Assign(targets=targets, value=value):
                symbol = self.symbol(value)
                for target in targets:
                    self.bind(target, symbol)
            case ast.AugAssign(target=target, value=value):
                self.change(target, value)

    def sides(self, call):
        """Return the symbols of `actual` and `expected` of a check."""
        named = {key.arg: key.value for key in call.keywords}
        both = [*call.args[1:], *(named[name] for name in ("actual", "expected") if name in named)]
        if isinstance(both[0], ast.Starred):
            return [self.symbol(ast.Subscript(both[0].value, ast.Constant(i))) for i in (0, 1)]
        return [self.symbol(side) for side in both[:2]]


def find_weak_checks(sources):
    """Return a message for each check in the cells that cannot fail."""
    table, messages = SymbolTable(), []
    for node, actual, expected in (c for s in sources for c in table.read(ast.parse(s))):
        label = ast.literal_eval(node.args[0]) if isinstance(node.args[0], ast.Constant) else "?"
        if actual == expected:
            messages.append(f"{label}: both sides are {ast.unparse(node.args[1])}")
        elif HELPED not in actual + expected and label not in CHECKS_WITHOUT_HELPERS:
            messages.append(f"{label}: neither side depends on the helpers")
        is_book_only = any(key.arg == "book_only" for key in node.keywords)
        if HELPED in expected and is_book_only and label not in FREE_FRAMES:
            messages.append(
                f"{label}: book_only, though the expected value is computed for any arm"
            )
    return messages


@pytest.mark.parametrize("path", NOTEBOOKS, ids=lambda path: path.stem)
def test_notebook_checks_compare_independent_values(path):
    cells = nbformat.read(path, as_version=4).cells
    assert find_weak_checks(cell.source for cell in cells if cell.cell_type == "code") == []


HEAD = "from helpers import kinematics\nfrom helpers.robots import PANDA\n"
J = "J = kinematics.jacobian(PANDA, q)\n"


@pytest.mark.parametrize(
    ("source", "is_weak"),
    [
        (f"{J}K = J\ncheck('J', K[:3], J[:3])", True),
        (f"{J}check('J', kinematics.jacobian(PANDA, q), J)", True),
        ("a, b = 0.0880, 0.0825\ngap = a - b\ncheck('gap', gap, 0.0055, tolerance=1e-9)", True),
        (f"{J}K = J\nJ[0] = 1\ncheck('J', K, J)", False),
        (f"{J}a, b = J, 0\na, b = b, a\ncheck('J', b, J)", True),
        (f"{J}q = 2 * q\ncheck('J', kinematics.jacobian(PANDA, q), J)", False),
        (f"{J}def f(J):\n    return 2 * J\ncheck('f', f(1), 2)", True),
        (f"for arm in arms:\n    {J}    check('J', J, J)", True),
        ("check('tip', kinematics.tip(PANDA, q), 2 * np.ones(3), 1e-9, book_only=True)", False),
        ("p = [0, 0, PANDA.values['d_1']]\ncheck('p', tip, p, 1, book_only=True)", True),
    ],
)
def test_self_comparison_is_detected(source, is_weak):
    assert bool(find_weak_checks([HEAD, source])) == is_weak
