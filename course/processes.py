"""Start processes that share work and that end with the process which started them."""

import multiprocessing
import os
import threading
from concurrent.futures import ProcessPoolExecutor

START_METHOD = "forkserver" if "forkserver" in multiprocessing.get_all_start_methods() else "spawn"


def make_pool(jobs: int, module: str) -> ProcessPoolExecutor:
    """Make a pool of processes.

    Args:
        jobs: Number of processes; 0 for one for each processor.
        module: Module of the work, imported once for all processes.
    """
    if START_METHOD == "forkserver":
        multiprocessing.set_forkserver_preload([module])
    context = multiprocessing.get_context(START_METHOD)
    jobs = jobs or os.cpu_count() or 1
    return ProcessPoolExecutor(jobs, mp_context=context, initializer=_end_with_parent)


def _end_with_parent() -> None:
    """End this process as soon as its parent ends, even by a signal."""

    def wait() -> None:
        if (parent := multiprocessing.parent_process()) is not None:
            parent.join()
            os._exit(1)

    threading.Thread(target=wait, daemon=True).start()
