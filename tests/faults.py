"""Twenty faults of tests/faults.json, planted one at a time: does some test go red?

`python -m tests.faults` plants them in copies of what is committed and runs the tests of the room
they are in; with `--all`, where those stay green, all that need no built book. `--only WORD` takes
the faults with this in their room, file or words. Needs Node.js, and takes ten minutes: it says
which tests can go, not whether all is well.
"""

import argparse
import json
import subprocess
import sys
from pathlib import Path
from tempfile import TemporaryDirectory

ROOT = Path(__file__).parents[1]
LIST = Path(__file__).with_name("faults.json")
BUILT = ("browser", "test_book.py")  # they look at the built book


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.partition("\n")[0])
    parser.add_argument("--only", default="", help="faults that have this in them")
    parser.add_argument("--all", action="store_true", help="where the room's tests stay green")
    options = parser.parse_args()
    data = json.loads(LIST.read_text(encoding="utf-8"))
    missed = 0
    for fault in data["faults"]:
        if options.only in f"{fault['room']} {fault['file']} {fault['what']}":
            red = caught(fault, data["tests"][fault["room"]], options.all)
            missed += not red
            print(f"{fault['room']:10}  {fault['what']}: {red or 'NOT CAUGHT'}", flush=True)
    sys.exit(bool(missed))


def caught(fault: dict, concerned: list[str], beyond: bool) -> str:
    """The first test that goes red by a fault; "" where none does."""
    with TemporaryDirectory() as folder:
        copy = Path(folder, "copy")
        run("git", "clone", "--quiet", str(ROOT), str(copy), cwd=ROOT)
        for name in (".venv", "node_modules"):
            (copy / name).symlink_to(ROOT / name)
        planted(copy, fault)
        if fault["file"].startswith(("judge/", "page/")):
            run("npm", "run", "build", "--silent", cwd=copy)
        near = [copy / "tests" / name for name in concerned]
        near = [path if path.is_dir() else path.with_suffix(".py") for path in near]
        others = [copy / "tests", *(f"--ignore=tests/{name}" for name in BUILT)]
        return red_of(copy, near) or (red_of(copy, others) if beyond else "")


def planted(copy: Path, fault: dict) -> None:
    file = copy / fault["file"]
    text = file.read_text(encoding="utf-8")
    if text.count(fault["old"]) != 1:
        sys.exit(f"{fault['file']}: {fault['old']!r} stands there {text.count(fault['old'])} times")
    file.write_text(text.replace(fault["old"], fault["new"]), encoding="utf-8")


def red_of(copy: Path, tests: list) -> str:
    """The first test that fails in a copy."""
    command = [sys.executable, "-m", "pytest", "-x", "-q", "-p", "no:cacheprovider", *tests]
    done = subprocess.run(command, cwd=copy, capture_output=True, text=True, check=False)
    if done.returncode not in (0, 1):
        sys.exit(done.stdout + done.stderr)
    failed = [line for line in done.stdout.splitlines() if line.startswith(("FAILED", "ERROR"))]
    return failed[0].partition(" ")[2].partition(" - ")[0] if failed else ""


def run(*command: str, cwd: Path) -> None:
    subprocess.run(command, cwd=cwd, check=True)


if __name__ == "__main__":
    main()
