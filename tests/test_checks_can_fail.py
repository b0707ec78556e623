"""A check that compares a thing with itself proves nothing, however green its line: every check of
the book is read here.

The cells are read in their order, and each name stands for the expression that it was bound to
last, which in turn stands for its own. So written out, the two sides of `check(label, actual,
expected)` must differ, and at least one must rest on the helpers: arithmetic that never leaves the
cell would stay green whatever became of them. And only a literal may be `book_only`: two
derivations agree on any arm.
"""

import ast
from pathlib import Path

import nbformat
import pytest

NOTEBOOKS = sorted((Path(__file__).parents[1] / "book").glob("*.ipynb"))
# Checks of the reader's own algebra or of a slip's arithmetic, which have no helper to ask.
BY_HAND = {
    "the appendix's 40 pi, in mm/s",
    "at rest only dP/dq is left",
}


class Reader(ast.NodeVisitor):
    """Reads statements in order; `meaning` has what each name stands for, written out, and whether
    helpers are in it."""

    def __init__(self):
        self.meaning, self.checks, self.count = {}, [], 0

    def of(self, node, hidden=frozenset()):
        """What an expression stands for, as a hashable tree, and whether it rests on the
        helpers."""
        if isinstance(node, ast.Name) and node.id not in hidden and node.id in self.meaning:
            return self.meaning[node.id]
        if isinstance(node, ast.AST):
            hidden |= _bound_inside(node)
            parts = [
                (name, self.of(value, hidden))
                for name, value in ast.iter_fields(node)
                if name != "ctx"
            ]
            tree = (type(node).__name__, *((name, part[0]) for name, part in parts))
            return _short(tree), any(part[1] for _, part in parts)
        if isinstance(node, list):
            parts = [self.of(item, hidden) for item in node]
            return tuple(part[0] for part in parts), any(part[1] for part in parts)
        return repr(node), False

    def bind(self, target, meaning):
        if isinstance(target, ast.Name):
            self.meaning[target.id] = meaning
        elif isinstance(target, ast.Tuple | ast.List):
            for i, part in enumerate(target.elts):
                self.bind(part, (("part", i, meaning[0]), meaning[1]))
        elif isinstance(target, ast.Starred):
            self.bind(target.value, meaning)
        else:  # x[i] = y, x.a = y: x is another thing from here on
            while not isinstance(target, ast.Name):
                target = target.value
            self.bind(target, self.anew(self.of(target), meaning))

    def anew(self, *meanings):
        self.count += 1
        return ("anew", self.count), any(helped for _, helped in meanings)

    def visit_ImportFrom(self, node):
        for name in node.names:
            helped = (node.module or "").startswith(("helpers", "course"))
            self.meaning[name.asname or name.name] = (("import", node.module, name.name), helped)

    def visit_Assign(self, node):
        self.visit(node.value)
        for target in node.targets:
            if isinstance(target, ast.Tuple) and isinstance(node.value, ast.Tuple):
                meanings = [self.of(value) for value in node.value.elts]
                for part, meaning in zip(target.elts, meanings, strict=True):
                    self.bind(part, meaning)
            else:
                self.bind(target, self.of(node.value))

    def visit_AugAssign(self, node):
        self.bind(node.target, self.anew(self.of(node.target), self.of(node.value)))

    def visit_For(self, node):
        self.bind(node.target, self.anew(self.of(node.iter)))
        self.generic_visit(node)

    def visit_FunctionDef(self, node):
        self.meaning.pop(node.name, None)
        self.meaning[node.name] = self.of(node, frozenset(arg.arg for arg in node.args.args))

    def sides(self, call):
        named = {key.arg: key.value for key in call.keywords}
        given = [*call.args[1:], *(named[name] for name in ("actual", "expected") if name in named)]
        if isinstance(given[0], ast.Starred):
            tree, helped = self.of(given[0].value)
            return [(("part", i, tree), helped) for i in (0, 1)]
        return [self.of(side) for side in given[:2]]

    def visit_Call(self, node):
        self.generic_visit(node)
        if isinstance(node.func, ast.Name) and node.func.id == "check":
            self.checks.append((node, *self.sides(node)))
        if isinstance(node.func, ast.Attribute) and node.func.attr in (
            "append",
            "update",
            "extend",
        ):
            self.bind(node.func.value, self.anew(self.of(node.func.value), self.of(node.args)))


def _short(tree):
    """The tree itself, or a number for it: equal trees have equal numbers, and nothing grows
    without bound."""
    return _NUMBERS.setdefault(tree, len(_NUMBERS))


_NUMBERS = {}


def _bound_inside(node):
    """Names that a comprehension, a lambda or a function binds for itself."""
    if isinstance(node, ast.ListComp | ast.SetComp | ast.GeneratorExp | ast.DictComp):
        inner = [name for generator in node.generators for name in ast.walk(generator.target)]
        return {name.id for name in inner if isinstance(name, ast.Name)}
    if isinstance(node, ast.Lambda | ast.FunctionDef):
        return {arg.arg for arg in node.args.args}
    return frozenset()


def read(sources):
    reader = Reader()
    for source in sources:
        reader.visit(ast.parse(source))
    return reader.checks


def complaints(sources):
    found = []
    for node, (actual, helped), (expected, helped_too) in read(sources):
        label = ast.unparse(node.args[0])
        if actual == expected:
            found.append(f"{label}: both sides are {ast.unparse(node.args[1])}")
        elif not (helped or helped_too) and label.strip("'\"") not in BY_HAND:
            found.append(f"{label}: neither side rests on the helpers")
        if helped_too and any(key.arg == "book_only" for key in node.keywords):
            found.append(f"{label}: open, though what is expected is computed for any arm")
    return found


@pytest.mark.parametrize("path", NOTEBOOKS, ids=lambda path: path.stem)
def test_no_check_of_the_book_compares_a_thing_with_itself(path):
    cells = nbformat.read(path, as_version=4).cells
    assert complaints(cell.source for cell in cells if cell.cell_type == "code") == []


HEAD = "from helpers import kinematics\nfrom helpers.robots import PANDA\n"


@pytest.mark.parametrize(
    ("source", "red"),
    [
        ("J = kinematics.jacobian(PANDA, q)\ncheck('J', J, J)", True),
        ("J = kinematics.jacobian(PANDA, q)\nK = J\ncheck('J', K[:3], J[:3])", True),
        ("check('J', kinematics.jacobian(PANDA, q), kinematics.jacobian(PANDA, q))", True),
        ("a, b = 0.0880, 0.0825\ngap = a - b\ncheck('gap', gap, 0.0055, tolerance=1e-9)", True),
        ("J = kinematics.jacobian(PANDA, q)\nK = J\nJ[0] = 1\ncheck('J', K, J)", False),
        (
            "J = kinematics.jacobian(PANDA, q)\nq = 2 * q\ncheck('J', kinematics.jacobian(PANDA,"
            " q), J)",
            False,
        ),
        ("for arm in arms:\n    J = kinematics.jacobian(arm, q)\n    check('J', J, J)", True),
        (
            "x = [kinematics.jacobian(PANDA, q) for q in a]\ny = [q for q in a]\ncheck('J', x, y)",
            False,
        ),
        ("check('tip', kinematics.forward_kinematics(PANDA, q)[:3, 3], [1, 2, 3])", False),
        ("check('tip', kinematics.tip(PANDA, q), 2 * np.ones(3), 1e-9, book_only=True)", False),
        (
            "p = [0, 0, PANDA.values['d_1']]\ncheck('p', tip, p, 1, book_only=True)",
            True,
        ),
        (
            "p = kinematics.tip(PANDA, q)\ncheck('p', p, kinematics.tip(UR10E, q), book_only=True)",
            True,
        ),
    ],
)
def test_what_is_found_and_what_is_not(source, red):
    assert bool(complaints([HEAD, source])) == red
