"""Running a notebook that a stranger wrote, apart from everything else.

First choice is not to run it: an `answers.json` beside it is read instead. Where it must be run,
this module runs it in bubblewrap (its own namespaces: no network, no files but Python's and the
notebook), with limits of time, memory, file size and output around it.

What that does not protect from: holes in the kernel, the sum of the memory of 256 processes (the
limit is for each), reading whatever is mounted (Python, the packages, the notebook itself), and a
notebook that prints whatever it likes; its output is only ever read as JSON and judged outside,
where the key is.
"""

import contextlib
import json
import os
import shutil
import signal
import subprocess
import sys
import tempfile
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any, Literal

import helpers
from helpers.inputs import ArmError, one_of

Apart = Literal["bubblewrap", "process", "nothing"]

_SIZE = 5_000_000  # bytes: a notebook that is larger is not read, output beyond it is cut
_MARK = "the answers of this homework:"  # before the JSON in the last cell's output


@dataclass(frozen=True)
class Limits:
    """Seconds for a notebook and for one of its cells, and bytes of memory for each process."""

    notebook: int = 120
    cell: int = 30
    memory: int = 4 * 2**30


@dataclass(frozen=True)
class Ran:
    """What came of a notebook: its answers, or words about what went wrong."""

    answers: dict[str, Any] | None
    trouble: str = ""


def best_apart() -> Apart:
    """ "bubblewrap" where it is installed and works, else "nothing"; a probe decides, not a
    version.
    """
    if not all(shutil.which(program) for program in ("bwrap", "prlimit", "setpriv")):
        return "nothing"
    as_root = os.geteuid() == 0
    namespaces, nobody = (_ROOTS_NAMESPACES, _as_nobody()) if as_root else (_NAMESPACES, [])
    probe = ["bwrap", *namespaces, "--ro-bind", "/", "/", "--proc", "/proc", *nobody, "true"]
    done = subprocess.run(probe, capture_output=True, timeout=20)
    return "bubblewrap" if done.returncode == 0 else "nothing"


def run(
    notebook: Path, apart: Apart, limits: Limits | None = None, *, as_root: bool = False
) -> Ran:
    """Execute a copy of a notebook and read the answers that its names hold at the end.

    Args:
        notebook: the file as handed in; it is not changed.
        apart: "bubblewrap", or "process" for a process of its own with limits and the rights of
            whoever grades, or "nothing", which runs nothing.
        limits: of time and memory.
        as_root: lets "process" run for the superuser, for whom limits of processes do not hold.

    Raises ArmError for an `apart` of another name. A notebook that is broken, endless or hostile
    raises nothing: the trouble is told in the result.
    """
    one_of(apart, "apart", ("bubblewrap", "process", "nothing"))
    if apart == "nothing":
        return Ran(None, "it has no answers.json, and notebooks are not run without leave")
    if apart == "process" and hasattr(os, "geteuid") and os.geteuid() == 0 and not as_root:
        return Ran(None, "it has no answers.json, and the superuser runs no notebook unprotected")
    try:
        book = _with_last_cell(notebook)
    except ValueError as error:
        return Ran(None, str(error))
    with tempfile.TemporaryDirectory() as folder:
        copy = Path(folder) / "handed_in.ipynb"
        copy.write_bytes(json.dumps(book).encode())
        copy.chmod(0o444)  # nobody reads it
        return _read(_execute(copy, apart, limits or Limits()))


def read_notebook(path: Path) -> dict[str, Any]:
    """A notebook as data; raises ValueError, in words for the student, where the file holds
    none.
    """
    if path.is_symlink() or not path.is_file():
        raise ValueError(f"{path.name} is no ordinary file")
    if path.stat().st_size > _SIZE:
        raise ValueError(f"{path.name} has more than {_SIZE:,} bytes")
    try:
        book = json.loads(path.read_bytes())
        cells = [cell for cell in book["cells"] if cell["cell_type"] in ("code", "markdown", "raw")]
    except (ValueError, KeyError, TypeError, RecursionError):
        raise ValueError(f"{path.name} is no notebook") from None
    return {**book, "cells": cells}


def _with_last_cell(path: Path) -> dict[str, Any]:
    """The notebook, its outputs gone, with a cell at the end that prints what its names hold."""
    book = read_notebook(path)
    code = f"from helpers.course.answers import collected\nprint({_MARK!r} + collected(globals()))"
    cells = [{**c, "outputs": []} if c["cell_type"] == "code" else c for c in book["cells"]]
    last: dict = {
        "cell_type": "code",
        "execution_count": None,
        "metadata": {},
        "outputs": [],
        "source": code,
    }
    kernel = {"kernelspec": {"name": "python3", "display_name": "Python 3", "language": "python"}}
    return {"cells": [*cells, last], "metadata": kernel, "nbformat": 4, "nbformat_minor": 4}


def _execute(copy: Path, apart: Apart, limits: Limits) -> bytes:
    """The executed notebook as nbconvert prints it, cut at the size limit; empty where it
    failed.
    """
    python = sys.executable
    convert = [
        python,
        "-m",
        "nbconvert",
        "--to",
        "notebook",
        "--execute",
        "--allow-errors",
        "--stdout",
    ]
    convert += ["--log-level=ERROR", f"--ExecutePreprocessor.timeout={limits.cell}"]
    convert += ["--ExecutePreprocessor.interrupt_on_timeout=True"]
    inside = "/in.ipynb" if apart == "bubblewrap" else str(copy)
    prefix = _bubblewrap(copy) if apart == "bubblewrap" else _few_processes(_tasks_of_mine())
    command = [*_limited(limits), *prefix, *convert, inside]
    with tempfile.TemporaryDirectory() as home:
        own = None if apart == "bubblewrap" else _environment(home)
        process = subprocess.Popen(
            command, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL,
            env=own, cwd=home, start_new_session=True,
        )  # fmt: skip
        assert process.stdout is not None
        try:
            out = process.stdout.read(_SIZE + 1)
        finally:
            process.stdout.close()
            os.killpg(process.pid, signal.SIGKILL)  # one that has ended is there until `wait`
            process.wait()
    return out if len(out) <= _SIZE else b""


def _limited(limits: Limits) -> list[str]:
    """timeout and prlimit: seconds, processor seconds, memory, file size, open files."""
    if not (shutil.which("timeout") and shutil.which("prlimit")):
        raise ArmError("timeout and prlimit were not found; notebooks are run on Linux only")
    return [
        "timeout", "-k", "5", str(limits.notebook),
        "prlimit", f"--cpu={limits.notebook}", f"--as={limits.memory}", "--fsize=20971520",
        "--nofile=256", "--core=0",
    ]  # fmt: skip


def _few_processes(others: int = 0) -> list[str]:
    """prlimit's count of processes and threads, beyond those that the same user has anyway."""
    return ["prlimit", f"--nproc={256 + others}"]


def _tasks_of_mine(processes: Path = Path("/proc")) -> int:
    """Processes and threads that run under this user's name, which count against the same limit."""
    count = 0
    for process in processes.glob("[0-9]*"):
        with contextlib.suppress(OSError):  # it has ended meanwhile
            if process.stat().st_uid == os.getuid():
                count += len(os.listdir(process / "task"))
    return count


def _bubblewrap(copy: Path) -> list[str]:
    """A root of its own: the system's programs, Python, the packages, the notebook; all
    read-only.
    """
    as_root = os.geteuid() == 0
    words = ["bwrap", *(_ROOTS_NAMESPACES if as_root else _NAMESPACES), "--die-with-parent"]
    words += ["--new-session", "--ro-bind", "/usr", "/usr"]
    for folder in ("lib", "lib64", "bin"):
        if Path("/", folder).is_symlink():
            words += ["--symlink", f"usr/{folder}", f"/{folder}"]
        elif Path("/", folder).is_dir():
            words += ["--ro-bind", f"/{folder}", f"/{folder}"]
    words += ["--proc", "/proc", "--dev", "/dev", "--remount-ro", "/dev"]
    for folder in ("/run", "/tmp"):
        words += ["--perms", "1777", "--size", "67108864", "--tmpfs", folder]
    for path in _mounted():
        # Made by bubblewrap itself, the folders above would be for their owner only.
        for above in [*reversed(Path(path).parents)][1:]:
            words += ["--perms", "0755", "--dir", str(above)]
        words += ["--ro-bind", path, path]
    words += ["--ro-bind", str(copy), "/in.ipynb", "--remount-ro", "/", "--clearenv"]
    for name, value in _environment("/run").items():
        words += ["--setenv", name, value]
    words += ["--chdir", "/run"]
    return [*words, *(_as_nobody() if as_root else []), *_few_processes()]


# A namespace of users is what makes the others possible for an ordinary user, and the number of
# processes is counted in it. For the superuser no such number holds, in whatever namespace: the
# kernel asks who he is outside. So he needs none, and what he runs becomes nobody instead.
_NAMESPACES = ["--unshare-all", "--unshare-user", "--disable-userns", "--cap-drop", "ALL"]
_ROOTS_NAMESPACES = ["--unshare-pid", "--unshare-net", "--unshare-ipc", "--unshare-uts"]
_ROOTS_NAMESPACES += ["--unshare-cgroup-try", "--cap-drop", "ALL"]
for _capability in ("CAP_SETUID", "CAP_SETGID", "CAP_SETPCAP"):
    _ROOTS_NAMESPACES += ["--cap-add", _capability]


def _as_nobody() -> list[str]:
    """setpriv: a user without a name, rights or files, another one for each notebook that runs at
    the same time, so that they do not count for each other.
    """
    user = 2**30 + os.getpid()
    words = ["setpriv", f"--reuid={user}", f"--regid={user}", "--clear-groups"]
    return [*words, "--no-new-privs", "--inh-caps=-all", "--bounding-set=-all"]


def _mounted() -> Sequence[str]:
    """Where Python, its packages and the helpers lie, each once; secrets and sheets lie
    elsewhere.
    """
    package = str(Path(helpers.__file__).parent)
    folders = {sys.base_prefix, sys.prefix, package}
    return [f for f in sorted(folders) if not f"{f}/".startswith("/usr/")]


def _environment(home: str) -> dict[str, str]:
    """What a notebook sees of the environment: nothing of the grader's own."""
    return {
        "PATH": f"{Path(sys.executable).parent}:/usr/bin:/bin",
        "HOME": home,
        "TMPDIR": "/tmp" if home == "/run" else home,
        "PYTHONPATH": str(Path(helpers.__file__).parents[1]),
        "OPENBLAS_NUM_THREADS": "1",
        "MPLBACKEND": "Agg",
        "LANG": "C.UTF-8",
    }


def _read(executed: bytes) -> Ran:
    """The answers in the last cell's output, or why there are none."""
    try:
        cells = json.loads(executed)["cells"]
        printed = [o["text"] for o in cells[-1]["outputs"] if o.get("name") == "stdout"]
        text = "".join("".join(lines) for lines in printed)
    except (ValueError, KeyError, TypeError, IndexError, RecursionError):
        return Ran(None, "running it gave no result: too long, too large, or stopped by itself")
    if _MARK not in text:
        return Ran(None, "its kernel stopped before the end")
    try:
        answers = json.loads(text.split(_MARK)[-1])
    except (ValueError, RecursionError):
        return Ran(None, "its answers could not be read")
    if not isinstance(answers, dict):
        return Ran(None, "its answers could not be read")
    failed = sum(any(o.get("output_type") == "error" for o in c.get("outputs", [])) for c in cells)
    return Ran(answers, f"{failed} of its cells raised an error" if failed else "")
