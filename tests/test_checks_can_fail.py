"""A check that compares a thing with itself proves nothing, however green its line: every check of
the book is read here.

The statements are read in their order, and each name stands for what it was bound to last. So
written out, the two sides of `check(label, actual, expected)` must differ, and at least one must
rest on the helpers: arithmetic that never leaves the cell would stay green whatever became of them.
And only a literal may be `book_only`: two derivations agree on any arm.
"""

import ast
from copy import deepcopy
from itertools import count
from pathlib import Path

import nbformat
import pytest

NOTEBOOKS = sorted((Path(__file__).parents[1] / "book").glob("*.ipynb"))
# Checks of the reader's own algebra or of a slip's arithmetic, which have no helper to ask.
BY_HAND = {
    "the appendix's 40 pi, in mm/s",
    "at rest only dP/dq is left",
}
HELPED = "helped"  # begins a word for what rests on the helpers


class Written(ast.NodeTransformer):
    """What has been read: of each name a word for what it is, of each text its word."""

    def __init__(self):
        self.names, self.words, self.numbers = {}, {}, count()

    def visit_Name(self, node):
        return ast.Name(self.names.get(node.id, node.id))

    def visit_scope(self, node):
        """What a comprehension, a lambda or a function binds is its own."""
        bound = [part.target for part in getattr(node, "generators", ())] or [node.args]
        parts = [part for place in bound for part in ast.walk(place)]
        own = {getattr(part, "id", None) or getattr(part, "arg", None) for part in parts}
        outside = self.names
        self.names = {name: word for name, word in outside.items() if name not in own}
        self.generic_visit(node)
        self.names = outside
        return node

    visit_ListComp = visit_SetComp = visit_GeneratorExp = visit_DictComp = visit_scope
    visit_Lambda = visit_FunctionDef = visit_scope

    def new(self, *parts):
        return f"{HELPED * any(HELPED in part for part in parts)}_{next(self.numbers)}"

    def word(self, node):
        """The word for an expression; two that are written alike have the same."""
        written = self.visit(deepcopy(node))
        text = ast.unparse(written)
        if isinstance(written, ast.Name):
            return text
        return self.words.get(text) or self.words.setdefault(text, self.new(text))

    def bind(self, target, word):
        if isinstance(target, ast.Name):
            self.names[target.id] = word
        elif isinstance(target, ast.Tuple | ast.List):
            for i, part in enumerate(target.elts):
                self.bind(
                    part, self.word(ast.Subscript(ast.Name(word, ast.Load()), ast.Constant(i)))
                )
        else:  # x[i] = y, x.a = y, *x
            self.change(target, ast.Name(word, ast.Load()))

    def change(self, target, *values):
        """Each name in a target is another thing from here on."""
        names = [node.id for node in ast.walk(target) if isinstance(node, ast.Name)]
        before = [self.names.get(name, name) for name in names]
        word = self.new(*before, *map(self.word, values))
        self.names |= dict.fromkeys(names, word)

    def read(self, node):
        """A statement, or what it is made of, in order; gives the checks in it, written out."""
        match node:
            case ast.ImportFrom(module=module, names=names):
                start = HELPED if (module or "").startswith(("helpers", "course")) else ""
                self.names |= {n.asname or n.name: f"{start}_{module}_{n.name}" for n in names}
            case ast.FunctionDef(name=name):
                self.names[name] = self.word(node)
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
                for target, word in zip(targets, [*map(self.word, values)], strict=True):
                    self.bind(target, word)
            case ast.Assign(targets=targets, value=value):
                word = self.word(value)
                for target in targets:
                    self.bind(target, word)
            case ast.AugAssign(target=target, value=value):
                self.change(target, value)

    def sides(self, call):
        named = {key.arg: key.value for key in call.keywords}
        given = [*call.args[1:], *(named[name] for name in ("actual", "expected") if name in named)]
        if isinstance(given[0], ast.Starred):
            return [self.word(ast.Subscript(given[0].value, ast.Constant(i))) for i in (0, 1)]
        return [self.word(side) for side in given[:2]]


def complaints(sources):
    written, found = Written(), []
    for node, actual, expected in (c for s in sources for c in written.read(ast.parse(s))):
        label = ast.literal_eval(node.args[0]) if isinstance(node.args[0], ast.Constant) else "?"
        if actual == expected:
            found.append(f"{label}: both sides are {ast.unparse(node.args[1])}")
        elif HELPED not in actual + expected and label not in BY_HAND:
            found.append(f"{label}: neither side rests on the helpers")
        if HELPED in expected and any(key.arg == "book_only" for key in node.keywords):
            found.append(f"{label}: open, though what is expected is computed for any arm")
    return found


@pytest.mark.parametrize("path", NOTEBOOKS, ids=lambda path: path.stem)
def test_notebook_checks_compare_independent_values(path):
    cells = nbformat.read(path, as_version=4).cells
    assert complaints(cell.source for cell in cells if cell.cell_type == "code") == []


HEAD = "from helpers import kinematics\nfrom helpers.robots import PANDA\n"
J = "J = kinematics.jacobian(PANDA, q)\n"


@pytest.mark.parametrize(
    ("source", "red"),
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
def test_self_comparison_is_detected(source, red):
    assert bool(complaints([HEAD, source])) == red
