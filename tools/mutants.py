"""Mutation testing: make one thing wrong in helpers/ at a time, and count how often the tests
notice.

mutmut makes the mutants, in a copy called `mutants/`. One process imports all tests there; forks of
it record which of them reach which function, and at what cost; a fork for each mutant of a random
sample then runs those that reach it, the cheapest first, until one fails, on every processor. Each
outcome goes to mutants/outcomes.jsonl, so that a run can be broken off and gone on with: the first
of a random order that are all decided are a random sample.
`make mutants` runs it; tests/mutants.md tells the figures and explains survivors.
"""

import argparse
import gc
import json
import os
import random
import re
import resource
import signal
from collections import Counter, defaultdict
from collections.abc import Callable
from contextlib import chdir, suppress
from fnmatch import fnmatch
from functools import _lru_cache_wrapper, partial, wraps
from itertools import accumulate, groupby, islice, takewhile, zip_longest
from multiprocessing import Value
from pathlib import Path
from typing import IO

import pytest
from hypothesis import Phase, settings
from mutmut import __main__ as mutmut
from mutmut.configuration import config
from mutmut.mutation import trampoline
from mutmut.mutation.data import SourceFileMutationData
from mutmut.mutation.diff_apply import get_diff_for_mutant
from mutmut.mutation.file_mutation import mangle_function_name

PLACE = Path("mutants").absolute()
OUTCOMES, REACH = PLACE / "outcomes.jsonl", PLACE / "reach.jsonl"
PORTION = 25  # tests that are recorded in one process
MEMORY, GRACE = 6 << 30, 5  # bytes, and seconds of processor on top of five times a test's own
STRING, GUARD = re.compile(r"""(["'])(.*?)\1"""), re.compile(r", (strict=\w+)?\)")


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("names", nargs="*", default=["*"], help="mutants, as helpers.inverse.*")
    parser.add_argument("--sample", type=int, default=1000, help="how many to draw; 0 for all")
    parser.add_argument("--seed", type=int, default=0)
    parser.add_argument("--seconds", type=float, default=30, help="of tests for a mutant")
    parser.add_argument(
        "--again", action="store_true", help="survivors meet tests that they have not met"
    )
    parser.add_argument("--processes", type=int, default=os.cpu_count())
    options = parser.parse_args()
    files = {n: p for n, p in made().items() if any(fnmatch(n, x) for x in options.names)}
    names = sorted(files)
    random.Random(options.seed).shuffle(names)
    changes = ((name, changed(name, files[name])) for name in names)
    telling = ((name, lines) for name, lines in changes if not idle(lines))
    sample = dict(islice(telling, options.sample or None))
    # To shrink a counterexample costs a hundred times what it cost to find it.
    phases = [Phase.explicit, Phase.generate]
    settings.register_profile("mutants", settings.get_profile("ci"), phases=phases)
    os.environ |= {"OPENBLAS_NUM_THREADS": "1"}
    signal.signal(signal.SIGTERM, signal.default_int_handler)
    os.chdir(PLACE)
    trampoline.set_mutant_under_test("")
    trampoline.wrap_in_trampoline = switched
    arguments = ["-qq", "--tb=native", "--assert=plain", "--rootdir=.", "-p", "no:cacheprovider"]
    arguments += ["--hypothesis-profile=mutants", *config().pytest_add_cli_args_test_selection]
    pytest.main(arguments, plugins=[Driver(sample, options)])
    known = {row["test"]: row["reach"] for row in rows(REACH)}
    print("Failed without a mutant:", *(test for test, reach in known.items() if reach is None))
    done = outcomes(sample)
    first = {name: done[name] for name in takewhile(done.__contains__, sample)}
    if first:
        report(first)


def made() -> dict[str, Path]:
    """The name of each mutant and its file; they are made where the source is newer."""
    trampoline.set_mutant_under_test("mutant_generation")
    PLACE.mkdir(exist_ok=True)
    for file in PLACE.glob("helpers/**/*.py"):
        if not file.stat().st_size:  # begun when a run was broken off
            file.unlink()
    mutmut.copy_src_dir()
    mutmut.copy_also_copy_files()
    mutmut.setup_source_paths()
    mutmut.create_mutants(1)
    files = [SourceFileMutationData(path=path) for path in mutmut.walk_mutatable_files()]
    for file in files:
        file.load()
    return {name: Path(file.path) for file in files for name in file.exit_code_by_key}


def changed(name: str, path: Path) -> list[str]:
    """The lines that a mutant takes out and puts in."""
    with chdir(PLACE.parent):
        lines = get_diff_for_mutant(name, path=path).splitlines()[2:]
    return [line for line in lines if line[:1] in "-+"]


def idle(lines: list[str]) -> bool:
    """Whether a mutant changes nothing but prose, a string with a space in it, or whether `zip`
    refuses what is of equal length by construction."""
    bare = [GUARD.sub(")", STRING.sub(lambda m: "" if " " in m[2] else m[0], x)) for x in lines]
    return [x[1:] for x in bare if x[0] == "-"] == [x[1:] for x in bare if x[0] == "+"]


CHOSEN: dict[str, str] = {}  # the mutant that stands for a function
HITS: set[str] = set()


def switched(variants: dict[str, Callable], is_classmethod: bool = False) -> Callable:
    """In the place of mutmut's own decorator, which looks into the environment at each call; that
    takes as long as many a function."""

    def switch(function: Callable) -> Callable:
        *inside, name = function.__qualname__.split(".")
        mangled = mangle_function_name(name=name, class_name=inside[0] if inside else None)
        name = f"{function.__module__}.{mangled}"

        @wraps(function)
        def called(*args, **kwargs):
            HITS.add(name)
            chosen = variants[CHOSEN.get(name, "_mutmut_orig")]
            return chosen(*args[is_classmethod:], **kwargs)

        return called

    return switch


def put(mutant: str) -> None:
    """A mutant in its function's place, here and in the processes that a test starts."""
    CHOSEN[mutant.split("__mutmut_")[0]] = mutant.rpartition(".")[2]
    trampoline.set_mutant_under_test(mutant)


def rows(path: Path) -> list[dict]:
    return list(map(json.loads, path.read_text("utf-8").splitlines())) if path.exists() else []


def append(path: Path, row: dict) -> None:
    with path.open("ab", buffering=0) as file:  # a line at once, for others write there too
        file.write(json.dumps(row).encode() + b"\n")


def outcomes(sample: dict[str, list[str]]) -> dict[str, dict]:
    """The mutants of a sample that are decided; one made anew may have an old one's name."""
    return {row["name"]: row for row in rows(OUTCOMES) if row["change"] == sample.get(row["name"])}


class Driver:
    """Runs what pytest has collected: once to record, then for each mutant in a fork."""

    def __init__(self, sample: dict[str, list[str]], options: argparse.Namespace):
        self.sample, self.options = sample, options
        self.each = partial(side_by_side, options.processes)

    def pytest_runtestloop(self, session: pytest.Session) -> bool | None:
        if session.testsfailed:
            return None  # pytest says what it could not collect
        self.items = {item.nodeid: item for item in session.items}
        caches = [x for x in gc.get_objects() if isinstance(x, _lru_cache_wrapper) and ours(x)]
        for function in caches:
            function.cache_clear()
        gc.freeze()
        known = {row["test"] for row in rows(REACH)}
        new = [item for name, item in self.items.items() if name not in known]
        files = [list(items) for _, items in groupby(new, key=lambda item: item.path)]
        self.each(recorded, [x[k : k + PORTION] for x in files for k in range(0, len(x), PORTION)])
        while True:
            known = {row["test"]: row for row in rows(REACH) if row["test"] in self.items}
            self.cost, self.reach = {name: row["cost"] for name, row in known.items()}, {}
            for name, row in known.items():
                for function in row["reach"] or []:
                    self.reach.setdefault(function, []).append(name)
            self.done = outcomes(self.sample)
            self.each(self.decide, list(enumerate(self.sample)))
            if not self.unreliable():
                return True

    def decide(self, drawn: tuple[int, str]) -> None:
        place, name = drawn
        met = self.done[name]["met"] if name in self.done else []
        if name in self.done and not (self.options.again and survived(self.done[name])):
            return
        tests = set(self.reach.get(name.split("__mutmut_")[0], [])) - set(met)
        tests = sorted(tests, key=self.cost.__getitem__)
        spent = zip(tests, accumulate(self.cost[test] for test in tests), strict=True)
        tests = [test for test, total in spent if total < self.options.seconds]
        found = outcome(name, [self.items[test] for test in tests], self.cost)
        more = {"change": self.sample[name], "met": met + tests, "drawn": place}
        append(OUTCOMES, found | more)

    def unreliable(self) -> list[str]:
        """The killers that fail without a mutant too: they are left out from now on, and what they
        killed is undecided."""
        done = outcomes(self.sample)
        killers = {row["test"] for row in done.values() if not survived(row)} & {*self.cost}
        killers, found = sorted(killers, key=self.cost.__getitem__), []
        while killers:
            said, last = attempt("", [self.items[test] for test in killers], self.cost, 5)
            if said == "survived":
                break
            killers = killers[killers.index(last) + 1 :]
            found.append(last)
            append(REACH, {"test": last, "cost": self.cost[last], "reach": None})
        left = [row for row in rows(OUTCOMES) if row["test"] not in found]
        OUTCOMES.write_text("".join(json.dumps(row) + "\n" for row in left), encoding="utf-8")
        return found


def survived(row: dict) -> bool:
    return row["outcome"] == "survived"


def side_by_side(processes: int, work: Callable, jobs: list) -> None:
    """Each job in one of so many processes, in their order."""
    turn, children = Value("i", 0), []
    for _ in range(processes):
        child = os.fork()
        children.append(child)
        if not child:
            try:
                while (n := following(turn)) < len(jobs):
                    work(jobs[n])
                os._exit(0)
            finally:
                os._exit(1)
    try:
        failed = [child for child in children if os.waitpid(child, 0)[1]]
    except KeyboardInterrupt:
        for child in children:
            with suppress(ProcessLookupError):
                os.kill(child, signal.SIGTERM)
        raise
    assert not failed, f"{len(failed)} of {processes} processes broke off"


def following(turn) -> int:
    with turn.get_lock():
        turn.value += 1
        return turn.value - 1


def ours(function) -> bool:
    return function.__module__.split(".")[0] in ("helpers", "tests")


def forked(mutant: str, run: Callable[[IO[str]], None]) -> tuple[list[str], int]:
    """What `run` wrote in a process of its own with this mutant, and the signal that ended it."""
    reading, writing = os.pipe()
    child = os.fork()
    if not child:
        os.setsid()
        for stream in (1, 2):
            os.dup2(os.open(os.devnull, os.O_WRONLY), stream)
        resource.setrlimit(resource.RLIMIT_DATA, (MEMORY, MEMORY))
        put(mutant)
        with suppress(BaseException), open(writing, "w", buffering=1, encoding="utf-8") as out:
            run(out)
        os._exit(0)
    os.close(writing)
    try:
        with open(reading, encoding="utf-8") as lines:
            written = lines.read().splitlines()
        status = os.waitpid(child, 0)[1]
    finally:
        with suppress(ProcessLookupError):
            os.killpg(child, signal.SIGKILL)
    return written, os.WTERMSIG(status) if os.WIFSIGNALED(status) else 0


def outcome(name: str, tests: list, cost: dict[str, float]) -> dict:
    """What became of a mutant, and the last test that it met. One that ran out of time goes on from
    that test with five times the time: it is in an endless loop, or only slow."""
    found, last = attempt(name, tests, cost, 1)
    if found == "timeout":
        again = next(i for i, test in enumerate(tests) if test.nodeid == last)
        found, last = attempt(name, tests[again:], cost, 5)
    return {"name": name, "outcome": found, "test": last}


def attempt(name: str, tests: list, cost: dict[str, float], patience: int) -> tuple[str, str]:
    """killed, survived, timeout or crashed, and the last test that ran."""

    def run(out: IO[str]) -> None:
        for item, following in zip_longest(tests, tests[1:]):
            print(item.nodeid, file=out)
            limit = patience * (GRACE + 5 * cost[item.nodeid])
            signal.setitimer(signal.ITIMER_PROF, limit)
            signal.setitimer(signal.ITIMER_REAL, 60 * limit)
            item.config.hook.pytest_runtest_protocol(item=item, nextitem=following)
            if item.session.testsfailed:
                print("killed", file=out)
                return
        print("survived", file=out)

    lines, ended = forked(name, run)
    *_, last = ["", *(line for line in lines if line not in ("killed", "survived"))]
    if ended in (signal.SIGPROF, signal.SIGALRM):
        return "timeout", last
    return lines[-1] if lines and lines[-1] in ("killed", "survived") else "crashed", last


def recorded(items: list[pytest.Item]) -> None:
    """Which functions each test reaches, or None where it fails, and its seconds of processor. In a
    fork, for what one file has computed and kept, another would not reach."""

    def run(out: IO[str]) -> None:
        for item, following in zip_longest(items, items[1:]):
            HITS.clear()
            failed, before = item.session.testsfailed, sum(os.times()[:4])
            item.config.hook.pytest_runtest_protocol(item=item, nextitem=following)
            reach = None if item.session.testsfailed > failed else sorted(HITS)
            cost = sum(os.times()[:4]) - before
            print(json.dumps({"test": item.nodeid, "cost": cost, "reach": reach}), file=out)

    for line in forked("", run)[0]:
        append(REACH, json.loads(line))


def report(decided: dict[str, dict]) -> None:
    """What survived, with its change, a line for each module, and the score."""
    counts = defaultdict(Counter)
    for name, row in decided.items():
        counts[name.rsplit(".", 1)[0]][row["outcome"]] += 1
        if row["outcome"] == "survived":
            print(f"{name}, {len(row['met'])} tests", *row["change"], sep="\n    ")
    for module, count in [*sorted(counts.items()), ("all", sum(counts.values(), Counter()))]:
        print(f"{module:32}", *(f"{n} {what}" for what, n in count.most_common()), sep="  ")
    low, high = interval(count.total() - count["survived"], count.total())
    print(f"With 95 % confidence the tests kill {low:.1%} to {high:.1%} of all mutants.")


def interval(killed: int, tried: int) -> tuple[float, float]:
    """Wilson's 95 % interval of a share."""
    z, share = 1.96, killed / tried
    middle = share + z**2 / (2 * tried)
    half = z * (share * (1 - share) / tried + (z / (2 * tried)) ** 2) ** 0.5
    return (middle - half) / (1 + z**2 / tried), (middle + half) / (1 + z**2 / tried)


if __name__ == "__main__":
    main()
