"""Test the Makefile: a failed build stays failed, and a reader's copies are kept.

CI builds a book that is whole, once; it meets none of these cases.
"""

import shutil
import subprocess
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[1]
NOTEBOOK = "book/01_dh_tables.ipynb"
# A substitute for Sphinx: a warning fails the build, and appears only when its page is written.
BUILDER = """#!/bin/sh
echo build "$@" >> builds
mkdir -p book/_build/html
if test book/page.md -nt book/_build/html/index.html || echo "$@" | grep -q -- --all; then
  touch book/_build/html/index.html
  ! grep -q broken book/page.md
fi
"""

pytestmark = pytest.mark.skipif(not shutil.which("make"), reason="make is not installed")


@pytest.fixture
def project(tmp_path):
    """Return a project with the Makefile, in a folder whose name has a space and an umlaut."""
    root = tmp_path / "my übung"
    (root / ".venv/bin").mkdir(parents=True)
    (root / "book").mkdir()
    shutil.copy(ROOT / "Makefile", root)
    for name in ("requirements.txt", "requirements.lock", "pyproject.toml", NOTEBOOK):
        (root / name).write_text("{}", "utf-8")
    (root / "book/page.md").write_text("fine", "utf-8")
    (root / ".venv/bin/python").symlink_to(shutil.which("python3"))
    program(root, "jupyter-book", BUILDER)
    program(root, "jupyter", "#!/bin/sh\n")
    (root / ".venv/bin/.installed").touch()
    return root


def program(root, name, text):
    (root / ".venv/bin" / name).write_text(text, "utf-8")
    (root / ".venv/bin" / name).chmod(0o755)


def make(root, *what):
    done = subprocess.run(
        ["make", *what], cwd=root, capture_output=True, check=False, encoding="utf-8"
    )
    return done.returncode, done.stdout


def test_failed_build_fails_until_fixed(project):
    page, builds = project / "book/page.md", project / "builds"
    assert make(project, "book")[0] == 0
    page.write_text("broken", "utf-8")
    for _ in range(3):
        code, said = make(project, "book")
        assert code != 0
        assert "The book" not in said
    page.write_text("mended", "utf-8")
    assert make(project, "book")[0] == 0
    built = builds.read_text("utf-8")
    assert make(project, "book")[0] == 0
    assert builds.read_text("utf-8") == built, "an up-to-date book must not be built again"


def test_page_edited_during_build_is_built_again(project):
    program(
        project,
        "jupyter-book",
        f"{BUILDER}test -e edited || echo more > book/page.md\ntouch edited\n",
    )
    for _ in range(3):
        assert make(project, "book")[0] == 0
    assert len((project / "builds").read_text("utf-8").splitlines()) == 2


def test_changed_tools_rebuild_every_page(project):
    (project / "tools").mkdir()
    for changed in ("book/page.md", "tools/pages.py", "book/page.md"):
        (project / changed).write_text("more", "utf-8")
        assert make(project, "book")[0] == 0
    built = (project / "builds").read_text("utf-8").splitlines()
    assert ["--all" in line for line in built] == [True, True, False]


def test_make_book_prints_a_file_url(project):
    _, said = make(project, "book")
    assert (project / "book/_build/html/index.html").as_uri() in said.splitlines()


def test_make_lab_opens_copies_and_keeps_them(project):
    """A new copy equals the book's file. An existing copy is not overwritten."""
    code, said = make(project, "lab")
    assert code == 0
    assert str(project / "my") in said
    assert "jupyter lab my" in said, "JupyterLab must open the folder of copies"
    copy = project / "my" / Path(NOTEBOOK).name
    assert copy.read_bytes() == (project / NOTEBOOK).read_bytes()
    assert (project / "my/page.md").exists(), "notebooks link to pages"
    for name in (copy.name, "own.ipynb"):
        (project / "my" / name).write_text("mine", "utf-8")
    assert make(project, "lab")[0] == 0
    assert copy.read_text("utf-8") == "mine"
    assert make(project, "clean")[0] == 0
    assert (project / "my/own.ipynb").read_text("utf-8") == "mine"


def test_make_clean_removes_build_output(project):
    made = ["dist/book.zip", "build/lib/arm.py", "book/_build/html/index.html"]
    for name in made:
        (project / name).parent.mkdir(parents=True, exist_ok=True)
        (project / name).touch()
    assert make(project, "clean")[0] == 0
    assert not any((project / Path(name).parent).exists() for name in made)
    assert (project / NOTEBOOK).exists()


def test_git_ignores_the_copies():
    assert "my/" in (ROOT / ".gitignore").read_text("utf-8").splitlines()
