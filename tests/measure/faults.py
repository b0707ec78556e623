"""Plant faults in the code one at a time and see whether a test fails.

`python -m tests.measure.faults` clones the committed state, plants a fault of faults.json there and
runs the tests of its file, which stand in the same list. `--only WORD` chooses the faults that have
this word in their file or their reason, `--part 2/5` the second fifth of the list. The tests of a
fault are stopped after `--seconds`, and the fault then counts as not caught. With `--all`, where
those tests pass, it also runs all tests that need no built book. `--list FILE` takes other
faults: a JSON list of {"file", "old", "new", "why"}. The command needs Node.js and takes half an
hour of processor time. It does not show that the code is right.
"""

import argparse
import json
import subprocess
import sys
from pathlib import Path
from tempfile import TemporaryDirectory

ROOT = Path(__file__).parents[2]
LIST = Path(__file__).with_name("faults.json")
BUILT = ("browser", "test_book.py")  # these tests need the built book


def main() -> None:
    """Read the command line, plant the faults and exit with 1 if one is not noticed."""
    parser = argparse.ArgumentParser(description=__doc__.partition("\n")[0])
    parser.add_argument("--only", default="", help="plant only faults that contain this word")
    parser.add_argument("--part", default="1/1", help="plant only a part of the list, as 2/5")
    parser.add_argument("--list", type=Path, default=LIST, help="file with other faults")
    parser.add_argument(
        "--all", action="store_true", help="run all tests where those of the file pass"
    )
    parser.add_argument("--seconds", type=float, default=600, help="time limit of a fault's tests")
    options = parser.parse_args()
    data = json.loads(LIST.read_text(encoding="utf-8"))
    faults = json.loads(options.list.read_text(encoding="utf-8"))
    faults = faults["faults"] if options.list == LIST else faults
    part, count = map(int, options.part.split("/"))
    chosen = [fault for fault in faults if options.only in f"{fault['file']} {fault['why']}"]
    missed = 0
    for fault in chosen[part - 1 :: count]:
        tests = tests_of(fault["file"], data["tests"])
        failed = find_failing_test(fault, tests, options.all, options.seconds)
        missed += not failed
        print(f"{fault['file']}: {fault['why']}: {failed or 'NOT CAUGHT'}", flush=True)
    sys.exit(bool(missed))


def tests_of(file: str, tests: dict[str, list[str]]) -> list[str]:
    """Return the tests of the longest path in the list that the file's path begins with."""
    return tests[max((start for start in tests if file.startswith(start)), key=len)]


def find_failing_test(fault: dict, nearby_tests: list[str], try_all: bool, seconds: float) -> str:
    """Return the first test that fails with a fault planted, or "" if none does."""
    with TemporaryDirectory() as folder:
        copy = Path(folder, "copy")
        run("git", "clone", "--quiet", str(ROOT), str(copy), cwd=ROOT)
        for name in (".venv", "node_modules"):
            (copy / name).symlink_to(ROOT / name)
        plant_fault(copy, fault)
        if fault["file"].startswith(("judge/", "page/")):
            run("npm", "run", "build", "--silent", cwd=copy)
        nearby = [copy / "tests" / name for name in nearby_tests]
        nearby = [path if path.is_dir() else path.with_suffix(".py") for path in nearby]
        everything = [copy / "tests", *(f"--ignore=tests/{name}" for name in BUILT)]
        failed = first_failure(copy, nearby, seconds)
        return failed or (first_failure(copy, everything, seconds) if try_all else "")


def plant_fault(copy: Path, fault: dict) -> None:
    """Replace the fault's old text, which must occur once in its file, by the new text."""
    file = copy / fault["file"]
    text = file.read_text(encoding="utf-8")
    if text.count(fault["old"]) != 1:
        sys.exit(f"{fault['file']}: {fault['old']!r} occurs {text.count(fault['old'])} times")
    file.write_text(text.replace(fault["old"], fault["new"]), encoding="utf-8")


def first_failure(copy: Path, tests: list, seconds: float) -> str:
    """Return the first test that fails in a copy, or "" if none does within the time."""
    command = [sys.executable, "-m", "pytest", "-x", "-q", "-p", "no:cacheprovider", *tests]
    try:
        done = subprocess.run(
            command, cwd=copy, capture_output=True, text=True, check=False, timeout=seconds
        )
    except subprocess.TimeoutExpired:
        print(f"stopped after {seconds:.0f} s", flush=True)
        return ""
    if done.returncode not in (0, 1, 2):
        sys.exit(done.stdout + done.stderr)
    failed = [line for line in done.stdout.splitlines() if line.startswith(("FAILED", "ERROR"))]
    return failed[0].partition(" ")[2].partition(" - ")[0] if failed else ""


def run(*command: str, cwd: Path) -> None:
    """Run a command, which must succeed."""
    subprocess.run(command, cwd=cwd, check=True)


if __name__ == "__main__":
    main()
