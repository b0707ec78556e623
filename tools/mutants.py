"""Mutation testing: make one thing wrong in helpers/ at a time, and count how often the suite
notices.

mutmut makes the mutants and runs the tests that reach each; this draws a sample of them by a seed,
leaves out those that only reword a message, and reports by module. `make mutants` runs it;
tests/mutants.md tells the figures and explains survivors.
"""

import argparse
import json
import random
import re
import subprocess
import sys
from collections import Counter, defaultdict
from collections.abc import Iterator
from contextlib import contextmanager
from fnmatch import fnmatch
from itertools import accumulate
from pathlib import Path

from mutmut.mutation.diff_apply import get_diff_for_mutant

STATS = Path("mutants/mutmut-stats.json")
MUTMUT = [str(Path(sys.executable).with_name("mutmut"))]
CAUGHT = ("killed", "timeout", "suspicious", "segfault", "caught by type check")
STRING = re.compile(r"""(["'])(.*?)\1""")
ANY = "helpers.inverse.shoulder.x_elbow__mutmut_1"  # to run one makes them all, and times the tests


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("modules", nargs="*", default=["helpers.*"], help="as helpers.inverse.*")
    parser.add_argument("--sample", type=int, default=30, help="mutants of a module; 0 for all")
    parser.add_argument("--seed", type=int, default=0)
    parser.add_argument("--seconds", type=float, default=40, help="of tests for a mutant")
    options = parser.parse_args()
    if not STATS.exists():
        run([ANY])
    chosen = draw(statuses(), options.modules, options.sample, options.seed)
    with quickest_tests(options.seconds):
        run(chosen)
    report(chosen, statuses())


def run(names: list[str]) -> None:
    """Try these mutants, one process at a time."""
    Path("mutants").mkdir(exist_ok=True)
    with open("mutants/run.log", "w", encoding="utf-8") as log:
        command = [*MUTMUT, "run", "--max-children", "1", *names]
        if subprocess.run(command, stdout=log, stderr=log, check=False).returncode:
            sys.exit("mutmut failed: see mutants/run.log")


@contextmanager
def quickest_tests(seconds: float) -> Iterator[None]:
    """Meanwhile a mutant meets only the quickest of its tests, `seconds` of them: what others alone
    see survives."""
    whole = STATS.read_text(encoding="utf-8")
    stats = json.loads(whole)
    time, reach = stats["duration_by_test"], stats["tests_by_mangled_function_name"]
    for name, tests in reach.items():
        quickest = sorted(tests, key=time.__getitem__)
        spent = accumulate(time[test] for test in quickest)
        reach[name] = [test for test, total in zip(quickest, spent, strict=True) if total < seconds]
    STATS.write_text(json.dumps(stats), encoding="utf-8")
    try:
        yield
    finally:
        STATS.write_text(whole, encoding="utf-8")


def statuses() -> dict[str, str]:
    """What became of each mutant that mutmut knows, by its name."""
    command = [*MUTMUT, "results", "--all", "true"]
    lines = subprocess.run(command, capture_output=True, text=True, check=True).stdout.splitlines()
    return dict(line.strip().split(": ", 1) for line in lines if "__mutmut_" in line)


def draw(names, modules: list[str], sample: int, seed: int) -> list[str]:
    """Up to `sample` mutants of each module, by `seed`: a module's draw does not depend on the
    others."""
    by_module = defaultdict(list)
    for name in sorted(names):
        if any(fnmatch(module_of(name), pattern) for pattern in modules):
            by_module[module_of(name)].append(name)
    chosen = []
    for module, mutants in by_module.items():
        random.Random(f"{seed} {module}").shuffle(mutants)
        telling = (name for name in mutants if not rewords(name))
        chosen += [name for name, _ in zip(telling, range(sample or len(mutants)), strict=False)]
    return chosen


def module_of(name: str) -> str:
    return name.rsplit(".", 1)[0]


def rewords(name: str) -> bool:
    """Whether a mutant changes nothing but prose: a string with a space in it."""
    lines = [STRING.sub(lambda m: "" if " " in m[2] else m[0], line) for line in changed(name)]
    return [x[1:] for x in lines if x[0] == "-"] == [x[1:] for x in lines if x[0] == "+"]


def report(chosen: list[str], result: dict[str, str]) -> None:
    """A line for each module, and each survivor with its place and its change."""
    counts = defaultdict(Counter)
    for name in chosen:
        counts[module_of(name)][result[name] in CAUGHT] += 1
    survivors = [name for name in chosen if result[name] not in CAUGHT]
    for name in survivors:
        print(place(name), f"({result[name]}, {name.rsplit('.', 1)[1]})")
        print("\n".join(f"    {line}" for line in changed(name)))
    for module, count in [*counts.items(), ("all", sum(counts.values(), Counter()))]:
        print(
            f"{module:32}{count[True]:5} of {count.total():5} killed,"
            f" {count[True] / count.total():.1%}"
        )


def changed(name: str) -> list[str]:
    return [line for line in get_diff_for_mutant(name).splitlines()[2:] if line[:1] in "-+"]


def place(name: str) -> str:
    """The first line of its file that reads as the changed one did."""
    path = Path(*module_of(name).split(".")).with_suffix(".py")
    path = path if path.exists() else path.with_suffix("") / "__init__.py"
    wanted = next((line[1:].strip() for line in changed(name) if line[0] == "-"), "")
    lines = [line.strip() for line in path.read_text(encoding="utf-8").splitlines()]
    return f"{path}:{lines.index(wanted) + 1 if wanted in lines else 0}"


if __name__ == "__main__":
    main()
