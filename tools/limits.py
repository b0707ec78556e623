"""How long things may be: `python tools/limits.py FILE...` names whatever is longer.

A function's body has at most 40 lines beside its docstring and takes at most 5 arguments; the
keyword-only options of a public function, which a caller names, are not counted. A module has at
most 400 lines. How much a function may branch is Ruff's to count.
"""

import ast
import sys
from collections.abc import Iterator
from pathlib import Path

BODY, ARGUMENTS, MODULE = 40, 5, 400

Function = ast.FunctionDef | ast.AsyncFunctionDef


def broken(path: Path) -> Iterator[str]:
    """A line for each limit that a file breaks."""
    text = path.read_text(encoding="utf-8")
    if (lines := len(text.splitlines())) > MODULE:
        yield f"{path}: {lines} lines; at most {MODULE}"
    for node in ast.walk(ast.parse(text)):
        if isinstance(node, Function):
            where = f"{path}:{node.lineno}: {node.name}"
            if (lines := body(node)) > BODY:
                yield f"{where} has {lines} lines; at most {BODY}"
            if (taken := arguments(node)) > ARGUMENTS:
                yield f"{where} takes {taken} arguments; at most {ARGUMENTS}"


def body(node: Function) -> int:
    """The lines of a function beside its docstring."""
    first = 1 if ast.get_docstring(node) and len(node.body) > 1 else 0
    return node.body[-1].end_lineno - node.body[first].lineno + 1


def arguments(node: Function) -> int:
    """The arguments of a function, but for self and what a public one takes by name only."""
    taken = node.args
    positional = [argument.arg for argument in (*taken.posonlyargs, *taken.args)]
    private = node.name.startswith("_") and not node.name.endswith("__")
    named = len(taken.kwonlyargs) if private else 0
    return len(positional) - (positional[:1] in (["self"], ["cls"])) + named


if __name__ == "__main__":
    lines = [line for name in sys.argv[1:] for line in broken(Path(name))]
    sys.exit("\n".join(lines) or None)
