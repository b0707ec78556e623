"""Plant the faults of tests/faults.json one at a time and see whether a test fails.

`python -m tests.faults` clones the committed state, plants a fault and runs the tests of the room
to which the fault belongs. With `--all`, where those tests pass, it also runs all tests that need
no built book. `--only WORD` chooses the faults with this word in their room, file or description.
The command needs Node.js and takes ten minutes. It shows which tests catch nothing and can go. It
does not show that the code is right.
"""

import argparse
import json
import subprocess
import sys
from pathlib import Path
from tempfile import TemporaryDirectory

ROOT = Path(__file__).parents[1]
LIST = Path(__file__).with_name("faults.json")
BUILT = ("browser", "test_book.py")  # these read the built book


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.partition("\n")[0])
    parser.add_argument("--only", default="", help="plant only faults that contain this word")
    parser.add_argument(
        "--all", action="store_true", help="run all tests where those of the room pass"
    )
    options = parser.parse_args()
    data = json.loads(LIST.read_text(encoding="utf-8"))
    missed = 0
    for fault in data["faults"]:
        if options.only in f"{fault['room']} {fault['file']} {fault['what']}":
            failed = find_failing_test(fault, data["tests"][fault["room"]], options.all)
            missed += not failed
            print(f"{fault['room']:10}  {fault['what']}: {failed or 'NOT CAUGHT'}", flush=True)
    sys.exit(bool(missed))


def find_failing_test(fault: dict, room_tests: list[str], try_all: bool) -> str:
    """Return the first test that fails with a fault planted, or "" if none does."""
    with TemporaryDirectory() as folder:
        copy = Path(folder, "copy")
        run("git", "clone", "--quiet", str(ROOT), str(copy), cwd=ROOT)
        for name in (".venv", "node_modules"):
            (copy / name).symlink_to(ROOT / name)
        plant_fault(copy, fault)
        if fault["file"].startswith(("judge/", "page/")):
            run("npm", "run", "build", "--silent", cwd=copy)
        near = [copy / "tests" / name for name in room_tests]
        near = [path if path.is_dir() else path.with_suffix(".py") for path in near]
        everything = [copy / "tests", *(f"--ignore=tests/{name}" for name in BUILT)]
        return first_failure(copy, near) or (first_failure(copy, everything) if try_all else "")


def plant_fault(copy: Path, fault: dict) -> None:
    """Replace the fault's old text, which must occur once in its file, by the new text."""
    file = copy / fault["file"]
    text = file.read_text(encoding="utf-8")
    if text.count(fault["old"]) != 1:
        sys.exit(f"{fault['file']}: {fault['old']!r} occurs {text.count(fault['old'])} times")
    file.write_text(text.replace(fault["old"], fault["new"]), encoding="utf-8")


def first_failure(copy: Path, tests: list) -> str:
    """Return the first test that fails in a copy, or "" if all pass."""
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
