"""Mutation testing: make one thing wrong in helpers/ at a time, and count how often the tests
notice.

mutmut makes the mutants, in a copy called `mutants/`. One process imports all tests there; a fork
of it records which of them reach which function, and at what cost; a fork for each mutant of a
random sample then runs those that reach it, the cheapest first, until one fails. Each outcome goes
to mutants/outcomes.jsonl in the order drawn, so that a run can be broken off and gone on with.
`make mutants` runs it; tests/mutants.md tells the figures and explains survivors.
"""

import argparse
import gc
import json
import os
import pickle
import random
import re
import resource
import signal
import sys
from collections import Counter, defaultdict
from collections.abc import Callable, Iterable
from contextlib import chdir, suppress
from fnmatch import fnmatch
from functools import _lru_cache_wrapper, partial
from itertools import accumulate, islice, zip_longest
from pathlib import Path
from typing import IO
from zlib import crc32

import pytest
from hypothesis import Phase, settings
from mutmut import __main__ as mutmut
from mutmut.configuration import config
from mutmut.mutation import trampoline
from mutmut.mutation.data import SourceFileMutationData
from mutmut.mutation.diff_apply import get_diff_for_mutant

PLACE = Path("mutants").absolute()
OUTCOMES, REACH = PLACE / "outcomes.jsonl", PLACE / "reach.json"
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
    options = parser.parse_args()
    files = {n: p for n, p in made().items() if any(fnmatch(n, x) for x in options.names)}
    names = sorted(files)
    random.Random(options.seed).shuffle(names)
    changes = ((name, changed(name, files[name])) for name in names)
    telling = ((name, lines) for name, lines in changes if not idle(lines))
    driver = Driver(islice(telling, options.sample or None), options.seconds, options.again)
    # To shrink a counterexample costs a hundred times what it cost to find it.
    phases = [Phase.explicit, Phase.generate]
    settings.register_profile("mutants", settings.get_profile("ci"), phases=phases)
    os.environ |= {"OPENBLAS_NUM_THREADS": "1", "JUDGE_CASES": "20000"}
    os.chdir(PLACE)
    trampoline.set_mutant_under_test("")
    arguments = ["-qq", "--tb=native", "--assert=plain", "--rootdir=.", "-p", "no:cacheprovider"]
    arguments += ["--hypothesis-profile=mutants", *config().pytest_add_cli_args_test_selection]
    pytest.main(arguments, plugins=[driver])
    report(driver.decided)


def made() -> dict[str, Path]:
    """The name of each mutant and its file; they are made where the source is newer."""
    trampoline.set_mutant_under_test("mutant_generation")
    PLACE.mkdir(exist_ok=True)
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


def outcomes() -> dict[str, dict]:
    lines = OUTCOMES.read_text(encoding="utf-8").splitlines() if OUTCOMES.exists() else []
    return {row["name"]: row for row in map(json.loads, lines)}


class Driver:
    """Runs what pytest has collected: once to record, then for each mutant in a fork."""

    def __init__(self, sample: Iterable[tuple[str, list[str]]], seconds: float, again: bool):
        self.sample, self.seconds, self.again, self.decided = sample, seconds, again, {}

    def pytest_runtestloop(self, session: pytest.Session) -> bool:
        judge_words = sys.modules["tests.judge_words"]
        judge_words.answered = kept(judge_words.answered)
        items = {item.nodeid: item for item in session.items}
        caches = [x for x in gc.get_objects() if isinstance(x, _lru_cache_wrapper) and ours(x)]
        forget(caches)
        gc.freeze()
        known = json.loads(REACH.read_text(encoding="utf-8"))[0] if REACH.exists() else {}
        if any(test not in known for test in items):
            forked("stats", partial(record, items, caches))
        cost, reach = json.loads(REACH.read_text(encoding="utf-8"))
        done = outcomes()
        for name, lines in self.sample:
            met = done[name]["met"] if name in done else []
            if name not in done or (self.again and done[name]["outcome"] == "survived"):
                tests = set(reach.get(name.split("__mutmut_")[0], [])) & set(items)
                tests = sorted(tests - set(met), key=cost.__getitem__)
                spent = zip(tests, accumulate(cost[test] for test in tests), strict=True)
                tests = [test for test, total in spent if total < self.seconds]
                done[name] = outcome(name, [items[test] for test in tests], cost)
                done[name] |= {"change": lines, "met": met + tests}
                with OUTCOMES.open("a", encoding="utf-8") as file:
                    print(json.dumps(done[name]), file=file)
            self.decided[name] = done[name]
        return True


def kept(answered: Callable) -> Callable:
    """What the page answers, without a mutant: from a file once it was asked in this form."""
    form = crc32((PLACE / "tests/judge_words.mjs").read_bytes())

    def again(seed: int, part: tuple[str, int, int]) -> list:
        file = PLACE / f"answers-{form:x}-{seed}-{part[0]}-{part[1]}-{part[2]}.pickle"
        if not file.exists():
            mutant = trampoline.get_mutant_under_test()
            trampoline.set_mutant_under_test("")
            half = file.with_suffix(f".{os.getpid()}")
            half.write_bytes(pickle.dumps(answered(seed, part)))
            half.rename(file)
            trampoline.set_mutant_under_test(mutant)
        return pickle.loads(file.read_bytes())

    return again


def ours(function) -> bool:
    return function.__module__.split(".")[0] in ("helpers", "tests")


def forget(caches) -> None:
    for function in caches:
        function.cache_clear()


def forked(mutant: str, run: Callable[[IO[str]], None]) -> tuple[list[str], int]:
    """What `run` wrote in a process of its own with this mutant, and the signal that ended it."""
    reading, writing = os.pipe()
    child = os.fork()
    if not child:
        os.setsid()
        for stream in (1, 2):
            os.dup2(os.open(os.devnull, os.O_WRONLY), stream)
        resource.setrlimit(resource.RLIMIT_DATA, (MEMORY, MEMORY))
        trampoline.set_mutant_under_test(mutant)
        with suppress(BaseException), open(writing, "w", buffering=1, encoding="utf-8") as out:
            run(out)
        os._exit(0)
    os.close(writing)
    with open(reading, encoding="utf-8") as lines:
        written = lines.read().splitlines()
    status = os.waitpid(child, 0)[1]
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


def record(items: dict[str, pytest.Item], caches: list, out: IO[str]) -> None:
    """Which tests reach which function, and seconds of processor for each test that is new; one
    that fails here reaches nothing."""
    known = json.loads(REACH.read_text(encoding="utf-8")) if REACH.exists() else [{}, {}]
    hits, cost, reach, file = set(), known[0], defaultdict(list, known[1]), None
    trampoline.record_trampoline_hit = lambda name, caller=None: hits.add(name)
    new = [item for name, item in items.items() if name not in cost]
    for item, following in zip_longest(new, new[1:]):
        if item.path != file:
            forget(caches)
            file = item.path
        hits.clear()
        failed, before = item.session.testsfailed, sum(os.times()[:4])
        item.config.hook.pytest_runtest_protocol(item=item, nextitem=following)
        cost[item.nodeid] = sum(os.times()[:4]) - before
        if item.session.testsfailed > failed:
            continue
        for function in hits:
            reach[function].append(item.nodeid)
    REACH.write_text(json.dumps([cost, reach]), encoding="utf-8")


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
