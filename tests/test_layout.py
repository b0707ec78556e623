"""Test the structure of the project: which file imports which, and what each folder is for."""

import ast
import json
import re
from collections.abc import Iterator
from functools import cache
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[1]
# The top-level Python folders that each such folder may import.
ALLOWED_PYTHON_FOLDERS = {
    "helpers": set(),
    "answers": {"helpers"},
    "course": {"helpers", "answers"},
    "tools": {"helpers", "answers"},
    "benchmarks": {"helpers", "tools"},
}
# The folders that each folder of judge/ may import. The files in judge/ itself are entry points
# or are shared by all folders, such as sentences.js.
ALLOWED_FOLDERS = {
    "judge/geometry": {"judge"},
    "judge/reading": {"judge", "judge/geometry"},
    "judge/causes": {"judge", "judge/geometry", "judge/reading"},
    "judge/topics": {"judge", "judge/geometry", "judge/reading", "judge/causes"},
    "judge": {"judge/geometry", "judge/reading", "judge/causes", "judge/topics"},
}
# The readers of tables and robot descriptions import `Arm`, so `Arm` may import them only inside
# the methods that use them.
LATE_UPWARD_IMPORTS = {
    ("helpers.arm", "helpers.checks.tables"),
    ("helpers.arm", "helpers.urdf"),
}


def find_python_modules() -> dict[str, Path]:
    """Return the file of each Python module by its dotted name."""
    paths = [path for room in ALLOWED_PYTHON_FOLDERS for path in (ROOT / room).rglob("*.py")]
    names = [".".join(path.relative_to(ROOT).with_suffix("").parts) for path in paths]
    return {name.removesuffix(".__init__"): path for name, path in zip(names, paths, strict=True)}


def find_imports(node: ast.AST, is_late: bool = False) -> Iterator[tuple[str, bool]]:
    """Yield the names that a syntax tree imports, and whether the import is inside a function."""
    for child in ast.iter_child_nodes(node):
        if isinstance(child, ast.Import):
            yield from ((alias.name, is_late) for alias in child.names)
        elif isinstance(child, ast.ImportFrom):
            yield from ((f"{child.module}.{alias.name}", is_late) for alias in child.names)
        else:
            is_function = isinstance(child, ast.FunctionDef | ast.AsyncFunctionDef)
            yield from find_imports(child, is_late or is_function)


@cache
def read_python_imports() -> tuple[dict[str, set[str]], set[tuple[str, str]]]:
    """Return for each module its imports at the top, and all imports inside functions."""
    modules = find_python_modules()
    at_start, late = {name: set() for name in modules}, set()
    for name, path in modules.items():
        for imported, is_late in find_imports(ast.parse(path.read_text("utf-8"))):
            target = imported if imported in modules else imported.rpartition(".")[0]
            if target not in modules or target == name:
                continue
            if is_late:
                late.add((name, target))
            else:
                at_start[name].add(target)
    return at_start, late


@cache
def read_javascript_imports() -> dict[str, set[str]]:
    """Return the files that each file of judge/ and page/ imports, as paths below the root."""
    imports = {}
    for path in [file for room in ("judge", "page") for file in (ROOT / room).rglob("*.js")]:
        code = re.sub(
            r"/\*.*?\*/|^\s*//[^\n]*", "", path.read_text("utf-8"), flags=re.DOTALL | re.M
        )
        statements = re.findall(
            r'^(?:import|export) [^;"()]*"(\.[^"]+\.js)"|import\("(\.[^"]+\.js)"\)', code, re.M
        )
        targets = [(path.parent / "".join(names)).resolve() for names in statements]
        imports[path.relative_to(ROOT).as_posix()] = {
            target.relative_to(ROOT).as_posix() for target in targets
        }
    return imports


def find_circle(imports: dict[str, set[str]]) -> list[str]:
    """Return files that import each other in a circle, or [] if there are none."""
    finished: set[str] = set()

    def visit(name: str, path: list[str]) -> list[str]:
        if name in path:
            return path[path.index(name) :]
        if name in finished:
            return []
        for target in sorted(imports.get(name, ())):
            if circle := visit(target, [*path, name]):
                return circle
        finished.add(name)
        return []

    return next((circle for name in imports if (circle := visit(name, []))), [])


def is_reachable(imports: dict[str, set[str]], start: str, end: str) -> bool:
    """Return whether `start` imports `end`, directly or through other files."""
    seen, waiting = set(), [start]
    while waiting:
        name = waiting.pop()
        if name == end:
            return True
        if name not in seen:
            seen.add(name)
            waiting.extend(imports.get(name, ()))
    return False


def test_find_circle_finds_a_circle():
    assert find_circle({"a": {"b"}, "b": {"c"}, "c": {"b"}}) == ["b", "c"]
    assert find_circle({"a": {"b", "c"}, "b": {"c"}, "c": set()}) == []


def test_python_imports_have_no_circle():
    assert find_circle(read_python_imports()[0]) == []


def test_javascript_imports_have_no_circle():
    imports = read_javascript_imports()
    assert len(imports) > 100
    assert set().union(*imports.values()) <= set(imports)
    assert find_circle(imports) == []


def test_python_folders_import_only_folders_below():
    at_start, late = read_python_imports()
    pairs = {(name, target) for name, targets in at_start.items() for target in targets} | late
    upward = {
        (name, target)
        for name, target in pairs
        if (room := name.partition(".")[0]) != (other := target.partition(".")[0])
        and other not in ALLOWED_PYTHON_FOLDERS[room]
    }
    assert upward == set()


def test_no_folder_imports_tests_or_the_book():
    imports = {
        (name, imported)
        for name, path in find_python_modules().items()
        for imported, _ in find_imports(ast.parse(path.read_text("utf-8")))
    }
    assert {pair for pair in imports if pair[1].partition(".")[0] in ("tests", "book")} == set()


def test_page_imports_only_the_page_and_the_judge():
    for name, targets in read_javascript_imports().items():
        assert {target.partition("/")[0] for target in targets} <= {"judge", "page"}, name


def test_only_known_late_imports_would_close_a_circle():
    at_start, late = read_python_imports()
    upward = {(name, target) for name, target in late if is_reachable(at_start, target, name)}
    assert upward == LATE_UPWARD_IMPORTS


def test_core_of_the_helpers_imports_nothing_around_it():
    """The core is the first table of helpers/README.md."""
    table = (ROOT / "helpers/README.md").read_text("utf-8").partition("| below the core |")[0]
    core = re.findall(r"^\| `([\w/]+)\.py` \|", table, re.M)
    assert len(core) > 10
    lines = sum((ROOT / "helpers" / f"{name}.py").read_text("utf-8").count("\n") for name in core)
    assert lines < 3700
    around = ("checks", "explorer", "urdf", "derive", "other_programs", "plotting", "show")
    at_start, _ = read_python_imports()
    reached = {
        (name, folder)
        for name in core
        for folder in around
        for target in at_start
        if re.match(rf"helpers\.{folder}(\.|$)", target)
        and is_reachable(at_start, f"helpers.{name.replace('/', '.')}", target)
    }
    assert reached == set()


def test_judge_folders_import_only_folders_below():
    for name, targets in read_javascript_imports().items():
        if name.startswith("judge/"):
            folder = Path(name).parent.as_posix()
            others = {Path(target).parent.as_posix() for target in targets} - {folder}
            assert others <= ALLOWED_FOLDERS[folder], name


# The file that introduces each folder in its first lines.
INTRODUCTIONS = [
    "helpers/README.md", "answers/__init__.py", "course/__init__.py", "judge/README.md",
    "judge/reading/README.md", "page/README.md", "tools/README.md", "tests/README.md",
    "tests/measure/README.md", "benchmarks/README.md", "book/_toc.yml",
]  # fmt: skip


@pytest.mark.parametrize("introduction", INTRODUCTIONS)
def test_paths_in_the_introduction_of_a_folder_exist(introduction):
    path = ROOT / introduction
    text = path.read_text("utf-8")
    assert len(text.split()) > 20
    if path.suffix == ".md":
        named = re.findall(r"(?<!make )`([\w/.-]+(?:/|\.(?:py|js|json)))`", text)
        missing = [x for x in named if not (path.parent / x).exists() and not (ROOT / x).exists()]
        assert missing == []


def test_readme_of_reading_names_each_module():
    text = (ROOT / "judge/reading/README.md").read_text("utf-8")
    modules = sorted(path.name for path in (ROOT / "judge/reading").glob("*.js"))
    assert [name for name in modules if f"`{name}`" not in text] == []


def test_text_of_each_planted_fault_occurs_once():
    """`python -m tests.measure.faults` replaces this text, so the text must still exist."""
    faults = json.loads((ROOT / "tests/measure/faults.json").read_text("utf-8"))["faults"]
    counts = {
        fault["old"]: (ROOT / fault["file"]).read_text("utf-8").count(fault["old"])
        for fault in faults
    }
    assert {text: count for text, count in counts.items() if count != 1} == {}
