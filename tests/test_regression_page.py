"""Follow the page on regression tests literally, in an empty folder and without a network."""

import os
import re
import shutil
import subprocess
import sys
import sysconfig
from pathlib import Path

import nbformat
import pytest

ROOT = Path(__file__).parents[1]
PAGE = (ROOT / "book" / "regression_tests.md").read_text(encoding="utf-8")
COMMANDS = "".join(re.findall(r"^```sh\n(.*?)^```", PAGE, re.S | re.M)).splitlines()
FILES = re.findall(r"`([\w./]+)`:\n\n```(?:python|yaml)\n(.*?)^```", PAGE, re.S | re.M)
WORKFLOW = ".github/workflows/notebooks.yml"
PARTS = (
    *("helpers", "answers", "course", "pyproject.toml", "README.md", "LICENSE"),
    "requirements.lock",
)
NOTEBOOK = "book/02_jacobian.ipynb"
CELLS = 20  # `make test` runs the whole notebook elsewhere

pytestmark = pytest.mark.skipif(os.name == "nt", reason="the commands need a POSIX shell")


def test_workflow_repeats_the_commands_of_the_page():
    (workflow,) = [text for name, text in FILES if name == WORKFLOW]
    install, test = re.findall(r"- run: (.*)", workflow)
    assert [f".venv/bin/{install}", f".venv/bin/{test}"] == [COMMANDS[1], COMMANDS[-1]]


@pytest.fixture(scope="module")
def folder(tmp_path_factory):
    """Follow the page up to the last command, with the packages that are installed here."""
    home = tmp_path_factory.mktemp("mine")
    for part in PARTS:
        source, target = ROOT / part, home / "companion" / part
        target.parent.mkdir(parents=True, exist_ok=True)
        (shutil.copytree if source.is_dir() else shutil.copy)(source, target)
    (home / "companion" / "book").mkdir()
    notebook = nbformat.read(ROOT / NOTEBOOK, as_version=4)
    notebook.cells = notebook.cells[:CELLS]
    nbformat.write(notebook, home / "companion" / NOTEBOOK)
    for name, text in FILES:
        (home / name).parent.mkdir(parents=True, exist_ok=True)
        (home / name).write_text(text, encoding="utf-8")
    for command in COMMANDS[:-1]:
        run(home, command)
        if "-m venv" in command:
            link_installed_packages(home / ".venv")
    return home


def link_installed_packages(environment):
    """Let an environment find the packages installed here, setuptools in place of its older one."""
    packages = Path(sysconfig.get_path("purelib", vars={"base": str(environment)}))
    for old in packages.glob("setuptools*"):
        shutil.rmtree(old)
    (packages / "installed.pth").write_text(sysconfig.get_path("purelib"), "utf-8")


def run(home, command):
    """Run a printed command; pip finds what it needs among the installed packages."""
    path = f"{Path(sys.executable).parent}{os.pathsep}{os.environ['PATH']}"
    offline = {"PIP_NO_INDEX": "1", "PIP_NO_BUILD_ISOLATION": "0", "PATH": path}
    done = subprocess.run(
        command, cwd=home, env={**os.environ, **offline}, shell=True, capture_output=True, text=True
    )
    assert done.returncode == 0, f"{command}\n{done.stdout[-3000:]}{done.stderr[-3000:]}"
    return done.stdout


def test_printed_commands_pass_in_an_empty_folder(folder):
    place = run(folder, '.venv/bin/python -c "import helpers; print(helpers.__file__)"')
    assert place.startswith(str(folder)), "the package of this folder is tested"
    said = run(folder, COMMANDS[-1])
    assert int(re.search(r"(\d+) passed", said)[1]) > 5


def test_changed_number_fails(folder):
    """A wrong sign in one's own code fails the test."""
    mine = folder / "my_arm.py"
    mine.write_text(
        mine.read_text("utf-8").replace("[0, reach, lift]", "[0, reach, -lift]"), "utf-8"
    )
    with pytest.raises(AssertionError, match="Mismatched elements"):
        run(folder, ".venv/bin/python -m pytest test_my_arm.py")
