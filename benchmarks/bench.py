"""Time the helpers against peer programs and write the book's appendix by `make bench`.

`bench.py inverse` prints one topic only. All topics take about three minutes on a quiet machine.
Each program does the same work in the fastest way that it offers. The programs take turns, so that
a change of the machine's speed affects all of them, and their median times are compared. Before
anything is timed, all results must agree.
"""

import os
import platform
import re
import statistics
import sys
import time
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from datetime import date
from importlib.metadata import version
from pathlib import Path
from types import ModuleType

import inverse
import kinematics
import numpy as np
import statics
import tracing

TOPICS = (kinematics, statics, tracing, inverse)
APPENDIX = Path(__file__).parents[1] / "book/benchmarks.md"


@dataclass(frozen=True)
class Case:
    """A task that the helpers and peer programs do.

    Attributes:
        name: Name of the task in the table.
        ours: Function of the helpers.
        peers: Functions of the peer programs by their label in the table.
        tolerance: Largest allowed difference between results.
        rounds: Number of rounds; in each, every program runs once.
        calls: Number of calls that a round times.
        comparable: Turns a result into an array, where programs return other forms or orders.
    """

    name: str
    ours: Callable[[], np.ndarray]
    peers: dict[str, Callable[[], np.ndarray]]
    tolerance: float
    rounds: int = 9
    calls: int = 1
    comparable: Callable[[object], np.ndarray] = np.asarray


def time_call(work: Callable[[], object], calls: int) -> float:
    """Return the mean time of a call in seconds."""
    start = time.perf_counter()
    for _ in range(calls):
        work()
    return (time.perf_counter() - start) / calls


def measure_case(case: Case) -> Iterator[str]:
    """Time one task, and yield its lines of the table.

    Raises AssertionError if a result differs from the helpers'.
    """
    expected = case.comparable(case.ours())
    differences = {
        name: float(np.abs(case.comparable(work()) - expected).max())
        for name, work in case.peers.items()
    }
    for name, error in differences.items():
        assert error <= case.tolerance, f"{case.name}: {name} differs by {error:g}"
    works = {"ours": case.ours, **case.peers}
    times = {name: [] for name in works}
    for _ in range(case.rounds):
        for name, work in works.items():
            work()  # fills the caches again, which the program before has emptied
            times[name].append(time_call(work, case.calls))
    median = {name: 1e3 * statistics.median(t) for name, t in times.items()}
    yield f"| {case.name} | **helpers** | {format_time(median['ours'])} | | |"
    for name in case.peers:
        ratio = median["ours"] / median[name]
        yield f"| | {name} | {format_time(median[name])} | {ratio:.2f} | {format_error(differences[name])} |"


def format_error(error: float) -> str:
    return f"{error:.0e}" if error else "0"


def format_time(milliseconds: float) -> str:
    """Format a number with three digits and no power of ten."""
    return f"{milliseconds:.0f}" if milliseconds >= 100 else f"{milliseconds:.3g}"


def measure_topics(topics: list[ModuleType]) -> Iterator[str]:
    """Time all tasks, and yield each line of the table as soon as it is known."""
    yield "| work | who, and called how | ms | helpers / peer | largest difference |"
    yield "|:--|:--|--:|--:|--:|"
    for topic in topics:
        for case in topic.list_cases(Case):
            yield from measure_case(case)


def format_appendix(lines: list[str]) -> str:
    """Return the text of the book's appendix."""
    versions = (f"{name} {version(name)}" for name in PEERS)
    machine = f"{read_processor_name()}, {os.cpu_count()} cores, {platform.system()}"
    return PAGE.format(
        machine=machine,
        load=os.getloadavg()[0],
        python=platform.python_version(),
        date=date.today().isoformat(),
        versions=", ".join(versions),
        table="\n".join(lines),
    )


def read_processor_name() -> str:
    """Return the processor's name on Linux."""
    cpu_info = Path("/proc/cpuinfo")
    names = (
        re.findall(r"model name\s*: (.*)", cpu_info.read_text(encoding="utf-8"))
        if cpu_info.exists()
        else []
    )
    return names[0] if names else platform.machine()


PEERS = (
    "numpy",
    "pin",
    "casadi",
    "mujoco",
    "jax",
    "roboticstoolbox-python",
    "eaik",
    "ur-analytic-ik",
)
PAGE = """---
myst:
  html_meta:
    description: The helpers timed against other programs in one run, with machine and date.
---

# Benchmarks

How fast are the helpers, measured against programs that people use? Each block is one piece of work, and each line says how a program was
called: as its users write it, and in the best way that we found. All did it in one run, in turn, each warm, and their results had to agree before
anything was timed. Times are medians of 3 to 31 calls; a ratio below 1 means that the helpers were faster.

{table}

Measured on {date} by `make bench`, on {machine} (load average {load:.1f}), with Python {python} and {versions}. Another machine gives other times and, less so, other ratios.

How the best ways are called:

- **CasADi**: its expression with zeros filled in and equal steps shared (`densify`, `cse`), mapped over blocks of 1 000, reading and writing NumPy's own memory
  (`Function.buffer`). Calling the mapped function with arrays, as most do, costs several times as much. A line more has gcc compile the same expression to
  machine code, which a book without a compiler cannot ask for.
- **JAX**: compiled (`jit`), in double precision, in two ways: `vmap` over 4 × 4 matrices, as it is usually written, and the entries of the whole batch one by
  one. Which is faster depends on the work.
- **Pinocchio** has a batch in Python for Newton and Euler's recursion, `rneaInParallel`, which at rest gives the gravity torques. Everything else of it, and
  **MuJoCo**, is a loop, with all that does not change taken out. In traces the last lines of Pinocchio also lock joint 3 in its own model and keep its
  signs, which leaves one call and one `solve` in each step of Euler. Newton's method takes the pose from the pass that gives the Jacobian.
- **roboticstoolbox**: `ETS.eval` takes batches and arrays in C, `ETS.fkine` wraps each result in an object.

The helpers are plain NumPy. They are quick where many configurations are computed in one call; a trace, too, is computed at all of its steps at once, wherever
rates are the plain inverse of the arm's own Jacobian. Machine code is faster where it does the same: CasADi's expressions compiled by gcc, and EAIK's C++ for all
branches of a structure, except the UR10e's. One configuration alone costs the interpreter up to a tenth of a millisecond, several times what Pinocchio and
MuJoCo take: a loop of your own around single configurations is faster with one of those.
"""


if __name__ == "__main__":
    start = time.perf_counter()
    names = sys.argv[1:] or [topic.__name__ for topic in TOPICS]
    lines = []
    for line in measure_topics([topic for topic in TOPICS if topic.__name__ in names]):
        print(line, flush=True)
        lines.append(line)
    if not sys.argv[1:]:
        APPENDIX.write_text(format_appendix(lines), encoding="utf-8")
    print(f"measured in {(time.perf_counter() - start) / 60:.1f} minutes")
