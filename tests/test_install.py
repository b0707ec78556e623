"""Test `pip install .` in a bare environment, as a student types it.

CI installs in place, with every extra, so that it misses a file left out of the wheel.
"""

import shutil
import subprocess
import sys
import sysconfig
import venv
from importlib.util import find_spec
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[1]
IMPORT_ALL = """
import importlib, pkgutil, answers, helpers
rooms = {"helpers.": helpers.__path__, "answers.": answers.__path__}
for module in [m for room, path in rooms.items() for m in pkgutil.walk_packages(path, room)]:
    if not module.name.startswith("helpers.explorer"):
        importlib.import_module(module.name)
from helpers.robots import PANDA
from helpers.plotting import use_book_style
use_book_style()
try:
    import helpers.explorer
except ModuleNotFoundError as error:
    print(error)
"""


@pytest.fixture(scope="module")
def python(tmp_path_factory):
    """Return the Python of a fresh environment with the package and its dependencies."""
    place, source = tmp_path_factory.mktemp("bare"), tmp_path_factory.mktemp("source")
    for room in ("helpers", "answers"):  # copied, because a build leaves files beside the sources
        shutil.copytree(ROOT / room, source / room)
    for name in ("pyproject.toml", "README.md", "LICENSE"):
        shutil.copy(ROOT / name, source)
    venv.create(place, with_pip=False)
    (python,) = [p for p in place.glob("*/python*") if p.stem == "python"]
    uv = ["uv", "pip", "install", "-qq", "--python", python]  # links packages unpacked by `make`
    pip = ["pip", "--python", python, "install", "-qq", "--no-compile"]
    what = ["-c", ROOT / "requirements.lock", source]
    command = [sys.executable, "-m"]
    done = find_spec("uv") and not subprocess.run([*command, *uv, *what], check=False).returncode
    if not done:  # uv may be missing or may not know pip's settings
        subprocess.run([*command, *pip, *what], check=True)
    bare = sysconfig.get_path("purelib", vars={"base": place})
    share_bytecode(Path(sysconfig.get_path("purelib")), Path(bare))
    return python


def share_bytecode(ours, theirs):
    """Share bytecode, since compiling SymPy takes 5 s; Python checks that it is current."""
    for package in theirs.iterdir():
        for cache in (ours / package.name).rglob("__pycache__"):
            shutil.copytree(cache, theirs / cache.relative_to(ours), dirs_exist_ok=True)


def test_modules_import_without_extras_but_explorer_explains(python, tmp_path):
    done = subprocess.run(
        [python, "-c", IMPORT_ALL], cwd=tmp_path, capture_output=True, text=True, check=False
    )
    assert done.returncode == 0, done.stderr
    assert done.stdout == "the explorer needs anywidget; say: pip install anywidget\n"


def test_wheel_holds_exactly_the_package(python, tmp_path):
    """The wheel has py.typed, scripts and style sheets; no tests, sources of bundles, guides."""
    done = subprocess.run(
        [python, "-c", "import helpers; print(helpers.__path__[0])"], cwd=tmp_path,
        capture_output=True, text=True, check=True,
    )  # fmt: skip
    place = Path(done.stdout.strip())

    def files(folder):
        paths = (p.relative_to(folder) for p in folder.rglob("*") if p.is_file())
        return {p.as_posix() for p in paths if "__pycache__" not in p.parts and p.suffix != ".md"}

    for room in ("helpers", "answers"):
        assert files(place.parent / room) == files(ROOT / room)
    assert not any((place.parent / name).exists() for name in ("tests", "tools", "book"))
