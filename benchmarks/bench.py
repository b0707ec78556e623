"""Times the helpers against their peers, in turn, and prints a table: `make bench`, or `bench.py inverse` for one topic.

Each peer does the same work in its own best way. The programs run in turn, so that a change of the machine's speed
meets all of them, and the medians are compared. Before anything is timed, all results must agree.
"""

import platform
import statistics
import sys
import time
from collections.abc import Callable, Iterator
from dataclasses import dataclass

import inverse
import kinematics
import numpy as np
import statics
import tracing

TOPICS = (kinematics, statics, tracing, inverse)


@dataclass(frozen=True)
class Case:
    """One piece of work: our program and the peers', each a function without arguments, and how closely they must agree.

    `seen` turns a result into the numbers to compare, where results have another form or order.
    """

    name: str
    ours: Callable[[], np.ndarray]
    peers: dict[str, Callable[[], np.ndarray]]
    within: float
    rounds: int = 9
    seen: Callable[[object], np.ndarray] = np.asarray


def seconds(work: Callable[[], object]) -> float:
    start = time.perf_counter()
    work()
    return time.perf_counter() - start


def measured(case: Case) -> Iterator[str]:
    wanted = case.seen(case.ours())
    off = {
        name: float(np.abs(case.seen(work()) - wanted).max()) for name, work in case.peers.items()
    }
    for name, error in off.items():
        assert error <= case.within, f"{case.name}: {name} differs by {error:g}"
    works = {"ours": case.ours, **case.peers}
    times = {name: [] for name in works}
    for _ in range(case.rounds):
        for name, work in works.items():
            work()  # the peer before has taken the caches and the memory
            times[name].append(seconds(work))
    median = {name: statistics.median(t) for name, t in times.items()}
    for name in case.peers:
        ratio = median["ours"] / median[name]
        yield f"| {case.name} | {1e3 * median['ours']:.3g} | {name} | {1e3 * median[name]:.3g} | {ratio:.2f} | {off[name]:.0e} |"


if __name__ == "__main__":
    wanted = sys.argv[1:] or [topic.__name__ for topic in TOPICS]
    print(
        f"Python {platform.python_version()}, NumPy {np.__version__}, {platform.machine()}, medians\n"
    )
    print("| work | helpers (ms) | peer | peer (ms) | helpers / peer | largest difference |")
    print("|:--|--:|:--|--:|--:|--:|")
    for topic in (t for t in TOPICS if t.__name__ in wanted):
        for case in topic.cases(Case):
            for line in measured(case):
                print(line, flush=True)
